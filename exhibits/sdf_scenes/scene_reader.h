#pragma once

#include "exhibits/sdf_scenes/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

inline constexpr const char* sceneFormat = "vitrine-scene";
inline constexpr int sceneVersion = 1;

/// A scene, or why there is none.
struct ReadScene {
    std::shared_ptr<const Scene> scene;  ///< Null where something was found wrong.
    std::vector<Finding> findings;
    bool fileRead = true;  ///< False where the file itself could not be read.
};

/// The text of an included file by its path from the scene's folder. Throws Failure.
using IncludedText = std::function<std::string(const std::string& path)>;

/// Reads a scene: assets/scenes/scene.schema.json says what may stand in it, and the scene objects of its source
/// (Akgul, Boucher and El Hajal's ray marching engine, as JSON) are read as well. Strict: what is unknown, out of range
/// or of no use is found wrong, with its place. Of a scene object of the source, a shape without area or size is left
/// out where others remain (`Scene::leftOut`). `name` is the file's name for people. Throws nothing for a bad text,
/// and does not recurse, however deep it is.
[[nodiscard]] ReadScene readScene(const std::string& text, const std::string& name, const IncludedText& included,
                                  const SceneLimits& limits = {});

/// The same of a file, which may include files of its own folder and of folders therein. A file that cannot be read is
/// a finding, too.
[[nodiscard]] ReadScene readSceneFile(const std::filesystem::path&, const SceneLimits& limits = {});

}  // namespace vitrine::scenes
