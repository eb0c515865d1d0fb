#pragma once

#include "exhibits/museum/museum.h"

#include <cstdint>

namespace vitrine {

/// Returns whether any parameter names a file or folder that the visitor chose.
[[nodiscard]] bool namesFiles(const SceneState&);

/// Returns a hash of the state of all files and folders that the scene state names, and of their neighbors. Files that
/// these need in turn (`TableFromFiles::furtherFiles`) are included.
[[nodiscard]] std::uint64_t stateOfFiles(Subjects, const SceneState&);

}  // namespace vitrine
