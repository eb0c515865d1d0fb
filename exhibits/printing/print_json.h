#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/print_table.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Origin of a print's views, for its description.
struct PrintSources {
    std::vector<std::string> names = {};  ///< Shown names, one for each view.
    render::Json scene = nullptr;         ///< Preset that renders the views again; null for pictures.
    render::Json rig = nullptr;           ///< Numbers of the cameras of rendered views; null for pictures.
};

/// Returns the settings document of a print, which lies inside and beside it: the values of all parameters, from which
/// it is viewed through its sheet and made again, and a report.
///
///     {"format": "vitrine-job", "version": 1, "app": "0.1.0", "job": "print", "values": {"lensesPerInch": 60, ...},
///      "views": 12, "scene": {"format": "vitrine-exhibition", ...}, "report": {...}}
///
/// `values` are in SI, as in the document of every job. `views` is the number in the print. In `report`, lengths are in
/// millimeters. The layout must be that of the values.
[[nodiscard]] render::Json printJson(const ParameterValues&, const PrintLayout&, double storedDpiX,
                                     const PrintSources&);

/// Returns such a text with the effect of compensation on these views.
[[nodiscard]] std::string withCrossTalk(const std::string& json, const CrossTalk&);

/// Returns the settings in such a text from a file. Throws Failure naming line and key, also for a value that is
/// missing, unknown or out of range: the raster was made with all of them. Where its views came from may be missing.
[[nodiscard]] PrintSettings settingsFromJson(const render::JsonDocument&);

/// Returns values in the form of a print's own document, also if no print is possible with them.
[[nodiscard]] std::string settingsText(const ParameterValues&);

/// Settings restored from such a text.
struct SavedSettings {
    ParameterValues values;
    std::vector<std::string> notes;  ///< Changes to the values that were read, full sentences.
};
/// Reads the document of a print, or one of `settingsText`. Values that are missing keep their initial ones. Throws
/// Failure naming file, line and key.
[[nodiscard]] SavedSettings savedSettings(const std::string& text, const std::string& fileName);
/// Returns the JSON inside or beside a print, or in a file of settings. `PrintDescription::doubt` is added to `doubts`.
/// Throws Failure if there is none.
[[nodiscard]] std::string settingsIn(const std::filesystem::path&, std::vector<std::string>* doubts = nullptr);

}  // namespace vitrine::printing
