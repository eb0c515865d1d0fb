#include "exhibits/sdf_scenes/pruning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::scenes {
namespace {

/// Largest slope of a field (asserted by tests), and the relative rounding error of coordinates.
constexpr double steepest = 1 + 2e-6, rounding = 1e-12;

}  // namespace

Pruner::Pruner(const SceneProgram& program, const SceneWords& words, double tolerance)
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
    const double reach = radius * steepest + rounding * (1 + glm::length(center));
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

}  // namespace vitrine::scenes
