#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <array>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// Meters: the distance of an empty scene.
inline constexpr double nothingNear = 1e9;

/// The visible shape at a point, and the blended material.
struct WalkSurface {
    std::uint32_t node = noIndex;                    ///< Index in `Scene::nodes`.
    std::array<double, wordsOfMaterial> material{};  ///< In the order of `wordsOfMaterial`.
};

/// Evaluates a program's steps at one point after another, at float64, and reuses its memory. Not thread-safe: use one
/// per thread. Program and words must outlive it.
class SceneWalk {
public:
    /// State of a node while a point is evaluated.
    struct State {
        glm::dvec3 own{0};    ///< The point in the node's space.
        glm::dvec3 asked{0};  ///< Point at which its children are evaluated.
        double distance = 0;
        int copy = 0;
        double lipschitz = 1;
    };

    SceneWalk(const SceneProgram&, const std::vector<double>& words, bool withMaterials);

    /// Runs all steps in order: those of the program, or those left after pruning.
    void run(std::span<const Step> steps, const glm::dvec3& p);
    /// Runs step `i` at the point `p`; returns the index of the next one.
    [[nodiscard]] std::size_t advance(std::span<const Step> steps, std::size_t i, const glm::dvec3& p);

    /// Returns the distance of a leaf at `p`, a point of its parent's space; equals its three steps from `enter` to
    /// `leave`.
    double operand(std::uint32_t node, const glm::dvec3& p);
    /// Sets a node's distance without evaluating it.
    void setDistance(std::uint32_t node, double distance) { states_[node].distance = distance; }

    /// State by index in `SceneProgram::nodes`.
    [[nodiscard]] const State& state(std::uint32_t node) const { return states_[node]; }
    [[nodiscard]] const std::vector<State>& states() const { return states_; }
    /// Filled only if materials are evaluated.
    [[nodiscard]] const WalkSurface& surface(std::uint32_t node) const { return surfaces_[node]; }
    /// Number of shapes evaluated so far.
    [[nodiscard]] std::size_t primitiveEvaluations() const { return primitiveEvaluations_; }

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
    std::vector<const NodeKind*> kinds_;  // Kind of each program node.
    std::vector<State> states_;
    std::vector<WalkSurface> surfaces_;
    std::size_t primitiveEvaluations_ = 0;
};

}  // namespace vitrine::scenes
