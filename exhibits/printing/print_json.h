#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/print_table.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Every parameter of a print and the numbers that follow, as the file carries them: enough to look at it
/// through its sheet and to make it again. Lengths in millimeters; an infinite distance is null.
[[nodiscard]] render::Json printJson(const PrintLayout&, double storedDpiX, const std::vector<std::string>& sources);

/// Such a text with what compensation did to these views.
[[nodiscard]] std::string withCrossTalk(const std::string& json, const CrossTalk&);

/// The settings in such a text, which comes from a file. Throws Failure naming line and key.
[[nodiscard]] PrintSettings settingsFromJson(const render::JsonDocument&);

/// The values that differ from the initial ones, by name, and where the views came from: under "desk" in a print's
/// JSON, so that a print brings back everything that was set.
[[nodiscard]] render::Json valuesJson(const ParameterValues&, const std::vector<std::string>& sources);

/// Everything that is set, as a print's own JSON has it.
[[nodiscard]] std::string settingsText(const ParameterValues&, const std::vector<std::string>& sources);

/// What such a text brings back.
struct SavedSettings {
    ParameterValues values;
    std::vector<std::string> sources;
    std::vector<std::string> notes;  ///< What had to be changed, for people.
};
/// Reads a JSON that a print or `settingsText` wrote. Throws Failure naming file, line and key.
[[nodiscard]] SavedSettings savedSettings(const std::string& text, const std::string& fileName);
/// The JSON inside or beside a print, or of a file of settings. `doubts` takes `PrintDescription::doubt`. Throws
/// Failure when there is none.
[[nodiscard]] std::string settingsIn(const std::filesystem::path&, std::vector<std::string>* doubts = nullptr);

}  // namespace vitrine::printing
