#pragma once

#include <filesystem>

namespace vitrine::render {

/// Returns the path of the program's README.md: in share/doc/vitrine beside its assets, or in the source tree. Empty if
/// it is not installed.
[[nodiscard]] std::filesystem::path manualFile();

}  // namespace vitrine::render
