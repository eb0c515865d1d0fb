#include "exhibits/ice_cream/sprinkles.h"

#include "exhibits/ice_cream/ice_cream_cpu.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vitrine::ice_cream {
namespace {

using glm::dvec3;

constexpr double cellWidth = 0.025;  ///< Meters.
constexpr double listed = 0.008;     ///< Meters; sprinkles nearer to a cell than this are in its list.

/// Returns three random numbers of a sprinkle in [0, 1), different for each `draw`.
dvec3 drawn(int sprinkle, int seed, int draw)
{
    const glm::uvec3 bits =
        glsl::pcg3d(glm::uvec3(static_cast<std::uint32_t>(sprinkle), static_cast<std::uint32_t>(seed),
                               0x5eedU + static_cast<std::uint32_t>(draw)));
    return {glsl::unitFromBits(bits.x), glsl::unitFromBits(bits.y), glsl::unitFromBits(bits.z)};
}

/// Point where a ray meets the cream, and the normal there. There is none if the ray misses or meets the wafer.
struct Landing {
    dvec3 point, normal;
};
std::optional<Landing> landing(glsl::IceCream& solids, const dvec3& from, const dvec3& direction, double farthest)
{
    double t = 0;
    for (int step = 0; step < 200 && t < farthest; ++step) {
        const dvec3 p = from + direction * t;
        const double d = solids.iceCreamDistance(p);
        if (d < 1e-5) {
            if (solids.fieldPart != PART_CREAM && solids.fieldPart != PART_CREAM + 1) return {};
            constexpr double h = 1e-4;
            dvec3 slope;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 along(0);
                along[axis] = h;
                slope[axis] = solids.iceCreamLevel(p + along) - solids.iceCreamLevel(p - along);
            }
            const double length = glm::length(slope);
            if (!(length > 0)) return {};
            return Landing{p, slope / length};
        }
        t += d;
    }
    return {};
}

/// Places one sprinkle: it falls up to 16 times, slanting towards the axis. The first fall that lands on cream and not
/// under an overhang counts.
std::optional<Sprinkles::One> strew(glsl::IceCream& solids, const SprinkleSettings& settings, double low, double high,
                                    double outer, int sprinkle)
{
    for (int fall = 0; fall < 16; ++fall) {
        const dvec3 where = drawn(sprinkle, settings.seed, 2 * fall);
        const dvec3 how = drawn(sprinkle, settings.seed, 2 * fall + 1);
        const double angle = 2 * std::numbers::pi * where.x;
        const dvec3 direction = glm::normalize(dvec3(-std::cos(angle), -1.2 * where.z, -std::sin(angle)));
        const dvec3 axis(0, low + (high - low) * where.y, 0);
        const double way = 2 * outer / std::hypot(direction.x, direction.z);
        const auto found = landing(solids, axis - direction * way, direction, way);
        if (!found || found->normal.y < -0.3) continue;
        // Falls are uniform in height. Rejecting by radius makes them uniform in area.
        if (how.z * outer > std::hypot(found->point.x, found->point.z)) continue;
        const dvec3 across = glm::normalize(
            glm::cross(found->normal, std::abs(found->normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
        const double turn = 2 * std::numbers::pi * how.x;
        const dvec3 along = std::cos(turn) * across + std::sin(turn) * glm::cross(found->normal, across);
        const double radius = solids.shape.sprinkleRadius;
        const dvec3 center = found->point + found->normal * (0.5 * radius);  // A quarter of it is embedded.
        const double half = std::max(0.5 * settings.length - radius, 1e-4);
        return Sprinkles::One{glm::vec3(center - along * half), glm::vec3(center + along * half),
                              static_cast<int>(5 * how.y)};
    }
    return {};
}

/// Returns a lower bound of the distance between a box and a capsule.
double gap(const dvec3& low, const dvec3& high, const Sprinkles::One& one, double radius)
{
    constexpr int samples = 8;
    const dvec3 start(one.start), way = dvec3(one.finish) - start;
    double nearest = 1e9;
    for (int i = 0; i <= samples; ++i) {
        const dvec3 p = start + way * (static_cast<double>(i) / samples);
        nearest = std::min(nearest, glm::distance(p, glm::clamp(p, low, high)));
    }
    return nearest - 0.5 * glm::length(way) / samples - radius;
}

std::size_t indexOf(const Sprinkles& s, const glm::ivec3& at)
{
    return static_cast<std::size_t>((at.z * s.cells.y + at.y) * s.cells.x + at.x);
}

template <typename Visit> void eachCell(const glm::ivec3& low, const glm::ivec3& high, const Visit& visit)
{
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) visit(glm::ivec3(x, y, z));
}

/// Returns the sprinkles in the list of each cell.
std::vector<std::vector<int>> lists(const Sprinkles& s, double radius)
{
    std::vector<std::vector<int>> near(s.grid.size());
    for (std::size_t i = 0; i < s.all.size(); ++i) {
        const dvec3 reach(radius + listed);
        const dvec3 low = glm::min(dvec3(s.all[i].start), dvec3(s.all[i].finish)) - reach - dvec3(s.low);
        const dvec3 high = glm::max(dvec3(s.all[i].start), dvec3(s.all[i].finish)) + reach - dvec3(s.low);
        const auto cellOf = [&](const dvec3& p) {
            return glm::clamp(glm::ivec3(glm::floor(p / cellWidth)), glm::ivec3(0), s.cells - 1);
        };
        eachCell(cellOf(low), cellOf(high), [&](const glm::ivec3& at) {
            const dvec3 corner = dvec3(s.low) + cellWidth * dvec3(at);
            if (gap(corner, corner + cellWidth, s.all[i], radius) <= listed)
                near[indexOf(s, at)].push_back(static_cast<int>(i));
        });
    }
    return near;
}

/// Returns the number of cells between each cell and the nearest one with a list, along the axis on which they are
/// farthest apart. Two passes of a chamfer are exact for that metric (Rosenfeld and Pfaltz 1966).
std::vector<int> cellsToLists(const Sprinkles& s, const std::vector<std::vector<int>>& near)
{
    std::vector<int> apart(near.size(), 1 << 20);
    for (std::size_t i = 0; i < near.size(); ++i)
        if (!near[i].empty()) apart[i] = 0;
    const glm::ivec3 last = s.cells - 1;
    for (const bool back : {false, true})
        eachCell({0, 0, 0}, last, [&](const glm::ivec3& step) {
            const glm::ivec3 at = back ? last - step : step;
            int& here = apart[indexOf(s, at)];
            eachCell(glm::max(at - 1, glm::ivec3(0)), glm::min(at + 1, last),
                     [&](const glm::ivec3& beside) { here = std::min(here, apart[indexOf(s, beside)] + 1); });
        });
    return apart;
}

void fillGrid(Sprinkles& s, double radius)
{
    dvec3 low(1e9), high(-1e9);
    for (const Sprinkles::One& one : s.all) {
        low = glm::min(low, glm::min(dvec3(one.start), dvec3(one.finish)));
        high = glm::max(high, glm::max(dvec3(one.start), dvec3(one.finish)));
    }
    // The margin has two empty cells on every side.
    const double margin = radius + listed + 2 * cellWidth;
    s.low = glm::vec3(low - margin);
    s.cell = static_cast<float>(cellWidth);
    s.cells = glm::ivec3(glm::ceil((high - low + 2 * margin) / cellWidth));
    s.grid.assign(static_cast<std::size_t>(s.cells.x) * static_cast<std::size_t>(s.cells.y) *
                      static_cast<std::size_t>(s.cells.z),
                  {});
    const std::vector<std::vector<int>> near = lists(s, radius);
    const std::vector<int> apart = cellsToLists(s, near);
    for (std::size_t i = 0; i < near.size(); ++i) {
        s.grid[i].first = static_cast<std::int32_t>(s.ends.size() / 2);
        for (const int sprinkle : near[i]) {
            const Sprinkles::One& one = s.all[static_cast<std::size_t>(sprinkle)];
            s.ends.emplace_back(one.start, static_cast<float>(one.color));
            s.ends.emplace_back(one.finish, 0.0F);
        }
        s.grid[i].end = static_cast<std::int32_t>(s.ends.size() / 2);
        // A sprinkle that touches a cell is in its list. With k - 1 empty cells between, the distance is at least their
        // width.
        s.grid[i].clear = static_cast<float>(std::max(listed, (apart[i] - 1) * cellWidth) - 1e-6);
    }
}

}  // namespace

Sprinkles strewn(const IceCreamShape& shape, const SprinkleSettings& settings)
{
    glsl::IceCream solids;
    copyShape(solids.shape, shape);
    // Only the cream matters, and the wafer, to which nothing sticks.
    solids.shape.parts &= 3 << PART_CREAM | 31;
    double low = 1e9, high = -1e9, outer = 0.01;
    for (const CreamLayer& layer : shape.layers) {
        low = std::min(low, double{layer.hull.y} - double{layer.hull.z});
        high = std::max(high, double{layer.hull.y} + double{layer.hull.z});
        outer = std::max(outer, double{layer.hull.x});
    }
    Sprinkles s;
    for (int i = 0; i < settings.count; ++i)
        if (const auto one = strew(solids, settings, low, high, outer, i)) s.all.push_back(*one);
    if (!s.all.empty()) fillGrid(s, shape.sprinkleRadius);
    s.cellBytes = render::bytesOf(s.grid);
    s.endBytes = render::bytesOf(s.ends);
    return s;
}

}  // namespace vitrine::ice_cream
