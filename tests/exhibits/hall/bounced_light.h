#pragma once

#include "exhibits/hall/hall_model.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vitrine::test {

// Reference for shaders/hall/bounced_air.comp, lib/air_light.glsl and hall/bounced_light.frag at float64.

/// Sums of sources on six sides of all points in the air, gray: [6 i + side].
using Air = std::vector<double>;

inline Air airOf(const hall::SunTransfer& transfer, const std::vector<hall::SunTransfer::Source>& sources)
{
    const render::Texture& picture = *transfer.picture();
    const auto width = static_cast<std::size_t>(picture.width);
    Air air(width, 0.0);
    for (const hall::SunTransfer::Source& source : sources)
        for (std::size_t i = 0; i < width; ++i) {
            const double code = picture.bytes[source.row * width + i] / 255.0;
            air[i] += code * code * transfer.scale(source.row) * source.light;
        }
    return air;
}

/// Returns the light of a sky of radiance 1 at the same points, gray.
inline Air skyInAir(const hall::SunTransfer& transfer)
{
    const std::size_t row = transfer.sourceCount();
    return airOf(transfer, {{row, 1.0 / 3}, {row + 1, 1.0 / 3}, {row + 2, 1.0 / 3}});
}

/// Returns the light on a surface with unit normal `n` at a place in world space, interpolated linearly between points.
inline double airOn(const hall::SunTransfer& transfer, const Air& air, const glm::dvec3& place, const glm::dvec3& n)
{
    const hall::SunTransfer::Grid& grid = transfer.grid();
    const glm::dvec3 last = glm::dvec3(grid.size - 1);
    const glm::dvec3 at = glm::clamp((place - grid.box.low) / (grid.box.high - grid.box.low), 0.0, 1.0) * last;
    const glm::ivec3 base = glm::min(glm::ivec3(at), grid.size - 2);
    const glm::dvec3 t = at - glm::dvec3(base);
    const std::array<int, 3> sides = {n.x < 0 ? 1 : 0, n.y < 0 ? 3 : 2, n.z < 0 ? 5 : 4};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - t, t, glm::dvec3(step));
        const glm::ivec3 p = base + step;
        const int point = (p.z * grid.size.y + p.y) * grid.size.x + p.x;
        for (int axis = 0; axis < 3; ++axis)
            sum += w.x * w.y * w.z * n[axis] * n[axis] *
                   air[static_cast<std::size_t>(6 * point + sides[static_cast<std::size_t>(axis)])];
    }
    return sum;
}

/// Returns the ratio of a surface's light to the air's, in the texel at atlas coordinates from 0 to 1.
inline glm::dvec3 surfaceShare(const hall::SunTransfer& transfer, const glm::dvec2& atlas)
{
    const render::Texture& picture = *transfer.surfaces();
    const glm::ivec2 texel(atlas * glm::dvec2(picture.width, picture.height));
    glm::dvec3 share(0);
    for (int c = 0; c < 3; ++c) {
        const double code =
            picture.bytes[static_cast<std::size_t>(3 * (texel.y * picture.width + texel.x) + c)] / 255.0;
        share[c] = code * code * transfer.surfaceScale();
    }
    return share;
}

}  // namespace vitrine::test
