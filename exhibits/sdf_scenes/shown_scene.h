#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/sdf_scenes/scene_field.h"
#include "render/files/asset_store.h"
#include "render/glsl/shader_key.h"
#include "render/glsl/std140.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

#include "shaders/sdf_scenes/stage_block.glsl"

/// Features of a scene that need code in its shader, whatever its numbers are.
struct SceneContents {
    bool mirrorsInReference = false;  ///< A material is, or may become, reflective in the reference's shading ...
    bool mirrors = false;             ///< ... or in the physically based shading of metal and glaze.
    /// A material may reflect light of the scene's lights in the reference's shading; Phong materials need not.
    bool litInReference = false;
    bool glass = false;
    bool glows = false;
    bool lamps = false;  ///< Visible area lights.
    bool moves = false;
};

/// A scene that was read, with everything that is made from it once.
struct ShownScene {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const SceneProgram> program;
    std::shared_ptr<const render::ShaderSources> sources;
    SceneContents contents;
    /// Distance from the camera to the frame's opening, meters: chosen so that nothing lies in front of the opening.
    double toOpening = 1;
    std::filesystem::path path;                   ///< The scene's file; files that it names are relative to it.
    std::vector<std::filesystem::path> included;  ///< Files that were included.
    std::uint64_t pictures = 0;  ///< Hash of the state of its environment's pictures when they were read.
};

/// Reads a scene. Throws Failure (ErrorKind::file) with the first finding if it cannot be read.
[[nodiscard]] std::shared_ptr<const ShownScene> readShownScene(const std::filesystem::path&);
/// The same for a scene that is already parsed.
[[nodiscard]] std::shared_ptr<const ShownScene> shownScene(std::shared_ptr<const Scene>, std::filesystem::path = {});

/// Camera of a scene.
struct SceneCamera {
    glm::dvec3 eye, target, up;
    double fovY;  ///< Radians.
};
/// Returns the camera for numbers of `Scene::numbersAt`, rotated around its target by `orbit` radians.
[[nodiscard]] SceneCamera sceneCamera(const Scene&, const std::vector<double>& numbers, double orbit);

/// Returns the transform of the scene behind the frame: its camera's eye coincides with that of `sceneView`, at the
/// distance `ShownScene::toOpening` from the frame's opening.
[[nodiscard]] Portal scenePortal(const SceneCamera&, double toOpening);
/// Returns the camera whose picture shows the opening with a small margin.
[[nodiscard]] render::Camera sceneView(double fovY);

/// Returns lights and environment of the scene. Only the first `SCENE_MOST_LIGHTS` lights are used.
[[nodiscard]] SceneStage sceneStage(const ShownScene&, const SceneConstants&, const std::vector<double>& numbers);

/// Sets the box that rays are traced in; infinite sides are clipped.
void setBox(SceneStage&, const render::Box&);

/// Reads the panorama of a scene's environment, from one file or from six, about as large as requested. Throws Failure.
[[nodiscard]] std::shared_ptr<const render::Texture> readEnvironment(const ShownScene&);
/// Returns the files of that panorama, for a scene that was read from `path`.
[[nodiscard]] std::vector<std::filesystem::path> environmentFiles(const Scene&, const std::filesystem::path& path);

}  // namespace vitrine::scenes
