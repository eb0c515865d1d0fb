#pragma once

#include <filesystem>
#include <string_view>

namespace vitrine {

/// Where state that is worth keeping, but no document, lives: $XDG_STATE_HOME/vitrine when that is an
/// absolute path, else ~/.local/state/vitrine (Qt 6.4 has no name for it). Not created here.
[[nodiscard]] std::filesystem::path stateFolder();

/// Where the user's own presets live: presets/ in QStandardPaths::AppDataLocation, whatever the
/// application is called ("~/.local/share/vitrine/presets"). Not created here.
[[nodiscard]] std::filesystem::path userPresetFolder();

/// Where settings live: "~/.config/vitrine", whatever the application is called. Not created here.
[[nodiscard]] std::filesystem::path configFolder();

/// Writes a file into one of the program's own folders, which it creates if needed. The user did not choose this folder
/// in a dialog, so the Failure it throws says how to set another one.
void writeOwnFile(const std::filesystem::path&, std::string_view bytes);

}  // namespace vitrine
