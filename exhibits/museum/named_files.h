#pragma once

#include "exhibits/museum/museum.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine {

/// Returns whether any parameter names a file or folder that the visitor chose.
[[nodiscard]] bool namesFiles(const SceneState&);

/// Returns the paths of all files and folders that the scene state names, and of those that these need in turn
/// (`TableFromFiles::furtherFiles`). A path may occur twice.
[[nodiscard]] std::vector<std::string> watchedFiles(Subjects, const SceneState&);

/// Returns a hash of the state of these files and folders, and of their neighbors if `withNeighbors` is set.
[[nodiscard]] std::uint64_t stateOfFiles(Subjects, const SceneState&, bool withNeighbors = true);

}  // namespace vitrine
