#pragma once

#include <filesystem>
#include <string_view>

namespace vitrine {

/// Returns the folder for persistent state other than documents: $XDG_STATE_HOME/vitrine if that is an absolute path,
/// else ~/.local/state/vitrine. (Qt 6.4 has no name for it.) Does not create it.
[[nodiscard]] std::filesystem::path stateFolder();

/// Returns the folder of the user's presets: presets/ in "~/.local/share/vitrine", independent of the Qt application
/// name. Does not create it.
[[nodiscard]] std::filesystem::path userPresetFolder();

/// Returns the folder of the settings: "~/.config/vitrine", independent of the Qt application name. Does not create it.
[[nodiscard]] std::filesystem::path configFolder();

/// Writes a file into one of the program's own folders, which it creates if needed. The user did not choose this folder
/// in a dialog, so the Failure it throws says how to set another one.
void writeOwnFile(const std::filesystem::path&, std::string_view bytes);

}  // namespace vitrine
