#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <array>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// Far from everything: the distance where nothing is to be seen, meters.
inline constexpr double nothingNear = 1e9;

/// The shape that shows at a point, and the blended material.
struct WalkSurface {
    std::uint32_t node = none;                       ///< In `Scene::nodes`.
    std::array<double, wordsOfMaterial> material{};  ///< In the order of `wordsOfMaterial`.
};

/// Evaluates a program's steps at points, one after another, at float64; keeps its memory between points. For one
/// thread at a time. Program and words must outlive it.
class SceneWalk {
public:
    /// What a node has while a point is evaluated.
    struct State {
        glm::dvec3 own{0};    ///< The point in the node's space.
        glm::dvec3 asked{0};  ///< Where its children are asked.
        double distance = 0;
        int copy = 0;
        double lipschitz = 1;
    };

    SceneWalk(const SceneProgram&, const std::vector<double>& words, bool withMaterials);

    /// All steps in turn: those of the program, or those that were left of them.
    void run(std::span<const Step> steps, const glm::dvec3& p);
    /// Step `i` at the point `p`; the number of the next one.
    [[nodiscard]] std::size_t advance(std::span<const Step> steps, std::size_t i, const glm::dvec3& p);

    /// A shape's distance where its parent asks it, as the three steps from `enter` to `leave` find it.
    double operand(std::uint32_t node, const glm::dvec3& p);
    /// In place of a step that is known to give this.
    void setDistance(std::uint32_t node, double distance) { states_[node].distance = distance; }

    /// By the number of a node in `SceneProgram::nodes`.
    [[nodiscard]] const State& state(std::uint32_t node) const { return states_[node]; }
    [[nodiscard]] const std::vector<State>& states() const { return states_; }
    /// With materials only.
    [[nodiscard]] const WalkSurface& surface(std::uint32_t node) const { return surfaces_[node]; }
    /// Shapes that were evaluated since it was made.
    [[nodiscard]] std::size_t shapesAsked() const { return shapesAsked_; }

private:
    [[nodiscard]] glm::dvec3 into(const ProgramNode&, glm::dvec3 p) const;
    void enter(std::uint32_t node, const glm::dvec3& outside);
    void shape(std::uint32_t node);
    void inherit(std::uint32_t node, std::uint32_t child);
    void combine(const Step&);
    void modify(const Step&);
    [[nodiscard]] bool again(const Step&);

    const SceneProgram& program_;
    const double* words_;
    std::vector<const NodeKind*> kinds_;  // By node.
    std::vector<State> states_;
    std::vector<WalkSurface> surfaces_;
    std::size_t shapesAsked_ = 0;
};

}  // namespace vitrine::scenes
