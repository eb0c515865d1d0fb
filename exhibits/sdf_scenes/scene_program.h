#pragma once

#include "exhibits/sdf_scenes/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine::scenes {

/// A node that is drawn, with the indices of its numbers (`SceneConstants`). Hidden nodes, and operations without
/// children, are left out.
struct ProgramNode {
    std::uint32_t node = 0;                                                ///< Index in `Scene::nodes`.
    std::uint32_t parent = noIndex, firstChild = noIndex, next = noIndex;  ///< Indices in `SceneProgram::nodes`.
    std::uint32_t children = 0;
    std::uint32_t translate = noIndex;  ///< Index of three numbers.
    std::uint32_t rotate = noIndex;     ///< Index of nine: the axes of its own space.
    std::uint32_t scale = noIndex;      ///< Index of four: the reciprocal of each factor, and the smallest factor.
    std::uint32_t numbers = 0;          ///< Index of the kind's numbers; in a repeater, those of `RepeatRange` follow.
    std::uint32_t material = 0;         ///< Shapes: index in the scene's list of materials.
    Exactness exactness = Exactness::exact;
};

/// Step of evaluating the tree at a point. Steps are in depth-first order, so that no recursion is needed.
struct Step {
    enum class Type : std::uint8_t {
        enter,    ///< Computes the point in the node's own space, and the point at which its children are evaluated.
        shape,    ///< Evaluates the distance of a shape.
        first,    ///< Takes the first child as the result so far.
        combine,  ///< Combines another child with the result so far.
        modify,   ///< Computes the distance of a modifier from that of its child.
        again,    ///< Keeps the nearest copy so far; jumps back to after `enter` for the next copy.
        leave     ///< Converts the distance to the parent's space.
    };
    Type type = Type::enter;
    std::uint32_t node = 0;   ///< Index in `SceneProgram::nodes`.
    std::uint32_t child = 0;  ///< Index of the child; used by first, combine, modify, again.
    std::uint32_t back = 0;   ///< Index of the step to continue with; used by again.
};

/// Numbers with which a program is evaluated, in the form that it needs, and the bounds of each node.
struct SceneConstants {
    std::vector<double> words;
    /// Bounds of each program node, in its parent's space, of everything at distance 0 or below.
    std::vector<Bounds> extents;
    /// For each program node: how many copies a repeater needs to evaluate; 1 for other nodes.
    std::vector<double> asked;
};

/// The numbers of a material in the order of shaders/sdf_scenes/material.glsl.
inline constexpr std::size_t wordsOfMaterial = 16;

/// A scene's tree as a list of steps. It depends on the structure of the tree, not on its numbers.
class SceneProgram {
public:
    explicit SceneProgram(std::shared_ptr<const Scene>);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const std::vector<ProgramNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const NodeKind& kind(const ProgramNode& node) const { return *scene_->nodes[node.node].kind; }
    [[nodiscard]] std::size_t wordCount() const { return wordCount_; }
    /// Index of the `wordsOfMaterial` numbers of a material that a node uses.
    [[nodiscard]] std::uint32_t materialWord(std::uint32_t material) const { return materialWords_[material]; }

    /// Converts the result of `Scene::numbersAt`.
    [[nodiscard]] SceneConstants words(const std::vector<double>& numbers) const;

private:
    void keepNodes();
    void placeWords();
    void writeSteps();
    void findExactness();
    void fillExtents(SceneConstants&) const;
    /// Bounds of a node and of all nodes below it, in the order of the nodes. For each also the distance from its
    /// surface, in meters, within which its field is needed.
    struct Cover {
        std::uint32_t first = 0;
        std::vector<double> levels;
        std::vector<Bounds> extents;

        [[nodiscard]] const Bounds& extent(std::uint32_t node) const { return extents[node - first]; }
    };
    /// Returns the cover of `node`, whose field is needed up to the distance `level` from its surface. `nested`: number
    /// of enclosing nodes for which a level is being searched.
    [[nodiscard]] Cover coverOf(const SceneConstants&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] double levelOfChild(const SceneConstants&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] double levelWithinReach(const SceneConstants&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] Bounds extentInside(const SceneConstants&, const Cover&, std::uint32_t node) const;
    void fillAsked(SceneConstants&, const Cover&, std::uint32_t node) const;

    std::shared_ptr<const Scene> scene_;
    std::vector<ProgramNode> nodes_;
    std::vector<Step> steps_;
    std::vector<std::uint32_t> materialWords_;
    std::size_t wordCount_ = 0;
};

}  // namespace vitrine::scenes
