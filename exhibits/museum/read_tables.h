#pragma once

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/museum/scene_state.h"

#include <string>
#include <vector>

namespace vitrine {

/// A scene state with the parameters that its files add.
struct TabledSceneState {
    SceneState sceneState;
    /// Errors of files that cannot be read: full sentences. Their values keep the previous parameters.
    std::vector<Message> unreadable;
    std::vector<std::string> notes;  ///< Values that were changed or are unknown, for people.
};

/// Reads the files of parameters that add parameters, through the asset store, and replaces the sets of parameters.
/// Values of parameters with the same name and kind are kept. Thread-safe. Never throws for a file that cannot be read.
[[nodiscard]] TabledSceneState readTables(Subjects, render::AssetStore&, const SceneState&);

}  // namespace vitrine
