#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/print_layout.h"
#include "render/files/strict_json.h"

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

}  // namespace vitrine::printing
