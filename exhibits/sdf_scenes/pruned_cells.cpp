#include "exhibits/sdf_scenes/pruning.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>
#include <tuple>

namespace vitrine::scenes {
namespace {

using ListKey = std::vector<std::tuple<Step::Type, std::uint32_t, std::uint32_t, std::uint32_t>>;

/// Halves a block of cells along its longest side until it is one cell.
class CellPruner {
public:
    CellPruner(const SceneProgram& program, const SceneWords& words, double tolerance, SceneCells& into)
        : pruner_(program, words, tolerance), into_(into), size_(into.cellSize())
    {
    }

    void prune(std::span<const Step> steps, const glm::ivec3& low, const glm::ivec3& high)
    {
        const glm::dvec3 half = 0.5 * size_ * glm::dvec3(high - low);
        const glm::dvec3 center = into_.box.low + size_ * glm::dvec3(low) + half;
        const double radius = glm::length(half) * wider;
        const PrunedSteps left = pruner_.prune(steps, center, radius);
        const glm::ivec3 sides = high - low;
        if (std::abs(left.distance) > 3 * radius && sides != glm::ivec3(1)) {
            fill(left.distance, center, low, high);
            return;
        }
        if (sides == glm::ivec3(1)) {
            addCell(left, low, radius);
            return;
        }
        const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
        glm::ivec3 middle = high;
        middle[axis] = low[axis] + sides[axis] / 2;
        prune(left.steps, low, middle);
        glm::ivec3 from = low;
        from[axis] = middle[axis];
        prune(left.steps, from, high);
    }

    [[nodiscard]] std::size_t lists() const { return listAt_.size(); }

    /// What another one found in cells of the same grid that this one was not asked about.
    void take(const CellPruner& other)
    {
        std::map<std::uint32_t, std::uint32_t> moved;
        for (const auto& [key, first] : other.listAt_) {
            const auto at = static_cast<std::uint32_t>(into_.steps.size());
            const auto [found, isNew] = listAt_.try_emplace(key, at);
            const auto begin = other.into_.steps.begin() + static_cast<std::ptrdiff_t>(first);
            if (isNew) into_.steps.insert(into_.steps.end(), begin, begin + static_cast<std::ptrdiff_t>(key.size()));
            moved[first] = found->second;
        }
        for (std::size_t i = 0; i < into_.cells.size(); ++i) {
            const SceneCell& from = other.into_.cells[i];
            if (from.count == 0 && from.distance == 0) continue;
            into_.cells[i] = from;
            if (from.count > 0) into_.cells[i].first = moved.at(from.first);
        }
        into_.withSurface += other.into_.withSurface;
        into_.withSteps += other.into_.withSteps;
        into_.mostShapes = std::max(into_.mostShapes, other.into_.mostShapes);
        into_.meanShapes += other.into_.meanShapes;
    }

private:
    /// Points are found in a cell by float32, which brings some that are beside it.
    static constexpr double wider = 1 + 1e-4;

    /// Cells that are all farther from a surface than they are wide.
    void fill(double distance, const glm::dvec3& center, const glm::ivec3& low, const glm::ivec3& high)
    {
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) {
                    const glm::dvec3 at = into_.box.low + size_ * (glm::dvec3(x, y, z) + 0.5);
                    const double sure = std::abs(distance) - glm::distance(at, center);
                    into_.cells[indexOf({x, y, z})].distance = static_cast<float>(std::copysign(sure, distance));
                }
    }

    [[nodiscard]] std::size_t indexOf(const glm::ivec3& at) const
    {
        return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(into_.count.y) +
                static_cast<std::size_t>(at.y)) *
                   static_cast<std::size_t>(into_.count.x) +
               static_cast<std::size_t>(at.x);
    }

    void addCell(const PrunedSteps& left, const glm::ivec3& at, double radius)
    {
        SceneCell& cell = into_.cells[indexOf(at)];
        cell.distance = static_cast<float>(left.distance);
        into_.withSurface += std::abs(left.distance) <= radius * (1 + 2e-6) + 1e-9;
        if (std::abs(left.distance) > 2 * radius) return;
        ListKey key;
        for (const Step& step : left.steps) key.emplace_back(step.type, step.node, step.child, step.back);
        const auto [found, isNew] = listAt_.try_emplace(std::move(key), static_cast<std::uint32_t>(into_.steps.size()));
        if (isNew) into_.steps.insert(into_.steps.end(), left.steps.begin(), left.steps.end());
        cell.first = found->second;
        cell.count = static_cast<std::uint32_t>(left.steps.size());
        cell.shapes = static_cast<std::uint32_t>(left.shapes);
        ++into_.withSteps;
        into_.mostShapes = std::max(into_.mostShapes, left.shapes);
        into_.meanShapes += static_cast<double>(left.shapes);
    }

    Pruner pruner_;
    SceneCells& into_;
    glm::dvec3 size_;
    std::map<ListKey, std::uint32_t> listAt_;
};

/// Includes the halves of a box in which something may be, down to a size.
void includeOccupied(Pruner& pruner, std::span<const Step> steps, const render::Box& box, double smallest,
                     render::Box& found)
{
    if (!found.empty() && found.contains(box.low) && found.contains(box.high)) return;
    const glm::dvec3 half = box.halfSize();
    const double radius = glm::length(half);
    const PrunedSteps left = pruner.prune(steps, box.center(), radius);
    if (left.distance > radius * (1 + 2e-6) + 1e-9) return;
    const int axis = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    if (2 * half[axis] <= smallest) {
        found.include(box.low);
        found.include(box.high);
        return;
    }
    render::Box lower = box, upper = box;
    lower.high[axis] = upper.low[axis] = box.center()[axis];
    includeOccupied(pruner, left.steps, lower, smallest, found);
    includeOccupied(pruner, left.steps, upper, smallest, found);
}

}  // namespace

render::Box occupiedBox(const SceneProgram& program, const SceneWords& words, std::span<const Step> steps,
                        const render::Box& box)
{
    render::Box found;
    if (steps.empty() || box.empty()) return found;
    Pruner pruner(program, words);
    const glm::dvec3 size = box.high - box.low;
    includeOccupied(pruner, steps, box, std::max({size.x, size.y, size.z}) / 64, found);
    return found;
}

std::size_t SceneCells::cellAt(const glm::dvec3& p) const
{
    const glm::ivec3 at(glm::clamp(glm::floor((p - box.low) / cellSize()), glm::dvec3(0), glm::dvec3(count - 1)));
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(count.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(count.x) +
           static_cast<std::size_t>(at.x);
}

double SceneCells::clearance(std::size_t cell, const glm::dvec3& p) const
{
    // Through float32, a distance moves by a part in 2^24.
    constexpr double certain = 1 - 1e-6;
    const auto i = static_cast<int>(cell);
    const glm::ivec3 at(i % count.x, i / count.x % count.y, i / (count.x * count.y));
    const glm::dvec3 center = box.low + cellSize() * (glm::dvec3(at) + 0.5);
    const double d = double{cells[cell].distance} * certain;
    return std::copysign(std::abs(d) - glm::distance(p, center), d);
}

SceneCells pruneCells(const SceneProgram& program, const SceneWords& words, std::span<const Step> steps,
                      const render::Box& box, const glm::ivec3& count, double tolerance)
{
    SceneCells cells;
    cells.box = box;
    cells.count = count;
    cells.cells.resize(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                       static_cast<std::size_t>(count.z));
    CellPruner pruner(program, words, tolerance, cells);
    constexpr std::size_t fewCells = 50'000;  // In less time than a thread is worth.
    const int axis = count.x >= count.y && count.x >= count.z ? 0 : count.y >= count.z ? 1 : 2;
    if (cells.cells.size() < fewCells) {
        pruner.prune(steps, glm::ivec3(0), count);
    } else {
        SceneCells others = cells;
        CellPruner other(program, words, tolerance, others);
        glm::ivec3 middle = count, from(0);
        middle[axis] = from[axis] = count[axis] / 2;
        {
            const std::jthread beside([&] { other.prune(steps, from, count); });
            pruner.prune(steps, glm::ivec3(0), middle);
        }
        pruner.take(other);
    }
    cells.lists = pruner.lists();
    if (cells.withSteps > 0) cells.meanShapes /= static_cast<double>(cells.withSteps);
    return cells;
}

}  // namespace vitrine::scenes
