#include "exhibits/sdf_scenes/pruning.h"

#include "render/hash.h"
#include "render/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <unordered_map>

namespace vitrine::scenes {
namespace {

/// Largest slope of a field (asserted by tests), and the relative rounding error of coordinates.
constexpr double steepest = 1 + 2e-6, coordinateRounding = 1e-12;

}  // namespace

Pruner::Pruner(const SceneProgram& program, const SceneConstants& words, double tolerance)
    : program_(program), words_(words), tolerance_(tolerance), walk_(program, words.words, false),
      reach_(program.nodes().size()), entered_(program.nodes().size()), joints_(program.nodes().size())
{
}

/// Returns the largest distance between the points at which the children are evaluated for the center and for a point
/// at the distance `outside` from it.
double Pruner::reachInside(std::uint32_t index, double outside) const
{
    const ProgramNode& node = program_.nodes()[index];
    const NodeKind& kind = program_.kind(node);
    double reach = outside;
    if (node.scale != none) {
        const double* factor = words_.words.data() + node.scale;
        reach *= std::max({std::abs(factor[0]), std::abs(factor[1]), std::abs(factor[2])});
    }
    if (kind.copy) return std::numeric_limits<double>::infinity();
    // For a twist (an angle that grows along an axis), the slope at the center bounds how far points move apart. The
    // largest contribution is the center's own rotation, which is proportional to its distance from the axis.
    if (kind.place && kind.lipschitz) reach *= walk_.state(index).lipschitz;
    return reach;
}

/// Copies a repeater and all of its content without pruning.
void Pruner::copyRepeated(std::span<const Step> steps, std::size_t& i, const glm::dvec3& center)
{
    const std::size_t begin = i;
    const std::uint32_t repeater = steps[begin].node;
    while (true) {
        const bool last = steps[i].type == Step::Type::again && steps[i].node == repeater;
        const std::size_t next = walk_.advance(steps, i, center);
        if (last && next == i + 1) break;
        i = next;
    }
    const auto moved = static_cast<std::uint32_t>(kept_.size() - begin);  // Unsigned, modulo 2^32.
    for (std::size_t k = begin; k <= i; ++k) {
        kept_.push_back(steps[k]);
        if (steps[k].type == Step::Type::again) kept_.back().back += moved;
    }
    ++i;
}

/// Removes the kept steps from `from` to before `to`.
void Pruner::drop(std::size_t from, std::size_t to)
{
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(from), kept_.begin() + static_cast<std::ptrdiff_t>(to));
    const auto moved = static_cast<std::uint32_t>(to - from);
    for (std::size_t k = from; k < kept_.size(); ++k)
        if (kept_[k].type == Step::Type::again) kept_[k].back -= moved;
}

/// Removes all ranges of `dropped_` at once. Removing them one by one would be quadratic in the number of operands.
void Pruner::dropAll()
{
    if (dropped_.empty()) return;
    std::size_t to = dropped_.back().first;
    for (std::size_t r = dropped_.size(); r-- > 0;) {
        const std::size_t next = r > 0 ? dropped_[r - 1].first : kept_.size();
        for (std::size_t from = dropped_[r].second; from < next; ++from, ++to) {
            kept_[to] = kept_[from];
            if (kept_[to].type == Step::Type::again) kept_[to].back -= static_cast<std::uint32_t>(from - to);
        }
    }
    kept_.resize(to);
    dropped_.clear();
}

/// Removes everything that was joined before, so that the child of `step` is the first operand.
void Pruner::startWith(const Step& step)
{
    drop(entered_[step.node] + 1, entered_[step.child]);
    kept_.push_back({Step::Type::first, step.node, step.child});
    joints_[step.node].clear();
}

/// Joins a child and tests which operand can be removed. If the result is exactly one operand at the four extremes, it
/// is so everywhere in between: b lies beyond a convex function of a (or a beyond one of b). The effect and the weights
/// are also largest at one of the extremes.
void Pruner::combine(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = program_.kind(node);
    const double* v = words_.words.data() + node.numbers;
    const double a = walk_.state(step.node).distance;
    const double b = walk_.state(step.child).distance;
    const double reach = reach_[step.node];
    if (kind.lesserFrom && std::abs(a - b) - 2 * reach > kind.lesserFrom(v) * (1 + 1e-12) + 1e-12) {
        walk_.setDistance(step.node, std::min(a, b));
        if (a < b)
            kept_.resize(entered_[step.child]);
        else
            startWith(step);
        return;
    }
    Joint joint{entered_[step.child], kept_.size()};
    bool down = true, up = true, upOfFirst = true;
    for (const double x : {a - reach, a + reach})
        for (const double y : {b - reach, b + reach}) {
            const double result = kind.combine.cpu(x, y, v);
            joint.effect = std::max(joint.effect, std::abs(result - x));
            joint.effectOfFormer = std::max(joint.effectOfFormer, std::abs(result - y));
            down = down && result <= std::min(x, y);
            up = up && result >= std::max(x, y);
            upOfFirst = upOfFirst && result >= x;
        }
    const bool known = std::isfinite(reach);
    if (known && joint.effect == 0) {
        kept_.resize(joint.child);
    } else if (known && joint.effectOfFormer == 0) {
        startWith(step);
    } else {
        if (known) joint.moves = down ? Moves::down : up ? Moves::up : upOfFirst ? Moves::upOfFirst : Moves::neither;
        for (const double x : {a - reach, a + reach})
            for (const double y : {b - reach, b + reach})
                joint.formerShare = std::max(joint.formerShare, 1 - kind.share.cpu(x, y, v));
        kept_.push_back(step);
        joints_[step.node].push_back(joint);
    }
    walk_.setDistance(step.node, kind.combine.cpu(a, b, v));
}

/// Processes a shape as an operand. Returns false if the steps do not begin with one.
bool Pruner::operand(std::span<const Step> steps, const glm::dvec3& center)
{
    if (steps.size() < 4 || steps[1].type != Step::Type::shape) return false;
    const Step& join = steps[3];
    const bool joins = join.type == Step::Type::first || join.type == Step::Type::combine;
    if (!joins || join.child != steps[0].node) return false;
    entered_[join.child] = kept_.size();
    const double distance = walk_.operand(join.child, center);
    kept_.insert(kept_.end(), steps.begin(), steps.begin() + 3);
    if (join.type == Step::Type::combine) {
        combine(join);
    } else {
        kept_.push_back(join);
        walk_.setDistance(join.node, distance);
    }
    return true;
}

/// Removes operands whose effect is within the tolerance because later ones cover them, from the last to the first.
/// Without an operand, the intermediate result only moves toward smaller own weights in later joints. So the weights
/// found bound the effect.
void Pruner::leave(std::uint32_t index)
{
    std::vector<Joint>& joints = joints_[index];
    if (joints.empty()) return;
    const Moves moves = joints.front().moves;
    const bool alike = std::all_of(joints.begin(), joints.end(), [&](const Joint& j) { return j.moves == moves; });
    double share = alike && moves != Moves::neither ? 1 : std::numeric_limits<double>::infinity();
    const double least = tolerance_ / static_cast<double>(joints.size());
    dropped_.clear();  // Ranges from the last to the first, so that earlier indices stay valid.
    for (std::size_t k = joints.size(); k-- > 0 && std::isfinite(share);) {
        const Joint& joint = joints[k];
        if (moves != Moves::upOfFirst && joint.effectOfFormer * share <= least) {
            kept_[joint.combined].type = Step::Type::first;
            dropped_.emplace_back(entered_[index] + 1, joint.child);
            break;
        }
        if (joint.effect * share <= least)
            dropped_.emplace_back(joint.child, joint.combined + 1);
        else
            share *= joint.formerShare;
    }
    joints.clear();
    dropAll();
}

PrunedSteps Pruner::prune(std::span<const Step> steps, const glm::dvec3& center, double radius)
{
    PrunedSteps pruned;
    prune(steps, center, radius, pruned);
    return pruned;
}

void Pruner::prune(std::span<const Step> steps, const glm::dvec3& center, double radius, PrunedSteps& pruned)
{
    if (steps.empty()) {
        pruned = {};
        return;
    }
    kept_.clear();
    const double reach = radius * steepest + coordinateRounding * (1 + glm::length(center));
    for (std::size_t i = 0; i < steps.size();) {
        const Step& step = steps[i];
        const ProgramNode& node = program_.nodes()[step.node];
        if (step.type == Step::Type::enter) {
            if (operand(steps.subspan(i), center)) {
                i += 4;
                continue;
            }
            entered_[step.node] = kept_.size();
            joints_[step.node].clear();
            if (program_.kind(node).form == Form::repeater) {
                copyRepeated(steps, i, center);
                continue;
            }
        }
        if (step.type == Step::Type::leave) leave(step.node);
        if (step.type == Step::Type::combine) {
            combine(step);
            ++i;
            continue;
        }
        kept_.push_back(step);
        i = walk_.advance(steps, i, center);
        if (step.type == Step::Type::enter)
            reach_[step.node] = reachInside(step.node, node.parent == none ? reach : reach_[node.parent]);
    }
    pruned.steps.assign(kept_.begin(), kept_.end());
    pruned.distance = walk_.state(0).distance;
    pruned.shapes = static_cast<std::size_t>(
        std::count_if(kept_.begin(), kept_.end(), [](const Step& step) { return step.type == Step::Type::shape; }));
}

namespace {

/// Position and length of a list of steps in `GridCells::steps`.
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
    CellPruner(const SceneProgram& program, const SceneConstants& words, double tolerance, GridCells& into,
               std::vector<SceneCell>& cells, BudgetLeft& budget)
        : pruner_(program, words, tolerance), into_(into), cells_(cells), budget_(budget), size_(into.cellSize()),
          far_(cells.size() < fewCells ? 3 : 1)
    {
    }

    void prune(std::span<const Step> steps, const glm::ivec3& low, const glm::ivec3& high, std::size_t depth = 0)
    {
        while (left_.size() <= depth) left_.emplace_back();
        PrunedSteps& left = left_[depth];  // An element of a deque keeps its address.
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
        // The distance from the center of a large block is only a short step for most of its points, and small blocks
        // cost most: large blocks are therefore subdivided for longer.
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

    /// Takes over the results of another pruner for all cells from `from` on, which this one has not pruned.
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
    /// Cells are enlarged by this factor: float32 assigns some points to a cell that are just outside of it.
    static constexpr double wider = 1 + 1e-4;

    /// Fills cells that are all farther from any surface than they are wide.
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

    /// Returns the index of a list of steps; an equal list that is already stored is used again.
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

    static constexpr int largeSide = 8;  ///< Side of a block, in cells.

    Pruner pruner_;
    GridCells& into_;
    std::vector<SceneCell>& cells_;
    BudgetLeft& budget_;
    glm::dvec3 size_;
    double far_;  ///< A small block is empty if its distance from a surface is more than so many of its radii.
    std::deque<PrunedSteps> left_;                              ///< Remaining steps at each depth of the recursion.
    std::unordered_multimap<std::uint64_t, KnownList> listAt_;  ///< Stored lists, by their hashes.
    std::size_t lists_ = 0;
};

/// Includes the parts of a box that may contain a surface, subdividing it down to boxes of size `smallest`.
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

render::Box occupiedBox(const SceneProgram& program, const SceneConstants& words, std::span<const Step> steps,
                        const render::Box& box)
{
    render::Box found;
    if (steps.empty() || box.empty()) return found;
    Pruner pruner(program, words);
    const glm::dvec3 size = box.high - box.low;
    includeOccupied(pruner, steps, box, std::max({size.x, size.y, size.z}) / 64, found);
    return found;
}

std::size_t GridCells::cellAt(const glm::dvec3& p) const
{
    const glm::ivec3 at(glm::clamp(glm::floor((p - box.low) / cellSize()), glm::dvec3(0), glm::dvec3(count - 1)));
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(count.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(count.x) +
           static_cast<std::size_t>(at.x);
}

double GridCells::clearance(std::size_t cell, const glm::dvec3& p) const
{
    // float32 rounds a distance by up to 2^-24 of it.
    constexpr double certain = 1 - 1e-6;
    const auto i = static_cast<int>(cell);
    const glm::ivec3 at(i % count.x, i / count.x % count.y, i / (count.x * count.y));
    const glm::dvec3 center = box.low + cellSize() * (glm::dvec3(at) + 0.5);
    const double d = double{cells[cell].distance} * certain;
    return std::copysign(std::abs(d) - glm::distance(p, center), d);
}

GridCells pruneCells(const SceneProgram& program, const SceneConstants& words, std::span<const Step> steps,
                     const CellGrid& grid, double tolerance, const PruneBudget& budget)
{
    const auto& box = grid.box;
    const glm::ivec3 count = grid.count;
    BudgetLeft left(budget);
    GridCells cells;
    cells.box = box;
    cells.count = count;
    cells.cells.resize(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                       static_cast<std::size_t>(count.z));
    CellPruner pruner(program, words, tolerance, cells, cells.cells, left);
    const int axis = count.x >= count.y && count.x >= count.z ? 0 : count.y >= count.z ? 1 : 2;
    if (cells.cells.size() < fewCells) {
        pruner.prune(steps, glm::ivec3(0), count);
    } else {
        GridCells others;
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
