#pragma once

#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "render/files/asset_store.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// A file with its state when something was made from it.
struct SeenFile {
    std::filesystem::path path;
    render::FileState state;
};

/// Result of reading a scene's document: its parameters, or the reason why there are none.
struct SceneReading {
    std::shared_ptr<const SdfScenesTable> table;
    Message why;                  ///< One sentence; empty on success.
    std::vector<SeenFile> files;  ///< The scene's own file and all included ones, as far as they were read.
};

/// Reads the file at `path`, or `text` instead if that is not empty. Returns the same object until one of the files
/// changes. Thread-safe.
[[nodiscard]] std::shared_ptr<const SceneReading> readDocument(const std::filesystem::path& path,
                                                               const std::string& text, render::AssetStore&);

/// Returns whether a text is a scene, or a scene object of the reference, judged by its head.
[[nodiscard]] bool isSceneText(const std::string& text);

/// Returns the files that were read besides the scene's own file, and the pictures of its environment.
[[nodiscard]] std::vector<std::string> filesBeside(const ShownScene&);

}  // namespace vitrine::scenes
