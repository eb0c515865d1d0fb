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

/// A scene, or the errors why there is none.
struct ReadScene {
    std::shared_ptr<const Scene> scene;  ///< Null if there is any error.
    std::vector<Finding> findings;
    bool fileRead = true;  ///< False if the file itself could not be read.
};

/// Returns the text of an included file, given its path relative to the scene's folder. Throws Failure.
using IncludedText = std::function<std::string(const std::string& path)>;

/// Reads a scene. assets/scenes/scene.schema.json describes the format; scene objects of the reference (Akgul, Boucher
/// and El Hajal's ray marching engine, as JSON) are read as well. Strict: unknown, illegal or useless values are
/// reported with their position. In a scene object of the reference, a shape without area or size is left out if others
/// remain (`Scene::leftOut`). `name` is the file's name for messages. Throws nothing for a bad text, and does not
/// recurse, however deep it is nested.
[[nodiscard]] ReadScene readScene(const std::string& text, const std::string& name, const IncludedText& included,
                                  const SceneLimits& limits = {});

/// The same for a file, which may include files of its own folder and its subfolders. A file that cannot be read is a
/// finding, too.
[[nodiscard]] ReadScene readSceneFile(const std::filesystem::path&, const SceneLimits& limits = {});

}  // namespace vitrine::scenes
