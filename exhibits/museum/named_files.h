#pragma once

#include "exhibits/museum/museum.h"

#include <cstdint>

namespace vitrine {

/// Whether any parameter of the look names a file or folder, or what it shows is made of one.
[[nodiscard]] bool namesFiles(Subjects, const SceneState&);

/// Another number when a file or folder that the look names, or something beside it, or what these need in turn
/// (`TableFromFiles::furtherFiles`), changed, came or went.
[[nodiscard]] std::uint64_t stateOfFiles(Subjects, const SceneState&);

}  // namespace vitrine
