#pragma once

#include "exhibits/kit/blue_noise.h"
#include "exhibits/paper_lanterns/lake_scene.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vitrine::test {

inline const paper_lanterns::PaperLanternsTable& lanternsTable()
{
    static const paper_lanterns::PaperLanternsTable table;
    return table;
}

/// Returns values with the waves of the reference and lanterns that fill their cells: the most difficult lattice.
inline ParameterValues sourceLake()
{
    const paper_lanterns::PaperLanternsTable& t = lanternsTable();
    ParameterValues values = t.initial();
    values.set(t.waveHeight, 1.0);
    values.set(t.waveSpeed, paper_lanterns::LakeSpeed::reference);
    values.set(t.crowding, 1.0);
    values.set(t.spacing, 4.0);
    values.set(t.lanterns, 40000);
    return values;
}

/// Returns the lake of these values at float64; only solid lanterns, no glowing points.
inline glsl::Lake lakeAtFloat64(const ParameterValues& values, double seconds)
{
    static const std::shared_ptr<const render::Texture> noise = blueNoise();
    glsl::Lake made;
    paper_lanterns::copyLake(made.lake, paper_lanterns::lakeBlock(lanternsTable(), values, seconds));
    made.lake.pointWidth = 1e9;
    made.lake.meanWidth = 1e9;
    made.lake.stepLimit = 512;
    made.blueNoise = noise->bytes.data();
    return made;
}

/// Returns all lanterns of a lattice.
inline std::vector<glsl::Lake::Lantern> everyLantern(glsl::Lake& lake)
{
    std::vector<glsl::Lake::Lantern> all;
    for (int y = 0; y < lake.lake.cells.y; ++y)
        for (int x = 0; x < lake.lake.cells.x; ++x) all.push_back(lake.lanternOfCell({x, y}));
    return all;
}

/// Returns the nearest of them along a ray. Each is marched by itself from end to end, without cells and bounds.
inline double nearestOfAll(glsl::Lake& lake, const std::vector<glsl::Lake::Lantern>& all,
                           const glsl::Lake::LanternRay& ray)
{
    double nearest = ray.to;
    for (const auto& l : all) {
        if (l.light < 0) continue;
        const glm::dvec3 off = l.place + glm::dvec3(0, 1, 0) - ray.origin;
        // A lantern reaches less than 2.2 m from its center.
        const double along = glm::dot(off, ray.direction);
        if (glm::dot(off, off) - along * along > 2.2 * 2.2 || along < -2.2 || along > nearest + 2.2) continue;
        const glm::dmat3 axes = lake.lakeFromLantern(l);
        for (double t = std::max(along - 2.2, ray.from); t < std::min(nearest, along + 2.2);) {
            const double d = lake.lanternField((ray.origin + ray.direction * t - l.place) * axes).distance;
            if (d < 1e-4) {
                nearest = t;
                break;
            }
            t += d;
        }
    }
    return nearest;
}

}  // namespace vitrine::test
