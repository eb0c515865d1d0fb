#pragma once

#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "render/files/asset_store.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// A file as it was when something was made of it.
struct SeenFile {
    std::filesystem::path path;
    render::FileState state;
};

/// What became of a scene's document: a table, or why there is none.
struct SceneReading {
    std::shared_ptr<const SdfScenesTable> table;
    std::string why;              ///< One sentence; empty where there is a table.
    std::vector<SeenFile> files;  ///< The scene's own and all that it includes, as far as they were asked for.
};

/// Of the file at `path`, or of `text` in its place where that is not empty: the same until one of the files changed.
/// Any thread may call it.
[[nodiscard]] std::shared_ptr<const SceneReading> readDocument(const std::filesystem::path& path,
                                                               const std::string& text, render::AssetStore&);

/// Whether a text is a scene, or a scene object of the source, as far as its head says.
[[nodiscard]] bool isSceneText(const std::string& text);

/// What was read for the scene beside its own file, and the pictures around it.
[[nodiscard]] std::vector<std::string> filesBeside(const ShownScene&);

}  // namespace vitrine::scenes
