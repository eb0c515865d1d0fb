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
    if (node.scale != noIndex) {
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

/// Determines how much the operands of a joint matter, if `a` and `b` each vary by up to `reach`: at the four extremes.
/// If the result is exactly one operand there, it is so everywhere in between: b lies beyond a convex function of a (or
/// a beyond one of b). The effect and the weights are also largest at one of the extremes.
void Pruner::weigh(Joint& joint, const NodeKind& kind, const double* v, double a, double b, double reach)
{
    bool down = true, up = true, upOfFirst = true;
    for (const double x : {a - reach, a + reach})
        for (const double y : {b - reach, b + reach}) {
            const double result = kind.combine.cpu(x, y, v);
            joint.effect = std::max(joint.effect, std::abs(result - x));
            joint.effectOfFormer = std::max(joint.effectOfFormer, std::abs(result - y));
            joint.formerShare = std::max(joint.formerShare, 1 - kind.share.cpu(x, y, v));
            down = down && result <= std::min(x, y);
            up = up && result >= std::max(x, y);
            upOfFirst = upOfFirst && result >= x;
        }
    if (std::isfinite(reach))
        joint.moves = down ? Moves::down : up ? Moves::up : upOfFirst ? Moves::upOfFirst : Moves::neither;
}

/// Joins a child and tests which operand can be removed.
void Pruner::combine(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = program_.kind(node);
    const double* v = words_.words.data() + node.numbers;
    const double a = walk_.state(step.node).distance;
    const double b = walk_.state(step.child).distance;
    const double reach = reach_[step.node];
    constexpr double never = std::numeric_limits<double>::infinity();
    const double lesserFrom = kind.lesserFrom ? kind.lesserFrom(v) * (1 + 1e-12) + 1e-12 : never;
    if (std::abs(a - b) - 2 * reach > lesserFrom) {
        walk_.setDistance(step.node, std::min(a, b));
        if (a < b)
            kept_.resize(entered_[step.child]);
        else
            startWith(step);
        return;
    }
    Joint joint{entered_[step.child], kept_.size()};
    const bool known = std::isfinite(reach);
    if (known && 2 * reach - std::abs(a - b) > lesserFrom) {
        // The usual case in large parts of a scene. Each operand is the result at one extreme, where it is the lesser
        // one by more than any blend changes the result elsewhere.
        joint.effect = 2 * reach + (a - b);
        joint.effectOfFormer = 2 * reach - (a - b);
        joint.formerShare = 1;
        joint.moves = Moves::down;
    } else {
        weigh(joint, kind, v, a, b, reach);
    }
    if (known && joint.effect == 0) {
        kept_.resize(joint.child);
    } else if (known && joint.effectOfFormer == 0) {
        startWith(step);
    } else {
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
            reach_[step.node] = reachInside(step.node, node.parent == noIndex ? reach : reach_[node.parent]);
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
        // Odd factors keep all bits of a number; their products are as good as two numbers, and mixed in half the time.
        const std::uint64_t what = std::uint64_t{step.node} << 32U | step.child;
        const std::uint64_t where = std::uint64_t{step.back} << 8U | static_cast<std::uint64_t>(step.type);
        hash.add(what * 0xD6E8FEB86659FD93ULL + where * 0xA0761D6478BD642FULL);
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

/// Smallest side of a block, in cells, that is found again after a change: smaller ones are quickly pruned again.
constexpr int leastKept = 4;
constexpr int mostCellsAcross = 1023;  ///< Limit for grids whose blocks are found again.

/// Returns the key of a block in `SplitBlocks`.
std::uint64_t keyOfBlock(const glm::ivec3& low, const glm::ivec3& high)
{
    std::uint64_t key = 0;
    for (const int at : {low.x, low.y, low.z, high.x, high.y, high.z}) key = key << 10U | static_cast<unsigned>(at);
    return key;
}

/// Calls `visit(from, to)` for the parts into which a block of cells is split: along all axes in which it is long.
template <typename Visit> void splitBlock(const glm::ivec3& low, const glm::ivec3& high, const Visit& visit)
{
    const glm::ivec3 sides = high - low;
    const int longest = std::max({sides.x, sides.y, sides.z});
    glm::ivec3 parts(1);
    for (int axis = 0; axis < 3; ++axis)
        if (2 * sides[axis] > longest) parts[axis] = 2;
    for (int part = 0; part < 8; ++part) {
        const glm::ivec3 at(part & 1, part >> 1 & 1, part >> 2);
        if (at.x >= parts.x || at.y >= parts.y || at.z >= parts.z) continue;
        visit(low + sides * at / parts, low + sides * (at + 1) / parts);
    }
}

/// Part of a grid, with the steps that matter in it.
struct BlockPart {
    std::vector<Step> steps;
    glm::ivec3 low, high;
};

constexpr std::size_t depthOfParts = 3;  ///< Up to 512 parts.

template <typename Visit> void forCells(const glm::ivec3& low, const glm::ivec3& high, const Visit& visit)
{
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) visit(glm::ivec3(x, y, z));
}

/// Splits a block of cells until a part is one cell.
class CellPruner {
public:
    /// Writes lists and counts into one, and cells into another one of the same grid.
    CellPruner(const SceneProgram& program, const SceneConstants& words, double tolerance, GridCells& into,
               std::vector<SceneCell>& cells, BudgetLeft& budget)
        : pruner_(program, words, tolerance), into_(into), cells_(&cells), budget_(budget), size_(into.cellSize()),
          far_(reachOfEmpty(into.count))
    {
    }
    /// Writes only the cells that a change reaches.
    CellPruner(const SceneProgram& program, const ChangedNumbers& numbers, double tolerance, GridCells& into,
               std::vector<std::pair<std::uint32_t, SceneCell>>& cells, BudgetLeft& budget)
        : pruner_(program, numbers.now, tolerance), into_(into), changed_(&numbers), changedCells_(&cells),
          budget_(budget), size_(into.cellSize()), far_(reachOfEmpty(into.count))
    {
    }

    /// Prunes a block and its parts. `later`: takes the parts at the depth `depthOfParts`, which are not pruned then.
    void prune(std::span<const Step> steps, const glm::ivec3& low, const glm::ivec3& high,
               std::vector<BlockPart>* later = nullptr, std::size_t depth = 0)
    {
        if (later && depth == depthOfParts) {
            later->push_back({{steps.begin(), steps.end()}, low, high});
            return;
        }
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
            if (changed_) forget(low, high);
            return;
        }
        if (longest == 1) {
            addCell(left, low, radius);
            return;
        }
        if (longest >= leastKept && !remember(left.steps, keyOfBlock(low, high))) return;
        splitBlock(low, high, [&](const glm::ivec3& from, const glm::ivec3& to) {
            prune(left.steps, from, to, later, depth + 1);
        });
    }

    [[nodiscard]] std::size_t lists() const { return lists_; }
    [[nodiscard]] std::size_t evaluations() const { return pruner_.evaluations(); }
    /// Blocks that are no longer split.
    [[nodiscard]] const std::vector<std::uint64_t>& forgotten() const { return forgotten_; }

    /// Takes over all results of another pruner, which has pruned these parts.
    void take(const CellPruner& other, std::span<const BlockPart> parts)
    {
        std::unordered_map<std::uint32_t, std::uint32_t> moved;
        for (const auto& [hash, list] : other.listAt_)
            moved[list.first] = listOf(std::span(other.into_.steps).subspan(list.first, list.count));
        const auto move = [&moved](SceneCell& cell) {
            if (cell.count > 0) cell.first = moved.at(cell.first);
        };
        if (changed_) {
            for (auto [index, cell] : *other.changedCells_) {
                move(cell);
                changedCells_->emplace_back(index, cell);
            }
        } else {
            for (const BlockPart& part : parts)
                forCells(part.low, part.high, [&](const glm::ivec3& at) { move((*cells_)[indexOf(at)]); });
        }
        into_.withSurface += other.into_.withSurface;
        into_.withSteps += other.into_.withSteps;
        into_.mostShapes = std::max(into_.mostShapes, other.into_.mostShapes);
        into_.meanShapes += other.into_.meanShapes;
        for (const auto& [key, hash] : other.into_.split) into_.split[key] = hash;
        forgotten_.insert(forgotten_.end(), other.forgotten_.begin(), other.forgotten_.end());
    }

private:
    /// Cells are enlarged by this factor: float32 assigns some points to a cell that are just outside of it.
    static constexpr double wider = 1 + 1e-4;

    static double reachOfEmpty(const glm::ivec3& count)
    {
        return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                           static_cast<std::size_t>(count.z) <
                       fewCells
                   ? 3
                   : 1;
    }

    /// Keeps the steps of a block that is split. Returns false if its cells are as they were: these steps matter in it
    /// as before, and none of their numbers has changed.
    bool remember(std::span<const Step> steps, std::uint64_t key)
    {
        const std::uint64_t hash = hashOf(steps);
        if (changed_) {
            const auto known = changed_->split.find(key);
            const auto isChanged = [this](const Step& step) { return changed_->nodes[step.node] != 0; };
            if (known != changed_->split.end() && known->second == hash &&
                std::none_of(steps.begin(), steps.end(), isChanged))
                return false;
        }
        into_.split[key] = hash;
        return true;
    }

    /// Notes that neither a block nor a part of it is split any longer.
    void forget(const glm::ivec3& low, const glm::ivec3& high)
    {
        const glm::ivec3 sides = high - low;
        const std::uint64_t key = keyOfBlock(low, high);
        if (std::max({sides.x, sides.y, sides.z}) < leastKept || !changed_->split.contains(key)) return;
        forgotten_.push_back(key);
        splitBlock(low, high, [this](const glm::ivec3& from, const glm::ivec3& to) { forget(from, to); });
    }

    void put(const glm::ivec3& at, const SceneCell& cell)
    {
        if (changedCells_)
            changedCells_->emplace_back(static_cast<std::uint32_t>(indexOf(at)), cell);
        else
            (*cells_)[indexOf(at)] = cell;
    }

    /// Fills cells that are all farther from any surface than they are wide.
    void fill(double distance, const glm::dvec3& center, const glm::ivec3& low, const glm::ivec3& high)
    {
        forCells(low, high, [&](const glm::ivec3& at) {
            const glm::dvec3 middle = into_.box.low + size_ * (glm::dvec3(at) + 0.5);
            const double sure = std::abs(distance) - glm::distance(middle, center);
            put(at, {.distance = static_cast<float>(std::copysign(sure, distance))});
        });
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
        SceneCell cell{.distance = static_cast<float>(left.distance)};
        into_.withSurface += std::abs(left.distance) <= radius * (1 + 2e-6) + 1e-9;
        if (std::abs(left.distance) <= 2 * radius) {
            cell.first = listOf(left.steps);
            cell.count = static_cast<std::uint32_t>(left.steps.size());
            cell.shapes = static_cast<std::uint32_t>(left.shapes);
            ++into_.withSteps;
            into_.mostShapes = std::max(into_.mostShapes, left.shapes);
            into_.meanShapes += static_cast<double>(left.shapes);
        }
        put(at, cell);
    }

    static constexpr int largeSide = 8;  ///< Side of a block, in cells.

    Pruner pruner_;
    GridCells& into_;
    std::vector<SceneCell>* cells_ = nullptr;
    const ChangedNumbers* changed_ = nullptr;  ///< Null: all cells are written.
    std::vector<std::pair<std::uint32_t, SceneCell>>* changedCells_ = nullptr;
    BudgetLeft& budget_;
    glm::dvec3 size_;
    double far_;  ///< A small block is empty if its distance from a surface is more than so many of its radii.
    std::deque<PrunedSteps> left_;                              ///< Remaining steps at each depth of the recursion.
    std::unordered_multimap<std::uint64_t, KnownList> listAt_;  ///< Stored lists, by their hashes.
    std::vector<std::uint64_t> forgotten_;
    std::size_t lists_ = 0;
};

/// Splits a box across its longest side. Returns the axis.
int splitBox(const render::Box& box, render::Box& lower, render::Box& upper)
{
    const glm::dvec3 half = box.halfSize();
    const int axis = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    lower = upper = box;
    lower.high[axis] = upper.low[axis] = box.center()[axis];
    return axis;
}

constexpr std::size_t fewSteps = 1'000;  ///< In parts of a box they take less time than a thread is worth.

/// Includes what was found in another part.
void include(OccupiedBox& found, const OccupiedBox& other)
{
    if (other.box.empty()) return;
    for (int i = 0; i < 3; ++i) {
        const auto low = static_cast<std::size_t>(2 * i);
        if (found.box.empty() || other.box.low[i] < found.box.low[i]) found.touching[low] = other.touching[low];
        if (found.box.empty() || other.box.high[i] > found.box.high[i])
            found.touching[low + 1] = other.touching[low + 1];
    }
    found.box.include(other.box.low);
    found.box.include(other.box.high);
    for (const auto& [path, hash] : other.split) found.split[path] = hash;
}

/// Finds the parts of a box that contain a surface, by splitting it down to boxes of size `smallest`.
class OccupiedFinder {
public:
    /// `former`: only parts that it does not contain are searched; null: all.
    OccupiedFinder(const SceneProgram& program, const SceneConstants& words, double smallest, const FormerBox* former)
        : program_(program), words_(words), pruner_(program, words), smallest_(smallest), former_(former)
    {
    }

    /// Includes the parts that may contain a surface. `path`: a bit for each half that led to `box`, after a 1.
    void include(std::span<const Step> steps, const render::Box& box, OccupiedBox& found, std::uint64_t path = 1)
    {
        if (!found.box.empty() && found.box.contains(box.low) && found.box.contains(box.high)) return;
        const PrunedSteps left = pruner_.prune(steps, box.center(), glm::length(box.halfSize()));
        if (isClear(left, box)) return;
        render::Box lower, upper;
        const int axis = splitBox(box, lower, upper);
        if (2 * box.halfSize()[axis] <= smallest_) {
            OccupiedBox part{.box = box};
            part.touching.fill(box);
            scenes::include(found, part);
            return;
        }
        if (path < leastForgottenPath_) {
            const std::uint64_t hash = hashOf(left.steps);
            if (isUnchanged(left.steps, hash, path)) return;
            found.split[path] = hash;
        }
        if (path >= leastPathOfOneThread_ || left.steps.size() < fewSteps) {
            include(left.steps, lower, found, 2 * path);
            include(left.steps, upper, found, 2 * path + 1);
            return;
        }
        OccupiedFinder other(program_, words_, smallest_, former_);
        OccupiedBox others{.box = found.box, .touching = found.touching};
        render::onThreads(2, [&](std::size_t thread) {
            thread == 0 ? include(left.steps, lower, found, 2 * path)
                        : other.include(left.steps, upper, others, 2 * path + 1);
        });
        scenes::include(found, others);
    }

    /// Returns whether `include` would find this part of a box.
    [[nodiscard]] bool finds(const render::Box& part, const render::Box& box, std::span<const Step> steps)
    {
        std::vector<Step> all(steps.begin(), steps.end());
        for (render::Box here = box;;) {
            PrunedSteps left = pruner_.prune(all, here.center(), glm::length(here.halfSize()));
            if (isClear(left, here)) return false;
            render::Box lower, upper;
            const int axis = splitBox(here, lower, upper);
            if (2 * here.halfSize()[axis] <= smallest_) return true;
            here = part.center()[axis] < here.center()[axis] ? lower : upper;
            all = std::move(left.steps);
        }
    }

private:
    static constexpr std::uint64_t leastForgottenPath_ = 1U << 15U;
    static constexpr std::uint64_t leastPathOfOneThread_ = 4;  ///< Up to four threads.

    /// Returns whether a part contains the same surfaces as before, which the former box contains.
    [[nodiscard]] bool isUnchanged(std::span<const Step> steps, std::uint64_t hash, std::uint64_t path) const
    {
        if (!former_) return false;
        const auto known = former_->found.split.find(path);
        return known != former_->found.split.end() && known->second == hash &&
               std::none_of(steps.begin(), steps.end(),
                            [this](const Step& step) { return former_->nodes[step.node] != 0; });
    }
    [[nodiscard]] static bool isClear(const PrunedSteps& left, const render::Box& box)
    {
        return left.distance > glm::length(box.halfSize()) * (1 + 2e-6) + 1e-9;
    }

    const SceneProgram& program_;
    const SceneConstants& words_;
    Pruner pruner_;
    double smallest_;
    const FormerBox* former_;
};

/// Returns whether all of these parts of a box contain a surface.
bool isTouched(const SceneProgram& program, const SceneConstants& words, std::span<const Step> steps,
               const render::Box& box, double smallest, std::span<const render::Box> parts)
{
    const std::size_t threads = steps.size() < fewSteps ? 1 : 2;
    std::atomic<bool> all = true;
    render::onThreads(threads, [&](std::size_t thread) {
        OccupiedFinder finder(program, words, smallest, nullptr);
        for (std::size_t i = thread; i < parts.size() && all; i += threads)
            if (!finder.finds(parts[i], box, steps)) all = false;
    });
    return all;
}

}  // namespace

OccupiedBox occupiedBox(const SceneProgram& program, const SceneConstants& words, std::span<const Step> steps,
                        const render::Box& box, const FormerBox* former)
{
    OccupiedBox found;
    if (steps.empty() || box.empty()) return found;
    const glm::dvec3 size = box.high - box.low;
    const double smallest = std::max({size.x, size.y, size.z}) / 64;
    if (former) {
        // If each side is still touched, nothing inside can be new.
        if (!former->found.box.empty() && isTouched(program, words, steps, box, smallest, former->found.touching)) {
            found = former->found;
            OccupiedFinder(program, words, smallest, former).include(steps, box, found);
            return found;
        }
    }
    OccupiedFinder(program, words, smallest, nullptr).include(steps, box, found);
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

namespace {

GridCells emptyCells(const CellGrid& grid)
{
    GridCells cells;
    cells.box = grid.box;
    cells.count = grid.count;
    return cells;
}

std::size_t cellsIn(const CellGrid& grid)
{
    return static_cast<std::size_t>(grid.count.x) * static_cast<std::size_t>(grid.count.y) *
           static_cast<std::size_t>(grid.count.z);
}

/// Number of threads that prune a grid: the same on every machine, because each counts its own lists for a budget. Few
/// cells take less time than a thread is worth.
std::size_t threadsFor(const CellGrid& grid)
{
    return cellsIn(grid) < fewCells ? 1 : 2;
}

/// Prunes a grid with one thread for each pruner. The first one has all results then.
void pruneWithThreads(std::deque<CellPruner>& pruners, std::span<const Step> steps, const CellGrid& grid,
                      const BudgetLeft& left)
{
    CellPruner& first = pruners.front();
    if (pruners.size() == 1) return first.prune(steps, glm::ivec3(0), grid.count);
    std::vector<BlockPart> parts;
    first.prune(steps, glm::ivec3(0), grid.count, &parts);
    // A change is often in one place: neighbors belong to different threads.
    std::vector<std::vector<BlockPart>> ofThread(pruners.size());
    for (std::size_t i = 0; i < parts.size(); ++i) ofThread[i % pruners.size()].push_back(std::move(parts[i]));
    render::onThreads(pruners.size(), [&](std::size_t thread) {
        for (const BlockPart& part : ofThread[thread]) pruners[thread].prune(part.steps, part.low, part.high);
    });
    if (left.isOver()) return;
    for (std::size_t i = 1; i < pruners.size(); ++i) first.take(pruners[i], ofThread[i]);
}

}  // namespace

GridCells pruneCells(const SceneProgram& program, const SceneConstants& words, std::span<const Step> steps,
                     const CellGrid& grid, double tolerance, const PruneBudget& budget)
{
    BudgetLeft left(budget);
    std::vector<SceneCell> cells(cellsIn(grid));
    std::vector<GridCells> made(threadsFor(grid), emptyCells(grid));
    std::deque<CellPruner> pruners;
    for (GridCells& into : made) pruners.emplace_back(program, words, tolerance, into, cells, left);
    pruneWithThreads(pruners, steps, grid, left);
    GridCells& all = made.front();
    all.cells = std::move(cells);
    all.whole = !left.isOver();
    all.lists = pruners.front().lists();
    for (const CellPruner& pruner : pruners) all.evaluations += pruner.evaluations();
    for (std::size_t i = 1; i < made.size(); ++i) all.looks += made[i].looks;
    if (all.withSteps > 0) all.meanShapes /= static_cast<double>(all.withSteps);
    if (std::max({grid.count.x, grid.count.y, grid.count.z}) > mostCellsAcross) all.split.clear();
    return std::move(all);
}

ChangedCells pruneChangedCells(const SceneProgram& program, const ChangedNumbers& numbers, std::span<const Step> steps,
                               const CellGrid& grid, double tolerance, const PruneBudget& budget)
{
    BudgetLeft left(budget);
    std::vector<GridCells> made(threadsFor(grid), emptyCells(grid));
    std::vector<std::vector<std::pair<std::uint32_t, SceneCell>>> cells(made.size());
    std::deque<CellPruner> pruners;
    for (std::size_t i = 0; i < made.size(); ++i)
        pruners.emplace_back(program, numbers, tolerance, made[i], cells[i], left);
    pruneWithThreads(pruners, steps, grid, left);
    ChangedCells changed;
    changed.whole = !left.isOver();
    for (const CellPruner& pruner : pruners) changed.evaluations += pruner.evaluations();
    changed.cells = std::move(cells.front());
    changed.steps = std::move(made.front().steps);
    changed.split = numbers.split;
    for (const std::uint64_t key : pruners.front().forgotten()) changed.split.erase(key);
    for (const auto& [key, hash] : made.front().split) changed.split[key] = hash;
    return changed;
}

}  // namespace vitrine::scenes
