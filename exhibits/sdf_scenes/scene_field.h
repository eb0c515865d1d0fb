#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <array>
#include <memory>
#include <vector>

namespace vitrine::scenes {

/// Sample of a scene at a point.
struct SceneSample {
    double distance = 0;                             ///< Meters, negative inside; a step of this length is safe.
    std::uint32_t node = noIndex;                    ///< The shape with the largest weight; index in `Scene::nodes`.
    std::array<double, wordsOfMaterial> material{};  ///< Blended, in the order of `wordsOfMaterial`.
};

/// Result of a node at a point.
struct NodeSample {
    double distance = 0;   ///< Distance in the space of its parent, after the division by `lipschitz`.
    double lipschitz = 1;  ///< Upper bound on the stretch by the operation at that point.
};

/// The SDF of a scene at one time, at float64: the functions that the generated shader calls, compiled as C++.
/// 1-Lipschitz everywhere, so `distance` is a step that passes no surface. Thread-safe.
class SceneField {
public:
    SceneField(std::shared_ptr<const SceneProgram>, SceneConstants);
    /// Field of a scene at a time in seconds.
    explicit SceneField(std::shared_ptr<const Scene>, double time = 0, const std::vector<double>& parameters = {});

    /// Returns the distance; 1e9 for an empty scene.
    [[nodiscard]] double distance(const glm::dvec3& p) const;
    /// Returns the distance with its material.
    [[nodiscard]] SceneSample sample(const glm::dvec3& p) const;
    /// Returns the result of every node, by index in `SceneProgram::nodes`. For repeated nodes, that of the last copy
    /// evaluated.
    [[nodiscard]] std::vector<NodeSample> nodes(const glm::dvec3& p) const;
    /// Returns bounds of the scene; infinite for an infinite scene.
    [[nodiscard]] render::Box box() const;

    [[nodiscard]] const SceneProgram& program() const { return *program_; }
    [[nodiscard]] const SceneConstants& words() const { return words_; }

private:
    std::shared_ptr<const SceneProgram> program_;
    SceneConstants words_;
};

}  // namespace vitrine::scenes
