#pragma once

#include "exhibits/museum/museum.h"

#include <cstdint>

namespace vitrine {

/// Whether any parameter of the look names a file or folder.
[[nodiscard]] bool namesFiles(const SceneState&);

/// Another number when a file or folder that the look names, or something beside it, changed, came or went.
[[nodiscard]] std::uint64_t stateOfFiles(const SceneState&);

}  // namespace vitrine
