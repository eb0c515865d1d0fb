#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vitrine::render {
namespace {

/// Returns the logarithm; 0 is replaced by half the smallest positive value.
double logAbove(double x, double smallestPositive)
{
    return std::log(x > 0 ? x : smallestPositive / 2);
}

}  // namespace

bool dominates(const CostAndError& a, const CostAndError& b)
{
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (!std::isfinite(points[i].cost) || !(points[i].error < best)) continue;
        best = points[i].error;
        front.push_back(i);
    }
    return front;
}

std::optional<std::size_t> knee(std::span<const CostAndError> points, std::span<const std::size_t> front)
{
    if (front.size() < 3) return std::nullopt;
    double smallestCost = std::numeric_limits<double>::infinity();
    double smallestError = smallestCost;
    for (const std::size_t i : front) {
        if (points[i].cost > 0) smallestCost = std::min(smallestCost, points[i].cost);
        if (points[i].error > 0) smallestError = std::min(smallestError, points[i].error);
    }
    const auto x = [&](std::size_t i) { return logAbove(points[i].cost, smallestCost); };
    const auto y = [&](std::size_t i) { return logAbove(points[i].error, smallestError); };
    const std::size_t first = front.front();
    const std::size_t last = front.back();
    const double dx = x(last) - x(first);
    const double dy = y(last) - y(first);
    const double length = std::hypot(dx, dy);
    std::optional<std::size_t> best;
    double furthest = 1e-9 * length;  // Tolerance: a bend smaller than the rounding error does not count.
    for (std::size_t k = 1; k + 1 < front.size(); ++k) {
        const double below = ((y(front[k]) - y(first)) * dx - (x(front[k]) - x(first)) * dy) / -length;
        if (below > furthest) {
            furthest = below;
            best = k;
        }
    }
    return best;
}

}  // namespace vitrine::render
