#include "exhibits/sdf_scenes/pruning.h"
#include "render/hash.h"
#include "render/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <unordered_map>

namespace vitrine::scenes {
namespace {

/// Steps as they stand in `SceneCells::steps`, from there on.
struct KnownList {
    std::uint32_t first = 0, count = 0;
};

constexpr std::size_t fewCells = 50'000;  ///< They take less time than a thread is worth.

std::uint64_t hashOf(std::span<const Step> steps)
{
    render::NumberHash hash(steps.size());
    for (const Step& step : steps) {
        hash.add(std::uint64_t{step.node} << 32U | step.child);
        hash.add(std::uint64_t{step.back} << 8U | static_cast<std::uint64_t>(step.type));
    }
    return hash.value();
}

bool isSame(const Step& a, const Step& b)
{
    return a.type == b.type && a.node == b.node && a.child == b.child && a.back == b.back;
}

/// Counts what all threads together have used of a budget.
class BudgetLeft {
public:
    explicit BudgetLeft(const PruneBudget& budget) : budget_(budget) {}

    void takeBytes(std::size_t bytes) { bytes_ += bytes; }
    void takeEvaluations(std::size_t evaluations) { evaluations_ += evaluations; }
    [[nodiscard]] bool isOver() const { return bytes_ > budget_.bytes || evaluations_ > budget_.evaluations; }

private:
    PruneBudget budget_;
    std::atomic<std::uint64_t> bytes_ = 0, evaluations_ = 0;
};

/// Splits a block of cells, along all axes in which it is long, until a part is one cell.
class CellPruner {
public:
    /// Writes lists and counts into one, and cells into another one of the same grid.
    CellPruner(const SceneProgram& program, const SceneWords& words, double tolerance, SceneCells& into,
               std::vector<SceneCell>& cells, BudgetLeft& budget)
        : pruner_(program, words, tolerance), into_(into), cells_(cells), budget_(budget), size_(into.cellSize()),
          far_(cells.size() < fewCells ? 3 : 1)
    {
    }

    void prune(std::span<const Step> steps, const glm::ivec3& low, const glm::ivec3& high, std::size_t depth = 0)
    {
        while (left_.size() <= depth) left_.emplace_back();
        PrunedSteps& left = left_[depth];  // Of a deque: it stays where it is.
        const glm::dvec3 half = 0.5 * size_ * glm::dvec3(high - low);
        const glm::dvec3 center = into_.box.low + size_ * glm::dvec3(low) + half;
        const double radius = glm::length(half) * wider;
        if (budget_.isOver()) return;
        const std::size_t before = pruner_.evaluations();
        pruner_.prune(steps, center, radius, left);
        budget_.takeEvaluations(pruner_.evaluations() - before);
        ++into_.looks;
        const glm::ivec3 sides = high - low;
        const int longest = std::max({sides.x, sides.y, sides.z});
        // A distance from the middle is a short step for most of a large block, and looking into small ones costs most.
        const double clear = far_ * (longest > largeSide ? 2 : 1) * radius;
        if (std::abs(left.distance) > clear + 0.5 * glm::length(size_) * wider && longest > 1) {
            fill(left.distance, center, low, high);
            return;
        }
        if (longest == 1) {
            addCell(left, low, radius);
            return;
        }
        glm::ivec3 parts(1);
        for (int axis = 0; axis < 3; ++axis)
            if (2 * sides[axis] > longest) parts[axis] = 2;
        for (int part = 0; part < 8; ++part) {
            const glm::ivec3 at(part & 1, part >> 1 & 1, part >> 2);
            if (at.x >= parts.x || at.y >= parts.y || at.z >= parts.z) continue;
            const glm::ivec3 from = low + sides * at / parts;
            prune(left.steps, from, low + sides * (at + 1) / parts, depth + 1);
        }
    }

    [[nodiscard]] std::size_t lists() const { return lists_; }
    [[nodiscard]] std::size_t evaluations() const { return pruner_.evaluations(); }

    /// What another one found in the cells from there on, which this one was not asked about.
    void take(const CellPruner& other, const glm::ivec3& from)
    {
        std::unordered_map<std::uint32_t, std::uint32_t> moved;
        for (const auto& [hash, list] : other.listAt_)
            moved[list.first] = listOf(std::span(other.into_.steps).subspan(list.first, list.count));
        for (int z = from.z; z < into_.count.z; ++z)
            for (int y = from.y; y < into_.count.y; ++y)
                for (int x = from.x; x < into_.count.x; ++x)
                    if (SceneCell& cell = cells_[indexOf({x, y, z})]; cell.count > 0) cell.first = moved.at(cell.first);
        into_.withSurface += other.into_.withSurface;
        into_.withSteps += other.into_.withSteps;
        into_.mostShapes = std::max(into_.mostShapes, other.into_.mostShapes);
        into_.meanShapes += other.into_.meanShapes;
        into_.evaluations += other.evaluations();
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
                    cells_[indexOf({x, y, z})].distance = static_cast<float>(std::copysign(sure, distance));
                }
    }

    [[nodiscard]] std::size_t indexOf(const glm::ivec3& at) const
    {
        return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(into_.count.y) +
                static_cast<std::size_t>(at.y)) *
                   static_cast<std::size_t>(into_.count.x) +
               static_cast<std::size_t>(at.x);
    }

    /// Where a list stands that may be there already.
    std::uint32_t listOf(std::span<const Step> steps)
    {
        const std::uint64_t hash = hashOf(steps);
        const auto [begin, end] = listAt_.equal_range(hash);
        for (auto known = begin; known != end; ++known) {
            const auto at = into_.steps.begin() + known->second.first;
            if (known->second.count == steps.size() && std::equal(steps.begin(), steps.end(), at, isSame))
                return known->second.first;
        }
        const auto first = static_cast<std::uint32_t>(into_.steps.size());
        listAt_.emplace(hash, KnownList{first, static_cast<std::uint32_t>(steps.size())});
        into_.steps.insert(into_.steps.end(), steps.begin(), steps.end());
        budget_.takeBytes(steps.size_bytes() + sizeof(KnownList));
        ++lists_;
        return first;
    }

    void addCell(const PrunedSteps& left, const glm::ivec3& at, double radius)
    {
        SceneCell& cell = cells_[indexOf(at)];
        cell.distance = static_cast<float>(left.distance);
        into_.withSurface += std::abs(left.distance) <= radius * (1 + 2e-6) + 1e-9;
        if (std::abs(left.distance) > 2 * radius) return;
        cell.first = listOf(left.steps);
        cell.count = static_cast<std::uint32_t>(left.steps.size());
        cell.shapes = static_cast<std::uint32_t>(left.shapes);
        ++into_.withSteps;
        into_.mostShapes = std::max(into_.mostShapes, left.shapes);
        into_.meanShapes += static_cast<double>(left.shapes);
    }

    static constexpr int largeSide = 8;  ///< Of a block, in cells.

    Pruner pruner_;
    SceneCells& into_;
    std::vector<SceneCell>& cells_;
    BudgetLeft& budget_;
    glm::dvec3 size_;
    double far_;                    ///< In small blocks, from so many times their reach on no surface is near.
    std::deque<PrunedSteps> left_;  ///< By depth.
    std::unordered_multimap<std::uint64_t, KnownList> listAt_;  ///< By hash.
    std::size_t lists_ = 0;
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
                      const render::Box& box, const glm::ivec3& count, double tolerance, const PruneBudget& budget)
{
    BudgetLeft left(budget);
    SceneCells cells;
    cells.box = box;
    cells.count = count;
    cells.cells.resize(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                       static_cast<std::size_t>(count.z));
    CellPruner pruner(program, words, tolerance, cells, cells.cells, left);
    const int axis = count.x >= count.y && count.x >= count.z ? 0 : count.y >= count.z ? 1 : 2;
    if (cells.cells.size() < fewCells) {
        pruner.prune(steps, glm::ivec3(0), count);
    } else {
        SceneCells others;
        others.box = box;
        others.count = count;
        CellPruner other(program, words, tolerance, others, cells.cells, left);
        glm::ivec3 middle = count, from(0);
        middle[axis] = from[axis] = count[axis] / 2;
        render::onThreads(2, [&](std::size_t thread) {
            thread == 0 ? pruner.prune(steps, glm::ivec3(0), middle) : other.prune(steps, from, count);
        });
        if (!left.isOver()) pruner.take(other, from);
        cells.looks += others.looks;
        if (left.isOver()) cells.evaluations += other.evaluations();
    }
    cells.whole = !left.isOver();
    cells.lists = pruner.lists();
    cells.evaluations += pruner.evaluations();
    if (cells.withSteps > 0) cells.meanShapes /= static_cast<double>(cells.withSteps);
    return cells;
}

}  // namespace vitrine::scenes
