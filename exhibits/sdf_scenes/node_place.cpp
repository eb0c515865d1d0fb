// Transforms of nodes of the tree in their scene, through all operations that bend space around them.

#include "exhibits/sdf_scenes/scene_tree.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vitrine::scenes {
namespace {

glm::dmat4 matrixOf(const TreePlace& place)
{
    return glm::translate(glm::dmat4(1), place.translate) * glm::dmat4(place.rotation()) *
           glm::scale(glm::dmat4(1), place.scale);
}

TreePlace ownPlace(const Node& node, const std::vector<double>& numbers)
{
    TreePlace place;
    const auto at = [&](std::uint32_t first, const glm::dvec3& other) {
        return first == noIndex ? other : glm::dvec3(numbers[first], numbers[first + 1], numbers[first + 2]);
    };
    place.translate = at(node.translate, place.translate);
    place.rotate = at(node.rotate, place.rotate);
    place.scale = at(node.scale, place.scale);
    return place;
}

/// Maps a point to the point at which a child is evaluated.
using SpaceMap = std::function<glm::dvec3(const glm::dvec3&)>;

/// Returns the derivative of that map. Along an axis where the map is constant, as in the gap of a stretched shape, the
/// child moves with its surroundings.
glm::dmat3 slopeOf(const SpaceMap& map, const glm::dvec3& p)
{
    const double h = 1e-6 * (1 + glm::length(p));
    glm::dmat3 slope;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = h;
        slope[axis] = (map(p + step) - map(p - step)) / (2 * h);
    }
    for (int row = 0; row < 3; ++row)
        if (std::max({std::abs(slope[0][row]), std::abs(slope[1][row]), std::abs(slope[2][row])}) < 1e-6)
            slope[row][row] = 1;
    return slope;
}

/// Returns a point for which the child is evaluated at `x`, by damped Newton steps; nothing if none is found.
std::optional<glm::dvec3> foundBefore(const SpaceMap& map, const glm::dvec3& x)
{
    const double near = 1e-9 * (1 + glm::length(x));
    glm::dvec3 p = x;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 off = x - map(p);
        if (glm::length(off) <= near) return p;
        const glm::dmat3 slope = slopeOf(map, p);
        if (!(std::abs(glm::determinant(slope)) > 1e-9)) return std::nullopt;
        const glm::dvec3 step = glm::inverse(slope) * off;
        double share = 1;
        while (share > 1e-3 && glm::length(x - map(p + share * step)) >= glm::length(off)) share *= 0.5;
        p += (share > 1e-3 ? share : 1) * step;
    }
    return std::nullopt;
}

/// Local linearization of the operation's space map at `x`, a point of the child's space: a matrix to the surrounding
/// space.
std::optional<glm::dmat4> spaceAround(const SpaceMap& map, const glm::dvec3& x)
{
    const std::optional<glm::dvec3> p = foundBefore(map, x);
    if (!p) return std::nullopt;
    const glm::dmat3 slope = slopeOf(map, *p);
    if (!(std::abs(glm::determinant(slope)) > 1e-9)) return std::nullopt;
    const glm::dmat3 back = glm::inverse(slope);
    glm::dmat4 around(back);
    around[3] = glm::dvec4(*p - back * x, 1);
    return around;
}

/// Returns the space maps of an operation with these numbers: one map, or one for each copy that it evaluates.
std::vector<SpaceMap> mapsOf(const NodeKind& kind, const double* v)
{
    if (kind.place) return {[&kind, v](const glm::dvec3& p) { return kind.place.cpu(p, v); }};
    std::vector<SpaceMap> maps;
    const double* times = v + kind.numbers() + 3;
    const int copies = std::min(static_cast<int>(times[0] * times[1] * times[2]), static_cast<int>(mostCopiesAsked));
    for (int i = 0; i < copies; ++i)
        maps.emplace_back([&kind, v, i](const glm::dvec3& p) { return kind.copy.cpu(p, i, v); });
    return maps;
}

}  // namespace

TreePlace placeInScene(const ShownScene& shown, const std::vector<double>& numbers, std::uint32_t node)
{
    const Scene& scene = *shown.scene;
    const std::vector<ProgramNode>& drawn = shown.program->nodes();
    TreePlace place = ownPlace(scene.nodes[node], numbers);
    glm::dmat4 outer(1);
    glm::dvec3 at = place.translate;
    std::optional<SceneConstants> words;
    for (std::uint32_t n = scene.nodes[node].parent; n != noIndex; n = scene.nodes[n].parent) {
        const NodeKind& kind = *scene.nodes[n].kind;
        glm::dmat4 around(1);
        if (kind.place || kind.copy) {
            if (!words) words = shown.program->words(numbers);
            const auto of = std::find_if(drawn.begin(), drawn.end(), [&](const ProgramNode& d) { return d.node == n; });
            std::optional<glm::dmat4> found;
            if (of != drawn.end())
                for (const SpaceMap& map : mapsOf(kind, words->words.data() + of->numbers))
                    if (!found) found = spaceAround(map, at);
            if (!found) {
                place.without = "No handles: through \"" + std::string(kind.name) +
                                "\" around it, its middle is seen nowhere. Change its numbers instead.";
                return place;
            }
            around = *found;
        }
        around = matrixOf(ownPlace(scene.nodes[n], numbers)) * around;
        at = glm::dvec3(around * glm::dvec4(at, 1));
        outer = around * outer;
    }
    place.exhibitFromParent = outer;
    return place;
}

}  // namespace vitrine::scenes
