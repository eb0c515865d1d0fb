#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <array>
#include <memory>
#include <vector>

namespace vitrine::scenes {

/// What is at a point of a scene.
struct SceneSample {
    double distance = 0;                             ///< Meters, negative inside; a step of this length is safe.
    std::uint32_t node = none;                       ///< The shape that has the largest share; in `Scene::nodes`.
    std::array<double, wordsOfMaterial> material{};  ///< Blended, in the order of `wordsOfMaterial`.
};

/// What a node gave at a point.
struct NodeSample {
    double distance = 0;   ///< In the space of its parent, divided by `lipschitz` already.
    double lipschitz = 1;  ///< By how much the operation may have stretched it there.
};

/// A scene's field at one moment, at float64: the functions that the generated shader calls, compiled as C++.
/// 1-Lipschitz everywhere, so `distance` is a step that passes no surface. Any thread may ask it, several at once.
class SceneField {
public:
    SceneField(std::shared_ptr<const SceneProgram>, SceneWords);
    /// Of a scene at a time in seconds.
    explicit SceneField(std::shared_ptr<const Scene>, double time = 0, const std::vector<double>& parameters = {});

    /// 1e9 where nothing is to be seen.
    [[nodiscard]] double distance(const glm::dvec3& p) const;
    /// With its material.
    [[nodiscard]] SceneSample sample(const glm::dvec3& p) const;
    /// Every node, by its number in `SceneProgram::nodes`. Of what is repeated, the copy asked last.
    [[nodiscard]] std::vector<NodeSample> nodes(const glm::dvec3& p) const;
    /// Where the scene is; infinite where it has no end.
    [[nodiscard]] render::Box box() const;

    [[nodiscard]] const SceneProgram& program() const { return *program_; }
    [[nodiscard]] const SceneWords& words() const { return words_; }

private:
    std::shared_ptr<const SceneProgram> program_;
    SceneWords words_;
};

}  // namespace vitrine::scenes
