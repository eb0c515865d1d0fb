#pragma once

#include <filesystem>

namespace vitrine::render {

/// README.md of the program: in share/doc/vitrine beside its assets, or in the source tree. Empty where it did not come
/// with this copy.
[[nodiscard]] std::filesystem::path manualFile();

}  // namespace vitrine::render
