#pragma once

#include <filesystem>
#include <string_view>

namespace vitrine::render {

/// Returns the folder of the program's own assets: $VITRINE_ASSETS, else share/vitrine or ../../assets beside the
/// executable, else the source tree that it was built from. Throws Failure (ErrorKind::file) if none has them.
[[nodiscard]] const std::filesystem::path& assetFolder();

/// assetFolder() / relative.
[[nodiscard]] std::filesystem::path asset(std::string_view relative);

}  // namespace vitrine::render
