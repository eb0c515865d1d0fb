#pragma once

#include "exhibits/framework/capabilities.h"
#include "exhibits/framework/subject.h"
#include "exhibits/museum/scene_state.h"

#include <string>
#include <vector>

namespace vitrine {

/// A look under the tables that the files which it names call for.
struct TabledSceneState {
    SceneState sceneState;
    std::vector<std::string> unreadable;  ///< Which files cannot be read, and why: full sentences. Their values keep
                                          ///< the table that they had.
    std::vector<std::string> notes;       ///< What of the values was changed or is not known, for people.
};

/// Reads the files in rows that give rows, through the asset store, and exchanges the tables: values of rows with the
/// same name and kind stay. Any thread may call it, several at once. Never throws for a file that cannot be read.
[[nodiscard]] TabledSceneState readTables(Subjects, render::AssetStore&, const SceneState&);

}  // namespace vitrine
