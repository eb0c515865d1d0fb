#include "exhibits/recording/way_around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace vitrine::recording {
namespace {

constexpr double gridStep = 0.25;
constexpr double walkingHeight = 1.65;
constexpr double farthestStart = 2.5;       ///< Meters from an end to a place where one can walk.
constexpr std::size_t mostCells = 100'000;  ///< The building has fewer.

using Cell = std::pair<int, int>;

glm::dvec3 placeOf(const Cell& cell)
{
    return {cell.first * gridStep, walkingHeight, cell.second * gridStep};
}

/// Returns whether a camera passes with a margin, so a smooth path near the line is free, too.
bool passesWithRoom(const Obstacles& obstacles, const glm::dvec3& from, const glm::dvec3& to)
{
    constexpr double room = 0.12;
    if (!obstacles.cameraPasses(from, to)) return false;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 aside(0);
        aside[axis] = room;
        if (!obstacles.cameraPasses(from + aside, to + aside) || !obstacles.cameraPasses(from - aside, to - aside))
            return false;
    }
    return true;
}

/// State of an A* search over cells.
struct Search {
    const Obstacles& obstacles;
    glm::dvec3 goal;
    std::map<Cell, double> traveled;
    std::map<Cell, Cell> cameFrom;
    std::priority_queue<std::pair<double, Cell>, std::vector<std::pair<double, Cell>>, std::greater<>> open;

    [[nodiscard]] bool reaches(const glm::dvec3& a, const glm::dvec3& b, bool withRoom) const
    {
        return withRoom ? passesWithRoom(obstacles, a, b) : obstacles.cameraPasses(a, b);
    }

    [[nodiscard]] double left(const glm::dvec3& p) const { return std::hypot(goal.x - p.x, goal.z - p.z); }

    void offer(const Cell& cell, double length)
    {
        const auto known = traveled.find(cell);
        if (known != traveled.end() && known->second <= length) return;
        traveled[cell] = length;
        open.emplace(length + left(placeOf(cell)), cell);
    }

    void begin(const glm::dvec3& from, bool withRoom)
    {
        const int reach = static_cast<int>(farthestStart / gridStep);
        const Cell middle(static_cast<int>(std::lround(from.x / gridStep)),
                          static_cast<int>(std::lround(from.z / gridStep)));
        for (int dz = -reach; dz <= reach; ++dz)
            for (int dx = -reach; dx <= reach; ++dx) {
                const Cell cell(middle.first + dx, middle.second + dz);
                const glm::dvec3 p = placeOf(cell);
                const double away = glm::length(p - from);
                if (away < farthestStart && obstacles.walks(p, p) && reaches(from, p, withRoom)) offer(cell, away);
            }
    }

    /// Returns the cell from which the goal can be reached straight; nothing if there is none.
    std::optional<Cell> run(bool withRoom)
    {
        while (!open.empty() && traveled.size() < mostCells) {
            const auto [estimate, cell] = open.top();
            open.pop();
            const glm::dvec3 p = placeOf(cell);
            const double length = traveled[cell];
            if (estimate > length + left(p) + 1e-9) continue;  // A shorter way to the cell was found meanwhile.
            if (left(p) < farthestStart && reaches(p, goal, withRoom)) return cell;
            for (int dz = -1; dz <= 1; ++dz)
                for (int dx = -1; dx <= 1; ++dx) {
                    const Cell next(cell.first + dx, cell.second + dz);
                    const double longer = length + gridStep * std::hypot(dx, dz);
                    const auto known = traveled.find(next);
                    if (known != traveled.end() && known->second <= longer) continue;
                    if (!obstacles.walks(p, placeOf(next))) continue;
                    offer(next, longer);
                    cameFrom[next] = cell;
                }
        }
        return std::nullopt;
    }
};

/// Returns cells from one reachable from `from` to one from which `to` is reachable; empty if there are none.
std::vector<glm::dvec3> cellsBetween(const Obstacles& obstacles, const glm::dvec3& from, const glm::dvec3& to,
                                     bool withRoom)
{
    Search search{obstacles, to, {}, {}, {}};
    search.begin(from, withRoom);
    const std::optional<Cell> last = search.run(withRoom);
    if (!last) return {};
    std::vector<glm::dvec3> places{placeOf(*last)};
    for (auto at = search.cameFrom.find(*last); at != search.cameFrom.end(); at = search.cameFrom.find(at->second))
        places.push_back(placeOf(at->second));
    std::reverse(places.begin(), places.end());
    return places;
}

}  // namespace

std::vector<glm::dvec3> wayAround(const Obstacles& obstacles, const glm::dvec3& from, const glm::dvec3& to,
                                  double stride)
{
    std::vector<glm::dvec3> places = cellsBetween(obstacles, from, to, true);
    if (places.empty()) places = cellsBetween(obstacles, from, to, false);
    if (places.empty()) return {};
    std::vector<glm::dvec3> corners{from, places.front()};
    for (std::size_t i = 1; i < places.size(); ++i)
        if (i + 1 == places.size() || !obstacles.walks(corners.back(), places[i + 1])) corners.push_back(places[i]);
    corners.push_back(to);
    std::vector<glm::dvec3> way;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const glm::dvec3 step = corners[i] - corners[i - 1];
        const int pieces = std::max(static_cast<int>(std::ceil(glm::length(step) / stride)), 1);
        for (int k = 1; k <= pieces; ++k) way.push_back(corners[i - 1] + step * (static_cast<double>(k) / pieces));
    }
    way.pop_back();  // The end itself is excluded.
    return way;
}

}  // namespace vitrine::recording
