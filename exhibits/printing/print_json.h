#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/print_table.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Returns every parameter of a print and the derived numbers, as stored in the file. They are sufficient to view it
/// through its sheet and to make it again. Lengths are in millimeters; an infinite distance is null.
[[nodiscard]] render::Json printJson(const PrintLayout&, double storedDpiX, const std::vector<std::string>& sources);

/// Returns such a text with the effect of compensation on these views.
[[nodiscard]] std::string withCrossTalk(const std::string& json, const CrossTalk&);

/// Returns the settings in such a text from a file. Throws Failure naming line and key.
[[nodiscard]] PrintSettings settingsFromJson(const render::JsonDocument&);

/// Returns the values that differ from the initial ones, by name, and the origin of the views. They are stored under
/// "desk" in a print's JSON, so a print restores all settings.
[[nodiscard]] render::Json valuesJson(const ParameterValues&, const std::vector<std::string>& sources);

/// Returns all settings in the form of a print's own JSON.
[[nodiscard]] std::string settingsText(const ParameterValues&, const std::vector<std::string>& sources);

/// Settings restored from such a text.
struct SavedSettings {
    ParameterValues values;
    std::vector<std::string> sources;
    std::vector<std::string> notes;  ///< Changes to the values that were read, full sentences.
};
/// Reads a JSON that a print or `settingsText` wrote. Throws Failure naming file, line and key.
[[nodiscard]] SavedSettings savedSettings(const std::string& text, const std::string& fileName);
/// Returns the JSON inside or beside a print, or in a file of settings. `PrintDescription::doubt` is added to `doubts`.
/// Throws Failure if there is none.
[[nodiscard]] std::string settingsIn(const std::filesystem::path&, std::vector<std::string>* doubts = nullptr);

}  // namespace vitrine::printing
