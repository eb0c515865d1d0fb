#pragma once

#include <filesystem>

namespace vitrine {

/// Where state that is worth keeping, but no document, lives: $XDG_STATE_HOME/vitrine when that is an
/// absolute path, else ~/.local/state/vitrine (Qt 6.4 has no name for it). Not created here.
[[nodiscard]] std::filesystem::path stateFolder();

/// Where the user's own presets live: presets/ in QStandardPaths::AppDataLocation, whatever the
/// application is called ("~/.local/share/vitrine/presets"). Not created here.
[[nodiscard]] std::filesystem::path userPresetFolder();

/// Where settings live: "~/.config/vitrine", whatever the application is called. Not created here.
[[nodiscard]] std::filesystem::path configFolder();

}  // namespace vitrine
