#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/sdf_scenes/scene_field.h"
#include "render/files/asset_store.h"
#include "render/glsl/std140.h"
#include "render/plan/shader_key.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

#include "shaders/sdf_scenes/stage_block.glsl"

/// What of a scene needs code in its shader, whatever its numbers are.
struct SceneContents {
    bool mirrorsInSource = false;  ///< Some material is, or may become, a mirror there ...
    bool mirrors = false;          ///< ... and the same of metal and glaze.
    bool litInSource = false;      ///< Some material sends light of the scene's lights there: Phong's may not.
    bool glass = false;
    bool glows = false;
    bool lamps = false;  ///< Areas that shine, which are seen themselves.
    bool moves = false;
};

/// A scene that was read, with what is made of it once.
struct ShownScene {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const SceneProgram> program;
    std::shared_ptr<const render::ShaderSources> sources;
    SceneContents contents;
    double toOpening = 1;        ///< From the camera to the frame's opening, so that nothing is seen before it, meters.
    std::filesystem::path path;  ///< Of its file: what it names lies beside it.
    std::vector<std::filesystem::path> included;  ///< That were read for it.
    std::uint64_t pictures = 0;  ///< Of those around it, as they were then: another number when one changed.
};

/// Throws Failure (Blame::file) with the first finding for a scene that cannot be read.
[[nodiscard]] std::shared_ptr<const ShownScene> readShownScene(const std::filesystem::path&);
/// Of a scene that is there already.
[[nodiscard]] std::shared_ptr<const ShownScene> shownScene(std::shared_ptr<const Scene>, std::filesystem::path = {});

/// A camera of a scene.
struct SceneCamera {
    glm::dvec3 eye, target, up;
    double fovY;  ///< Radians.
};
/// From `Scene::numbersAt`; gone around its target by `orbit` radians.
[[nodiscard]] SceneCamera sceneCamera(const Scene&, const std::vector<double>& numbers, double orbit);

/// Where the scene lies behind the frame: the camera's eye is that of `sceneView`, and the frame's opening is at
/// `ShownScene::toOpening` from it.
[[nodiscard]] Portal scenePortal(const SceneCamera&, double toOpening);
/// From where the camera's picture fills the opening; a little wider.
[[nodiscard]] render::Camera sceneView(double fovY);

/// What stands around the shapes. Of more lights than `SCENE_MOST_LIGHTS` the first ones.
[[nodiscard]] SceneStage sceneStage(const ShownScene&, const SceneWords&, const std::vector<double>& numbers);

/// Rays look for surfaces in this box; endless sides end where none comes.
void setBox(SceneStage&, const render::Box&);

/// The picture of all directions that a scene's environment names, from one file or from six, about as large as asked;
/// throws Failure.
[[nodiscard]] std::shared_ptr<const render::Texture> readEnvironment(const ShownScene&);
/// The files of that picture, for a scene that was read from `path`.
[[nodiscard]] std::vector<std::filesystem::path> environmentFiles(const Scene&, const std::filesystem::path& path);

}  // namespace vitrine::scenes
