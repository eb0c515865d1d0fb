#include "exhibits/sdf_scenes/scene_program.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::scenes {
namespace {

/// Returns a rotation around z, then y, then x; radians. Its columns are the axes of the rotated space.
glm::dmat3 rotationOf(const double* angles)
{
    const glm::dmat4 one(1);
    return glm::dmat3(glm::rotate(one, angles[0], {1, 0, 0}) * glm::rotate(one, angles[1], {0, 1, 0}) *
                      glm::rotate(one, angles[2], {0, 0, 1}));
}

/// Converts a Phong material to the physically based model, and the other way round: with equal width of highlights and
/// equal strength of reflections.
void fillMaterial(const Record& record, const double* v, double* words)
{
    for (std::size_t i = 0; i < 3; ++i) words[i] = v[i];
    double* rest =
        words + 3;  // ambient, diffuse, specular, shininess, mirror, metalness, roughness, reflectance, index, ...
    if (record.kind->name == "phong") {
        std::copy(v + 3, v + 8, rest);
        const double mirror = v[7];
        rest[5] = mirror;
        rest[6] = mirror > 0 ? 0.02 : std::min(1.0, std::pow(2 / (v[6] + 2), 0.25));
        rest[7] = std::min(1.0, 0.5 * v[5] + 0.25);
        rest[8] = 1.5;
        return;
    }
    std::copy(v + 3, v + 9, rest + 5);
    const double alpha = std::max(v[4] * v[4], 0.01);
    rest[0] = 0.2;
    rest[1] = 1 - v[3];
    rest[2] = v[5];
    rest[3] = std::clamp(2 / (alpha * alpha) - 2, 1.0, 1e4);
    rest[4] = v[4] < 0.3 ? v[3] * (1 - v[4] / 0.3) : 0;
}

/// Writes center and half size of a box; infinite sides become long ones.
void writeBox(const render::Box& box, double* words)
{
    const glm::dvec3 far(1e9);
    const glm::dvec3 low = glm::clamp(box.low, -far, far);
    const glm::dvec3 high = glm::clamp(box.high, -far, far);
    for (int axis = 0; axis < 3; ++axis) {
        words[axis] = 0.5 * (low[axis] + high[axis]);
        words[axis + 3] = 0.5 * std::max(high[axis] - low[axis], 0.0);
    }
}

/// Returns the bounds of a rotated and translated box. An infinite side makes it infinite in every direction that it
/// may turn to.
render::Box placedBox(render::Box box, const double* words, const ProgramNode& node)
{
    if (box.empty()) return box;
    if (node.scale != noIndex) {
        const glm::dvec3 factor = 1.0 / glm::dvec3(words[node.scale], words[node.scale + 1], words[node.scale + 2]);
        box = {box.low * factor, box.high * factor};
    }
    if (node.rotate != noIndex) {
        render::Box turned{glm::dvec3(0), glm::dvec3(0)};
        for (int axis = 0; axis < 3; ++axis) {
            const double* column = words + node.rotate + 3 * axis;
            for (int i = 0; i < 3; ++i) {
                if (column[i] == 0) continue;  // 0 times infinity would be NaN.
                turned.low[i] += std::min(column[i] * box.low[axis], column[i] * box.high[axis]);
                turned.high[i] += std::max(column[i] * box.low[axis], column[i] * box.high[axis]);
            }
        }
        box = turned;
    }
    if (node.translate != noIndex) {
        const glm::dvec3 by(words[node.translate], words[node.translate + 1], words[node.translate + 2]);
        box = {box.low + by, box.high + by};
    }
    return box;
}

/// Replaces empty bounds, as of an intersection, by a single point.
Bounds withPlace(Bounds extent)
{
    if (!extent.box.empty()) return extent;
    for (int i = 0; i < 3; ++i) {
        const double middle = extent.box.center()[i];
        extent.box.low[i] = extent.box.high[i] = std::isfinite(middle) ? middle : 0;
    }
    return extent;
}

}  // namespace

SceneProgram::SceneProgram(std::shared_ptr<const Scene> scene) : scene_(std::move(scene))
{
    keepNodes();
    placeWords();
    writeSteps();
    findExactness();
}

void SceneProgram::keepNodes()
{
    const std::vector<Node>& all = scene_->nodes;
    std::vector<char> kept(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
        kept[i] = !all[i].hidden && (all[i].parent == noIndex || kept[all[i].parent]);
    // Children are stored after their parents, so the backward loop decides each before its parent.
    std::vector<char> hasChild(all.size(), 0);
    for (std::size_t i = all.size(); i-- > 0;) {
        const Node& node = all[i];
        if (kept[i] && node.kind->form != Form::shape) {
            const bool needsFirst = node.kind->name == "subtraction" && !kept[node.firstChild];
            kept[i] = hasChild[i] && !needsFirst;
        }
        if (kept[i] && node.parent != noIndex) hasChild[node.parent] = 1;
    }
    std::vector<std::uint32_t> programNode(all.size(), noIndex);
    std::vector<std::uint32_t> lastChild;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const std::uint32_t parent = all[i].parent == noIndex ? noIndex : programNode[all[i].parent];
        if (!kept[i] || (all[i].parent != noIndex && parent == noIndex)) continue;
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        programNode[i] = index;
        ProgramNode node;
        node.node = i;
        node.parent = parent;
        node.material = all[i].material;
        nodes_.push_back(node);
        lastChild.push_back(noIndex);
        if (parent == noIndex) continue;
        ++nodes_[parent].children;
        (lastChild[parent] == noIndex ? nodes_[parent].firstChild : nodes_[lastChild[parent]].next) = index;
        lastChild[parent] = index;
    }
}

void SceneProgram::placeWords()
{
    std::uint32_t word = 0;
    const auto take = [&](bool present, std::uint32_t words) {
        const std::uint32_t at = word;
        if (present) word += words;
        return present ? at : noIndex;
    };
    materialWords_.assign(scene_->materials.size(), noIndex);
    for (ProgramNode& node : nodes_) {
        const Node& of = scene_->nodes[node.node];
        if (of.kind->form == Form::shape && materialWords_[of.material] == noIndex)
            materialWords_[of.material] = take(true, wordsOfMaterial);
    }
    for (ProgramNode& node : nodes_) {
        const Node& of = scene_->nodes[node.node];
        node.translate = take(of.translate != noIndex, 3);
        node.rotate = take(of.rotate != noIndex, 9);
        node.scale = take(of.scale != noIndex, 4);
        node.numbers = take(true, static_cast<std::uint32_t>(of.kind->numbers()));
        take(of.kind->form == Form::repeater, numbersOfRepeatRange);
    }
    wordCount_ = word;
}

void SceneProgram::writeSteps()
{
    std::vector<std::uint32_t> entered(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        entered[i] = static_cast<std::uint32_t>(steps_.size());
        steps_.push_back({Step::Type::enter, i});
        if (nodes_[i].firstChild != noIndex) continue;
        steps_.push_back({Step::Type::shape, i});
        // Ends this node, and every ancestor whose last child ends with it.
        for (std::uint32_t done = i;;) {
            steps_.push_back({Step::Type::leave, done});
            const std::uint32_t parent = nodes_[done].parent;
            if (parent == noIndex) break;
            const Form form = kind(nodes_[parent]).form;
            if (form == Form::modifier)
                steps_.push_back({Step::Type::modify, parent, done});
            else if (form == Form::repeater)
                steps_.push_back({Step::Type::again, parent, done, entered[parent] + 1});
            else
                steps_.push_back(
                    {nodes_[parent].firstChild == done ? Step::Type::first : Step::Type::combine, parent, done});
            if (nodes_[done].next != noIndex) break;
            done = parent;
        }
    }
}

/// Determines which nodes are exact, from numbers that cannot change while the scene is drawn: a computed number may
/// have any value.
void SceneProgram::findExactness()
{
    const auto constant = [&](std::uint32_t number, double value) {
        return scene_->numbers[number].expression == noIndex && scene_->numbers[number].value == value;
    };
    std::vector<char> flat(nodes_.size(), 0);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        ProgramNode& node = nodes_[i];
        const Node& of = scene_->nodes[node.node];
        node.exactness = of.kind->exactness;
        if (of.kind->form == Form::operands && node.children == 1) node.exactness = Exactness::exact;
        bool flatChildren = true;
        for (std::uint32_t c = node.firstChild; c != noIndex; c = nodes_[c].next) {
            node.exactness = std::max(node.exactness, nodes_[c].exactness);
            flatChildren = flatChildren && flat[c];
        }
        if (of.kind->form == Form::shape) {
            std::vector<double> v(of.kind->numbers());
            for (std::size_t k = 0; k < v.size(); ++k) v[k] = scene_->numbers[of.numbers + k].value;
            flat[i] = of.kind->extent(v.data()).flat && of.kind->name != "plane";
        } else {
            flat[i] = flatChildren && of.kind->form == Form::operands;
        }
        if (of.kind->ofFlatChild && !flatChildren) node.exactness = Exactness::bound;
        const bool blends = of.kind->form == Form::operands && node.children > 1;
        if (blends && !constant(of.numbers + 1, 0)) node.exactness = Exactness::bound;
        if (of.rotate != noIndex) flat[i] = 0;
        if (of.scale == noIndex) continue;
        const double first = scene_->numbers[of.scale].value;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (!constant(of.scale + k, first)) node.exactness = Exactness::bound;
    }
}

SceneConstants SceneProgram::words(const std::vector<double>& numbers) const
{
    SceneConstants all;
    all.words.resize(wordCount_);
    std::vector<double>& words = all.words;
    for (std::size_t m = 0; m < materialWords_.size(); ++m) {
        if (materialWords_[m] == noIndex) continue;
        fillMaterial(scene_->materials[m], &numbers[scene_->materials[m].numbers], &words[materialWords_[m]]);
    }
    for (const ProgramNode& node : nodes_) {
        const Node& of = scene_->nodes[node.node];
        std::copy_n(numbers.begin() + of.numbers, of.kind->numbers(), words.begin() + node.numbers);
        normalizeDirections(of.kind->fields, words.data() + node.numbers);
        if (node.translate != noIndex) std::copy_n(numbers.begin() + of.translate, 3, words.begin() + node.translate);
        if (node.rotate != noIndex) {
            const glm::dmat3 turn = rotationOf(&numbers[of.rotate]);
            for (int column = 0; column < 3; ++column)
                for (int row = 0; row < 3; ++row)
                    words[node.rotate + static_cast<std::uint32_t>(3 * column + row)] = turn[column][row];
        }
        if (node.scale != noIndex) {
            const double* factors = &numbers[of.scale];
            for (std::uint32_t i = 0; i < 3; ++i) words[node.scale + i] = 1 / factors[i];
            words[node.scale + 3] = std::min({factors[0], factors[1], factors[2]});
        }
    }
    fillExtents(all);
    return all;
}

/// Returns the bounds of a node in its own space, from those of its children.
Bounds SceneProgram::extentInside(const SceneConstants& all, const Cover& cover, std::uint32_t i) const
{
    const ProgramNode& node = nodes_[i];
    const NodeKind& k = kind(node);
    const double* v = all.words.data() + node.numbers;
    const double level = cover.levels[i - cover.first];
    if (k.form == Form::shape) {
        Bounds own = k.extent(v);
        own.box = k.exactness == Exactness::bound && level > 0 ? endlessBox() : grown(own.box, level);
        return own;
    }
    Bounds inside = cover.extent(node.firstChild);
    inside.ballsFrom = Bounds().ballsFrom;
    if (k.extentOf) return k.extentOf(inside, v, level);
    for (std::uint32_t c = nodes_[node.firstChild].next; c != noIndex; c = nodes_[c].next)
        inside = k.extentOfTwo(inside, cover.extent(c));
    return inside;
}

/// Computes the numbers of a repeater that depend on the bounds of its child.
void SceneProgram::fillAsked(SceneConstants& all, const Cover& cover, std::uint32_t i) const
{
    const ProgramNode& node = nodes_[i];
    const NodeKind& k = kind(node);
    double* v = all.words.data() + node.numbers;
    const bool exactChild = nodes_[node.firstChild].exactness != Exactness::bound;
    const RepeatRange asked = k.asked(withPlace(cover.extent(node.firstChild)), exactChild, v);
    all.asked[i] = asked.times.x * asked.times.y * asked.times.z;
    // If a moving number needs more copies than the reader permits, a picture without all copies is better than none.
    glm::dvec3 times(1);
    for (int axis = 0; axis < 3; ++axis)
        if (asked.times[axis] > 1) times[axis] = std::min(asked.times[axis], mostCopiesAsked);
    while (times.x * times.y * times.z > mostCopiesAsked) {
        double& most = times[times.x >= times.y && times.x >= times.z ? 0 : times.y >= times.z ? 1 : 2];
        most = std::max(std::floor(most / 2), 1.0);
    }
    double* w = v + k.numbers();
    for (int axis = 0; axis < 3; ++axis) {
        w[axis] = std::clamp(asked.high[axis], -1e9, 1e9);
        w[axis + 3] = times[axis];
    }
    w[6] = asked.cap;
    writeBox(asked.box, w + 7);
}

/// Returns the distance from its surface within which the child of a twist or a bend matters. The stretch grows with
/// the distance from the axis. Points at most `level` from the node are within some reach from the axis. The child's
/// level follows from that reach, and the reach from the part of the child within that level. Infinite if no reach
/// contains them all.
double SceneProgram::levelWithinReach(const SceneConstants& all, std::uint32_t i, double level, int nested) const
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    constexpr int mostNested = 3;      // Limit, because each evaluates everything below it some hundred times.
    constexpr double farthest = 20e3;  // Nothing in a scene is farther away, meters.
    const NodeKind& k = kind(nodes_[i]);
    const double* v = all.words.data() + nodes_[i].numbers;
    const auto levelAt = [&](double reach) { return k.childLevelWithin(v, level, reach); };
    const double perMeter = levelAt(1) - levelAt(0);
    if (level <= 0 || perMeter <= 0) return level;
    if (nested >= mostNested) return endless;
    const std::uint32_t child = nodes_[i].firstChild;
    const auto reachAt = [&](double inner) {
        return k.reachOf(coverOf(all, child, inner, nested + 1).extents.front().box);
    };
    double reach = reachAt(0);
    if (!std::isfinite(reach)) return level;
    if (nodes_[child].exactness != Exactness::bound) {
        // Outside its box, the child's field is the distance, so points within a level are no farther out than that.
        return perMeter < 1 ? levelAt((reach + levelAt(0)) / (1 - perMeter)) : endless;
    }
    // The reach grows until it is consistent with itself, also if it were one step larger.
    constexpr double step = 1.1;
    const auto isBeyond = [&](double at) { return reachAt(levelAt(step * at)) > at; };
    for (reach = std::max(reach, 1e-3); isBeyond(reach); reach *= step)
        if (!(reach < farthest)) return endless;
    // Also check that no larger reach is consistent with itself.
    for (double beyond = step * reach; beyond < farthest; beyond *= step)
        if (isBeyond(beyond)) return endless;
    return levelAt(reach);
}

double SceneProgram::levelOfChild(const SceneConstants& all, std::uint32_t i, double level, int nested) const
{
    const ProgramNode& node = nodes_[i];
    const NodeKind& k = kind(node);
    if (k.childLevelWithin) return levelWithinReach(all, i, level, nested);
    const double siblings = node.children > 0 ? node.children - 1.0 : 0.0;
    return k.childLevel ? k.childLevel(all.words.data() + node.numbers, level, siblings) : level;
}

SceneProgram::Cover SceneProgram::coverOf(const SceneConstants& all, std::uint32_t first, double level,
                                          int nested) const
{
    // Nodes are in depth-first order: descendants follow a node, up to the first one that is none.
    auto end = first + 1;
    while (end < nodes_.size() && nodes_[end].parent != noIndex && nodes_[end].parent >= first) ++end;
    // A blend or a rounding further up may extend this far from each node's surface.
    Cover cover{first, std::vector<double>(end - first, level), std::vector<Bounds>(end - first)};
    for (std::uint32_t i = first; i < end; ++i) {
        const ProgramNode& node = nodes_[i];
        double& own = cover.levels[i - first];
        if (node.scale != noIndex) own /= all.words[node.scale + 3];
        if (node.firstChild == noIndex) continue;
        const double inner = levelOfChild(all, i, own, nested);
        for (std::uint32_t c = node.firstChild; c != noIndex; c = nodes_[c].next) cover.levels[c - first] = inner;
    }
    for (std::uint32_t i = end; i-- > first;) {
        const ProgramNode& node = nodes_[i];
        Bounds extent = extentInside(all, cover, i);
        extent.box = placedBox(extent.box, all.words.data(), node);
        if (node.rotate != noIndex) extent.even = 0;
        if (node.rotate != noIndex || node.scale != noIndex) extent.ballsFrom = Bounds().ballsFrom;
        for (std::uint32_t axis = 0; axis < 3 && node.translate != noIndex; ++axis)
            if (all.words[node.translate + axis] != 0) extent.even &= ~(1U << axis);
        if (node.translate != noIndex)
            extent.ballsFrom =
                all.words[node.translate + 2] == 0 ? extent.ballsFrom + all.words[node.translate] : Bounds().ballsFrom;
        cover.extents[i - first] = extent;
    }
    return cover;
}

void SceneProgram::fillExtents(SceneConstants& all) const
{
    all.asked.assign(nodes_.size(), 1);
    if (nodes_.empty()) return;
    Cover cover = coverOf(all, 0, 0, 0);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        const NodeKind& k = kind(nodes_[i]);
        if (k.form != Form::repeater) continue;
        fillAsked(all, cover, i);
        writeBox(extentInside(all, cover, i).box, all.words.data() + nodes_[i].numbers + k.numbers() + 13);
    }
    all.extents = std::move(cover.extents);
}

}  // namespace vitrine::scenes
