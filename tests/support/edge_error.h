#pragma once

#include "tests/stability/fields.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace vitrine::test {

/// Returns the share of the pixel (±0.5) on the near side of a line. `distance` is from the center to the line, across
/// the direction of `angle`.
inline double covered(double angle, double distance)
{
    const double c = std::max(std::abs(std::cos(angle)), 1e-9);
    const double s = std::max(std::abs(std::sin(angle)), 1e-9);
    const auto square = [](double x) { return x > 0 ? x * x : 0; };
    const double from = distance + 0.5 * (c + s);
    return std::clamp((square(from) - square(from - c) - square(from - s) + square(from - c - s)) / (2 * c * s), 0.0,
                      1.0);
}

/// Returns the RMS error of the share that `n` samples (in ±0.5) estimate, over edges of all directions and positions.
inline double edgeError(int n, const std::function<glm::dvec2(int)>& sample)
{
    std::vector<glm::dvec2> positions;
    Random random(5);
    constexpr int edges = 8000;
    double squares = 0;
    for (int edge = 0; edge < edges; ++edge) {
        positions.clear();
        for (int i = 0; i < n; ++i) positions.push_back(sample(i));
        const double angle = random.number(0, 2 * std::numbers::pi);
        const double distance = random.number(-0.75, 0.75);
        const glm::dvec2 across(std::cos(angle), std::sin(angle));
        const auto inside = std::count_if(positions.begin(), positions.end(),
                                          [&](const glm::dvec2& p) { return glm::dot(p, across) < distance; });
        squares += std::pow(static_cast<double>(inside) / n - covered(angle, distance), 2);
    }
    return std::sqrt(squares / edges);
}

}  // namespace vitrine::test
