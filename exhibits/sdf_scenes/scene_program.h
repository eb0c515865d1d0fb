#pragma once

#include "exhibits/sdf_scenes/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine::scenes {

/// A node that is drawn, and where its words stand (`SceneWords`). Hidden nodes and those that have no child left are
/// not among them.
struct ProgramNode {
    std::uint32_t node = 0;                                       ///< In `Scene::nodes`.
    std::uint32_t parent = none, firstChild = none, next = none;  ///< In `SceneProgram::nodes`.
    std::uint32_t children = 0;
    std::uint32_t translate = none;  ///< Three words.
    std::uint32_t rotate = none;     ///< Nine: the axes of its own space.
    std::uint32_t scale = none;      ///< Four: one over each factor, and the smallest one.
    std::uint32_t numbers = 0;       ///< Those of the kind; behind them, for a repeater, those of `Asked`.
    std::uint32_t material = 0;      ///< Of a shape: in the scene's list of materials.
    Exactness exactness = Exactness::exact;
};

/// A step of evaluating the tree at a point. Steps stand in the order of a walk, so nothing recurses.
struct Step {
    enum class Type : std::uint8_t {
        enter,    ///< The point in the node's own space, and where its children are asked.
        shape,    ///< The distance of a shape.
        first,    ///< The first child is the result so far.
        combine,  ///< Another child is combined with the result so far.
        modify,   ///< The distance of a modifier from that of its child.
        again,    ///< The nearest copy so far; back behind `enter` for the next one.
        leave     ///< The distance in the parent's space.
    };
    Type type = Type::enter;
    std::uint32_t node = 0;   ///< In `SceneProgram::nodes`.
    std::uint32_t child = 0;  ///< first, combine, modify, again.
    std::uint32_t back = 0;   ///< again: the step to go on with.
};

/// What a program is evaluated with: its numbers in the form that it takes them, and what each node covers.
struct SceneWords {
    std::vector<double> words;
    std::vector<Extent> extents;  ///< By program node, in its parent's space, of what is at or below distance 0.
    std::vector<double> asked;    ///< By program node: how many copies a repeater should ask; 1 for others.
};

/// The numbers of a material in the order of shaders/sdf_scenes/material.glsl.
inline constexpr std::size_t wordsOfMaterial = 16;

/// A scene's tree as steps. It depends on what the tree contains, not on its numbers.
class SceneProgram {
public:
    explicit SceneProgram(std::shared_ptr<const Scene>);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const std::vector<ProgramNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const NodeKind& kind(const ProgramNode& node) const { return *scene_->nodes[node.node].kind; }
    [[nodiscard]] std::size_t wordCount() const { return wordCount_; }
    /// `wordsOfMaterial` for each material that a node has, from here.
    [[nodiscard]] std::uint32_t materialWord(std::uint32_t material) const { return materialWords_[material]; }

    /// From `Scene::numbersAt`.
    [[nodiscard]] SceneWords words(const std::vector<double>& numbers) const;

private:
    void keepNodes();
    void placeWords();
    void writeSteps();
    void findExactness();
    void fillExtents(SceneWords&) const;
    /// The extents of a node and of all nodes below it, in the order of the nodes, and for each the distance from its
    /// surface, in meters, within which its field is needed.
    struct Cover {
        std::uint32_t first = 0;
        std::vector<double> levels;
        std::vector<Extent> extents;

        [[nodiscard]] const Extent& extent(std::uint32_t node) const { return extents[node - first]; }
    };
    /// `nested`: inside how many nodes that look for a level of their child.
    [[nodiscard]] Cover coverOf(const SceneWords&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] double levelOfChild(const SceneWords&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] double levelWithinReach(const SceneWords&, std::uint32_t node, double level, int nested) const;
    [[nodiscard]] Extent extentInside(const SceneWords&, const Cover&, std::uint32_t node) const;
    void fillAsked(SceneWords&, const Cover&, std::uint32_t node) const;

    std::shared_ptr<const Scene> scene_;
    std::vector<ProgramNode> nodes_;
    std::vector<Step> steps_;
    std::vector<std::uint32_t> materialWords_;
    std::size_t wordCount_ = 0;
};

}  // namespace vitrine::scenes
