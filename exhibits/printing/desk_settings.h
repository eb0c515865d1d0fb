#pragma once

#include "exhibits/printing/desk_table.h"
#include "render/files/strict_json.h"

#include <string>
#include <vector>

namespace vitrine::printing {

/// The sheet that the values describe. Throws Failure (Blame::usage) with the limit when there is none.
[[nodiscard]] Sheet sheetOf(const DeskTable&, const ParameterValues&);
/// The values with this sheet; derived where it is one that follows from LPI, zone and index.
[[nodiscard]] ParameterValues withSheet(const DeskTable&, ParameterValues, const Sheet&);

/// The settings of a print of `views` views. Throws as `sheetOf`; what else cannot be, PrintLayout says.
[[nodiscard]] PrintSettings printSettings(const DeskTable&, const ParameterValues&, int views);
/// The values with these settings; values that are no part of them stay.
[[nodiscard]] ParameterValues withSettings(const DeskTable&, ParameterValues, const PrintSettings&);

/// The values that differ from the initial ones, by name, and where the views came from: under "desk" in a
/// print's JSON, so that a print brings back everything that was set.
[[nodiscard]] render::Json deskJson(const ParameterValues&, const std::vector<std::string>& sources);
/// Throws Failure naming file, line and key. `notes` says what had to be changed.
[[nodiscard]] ParameterValues valuesFromDesk(const DeskTable&, const render::JsonDocument&, std::vector<std::string>& sources,
                                             std::vector<std::string>& notes);

}  // namespace vitrine::printing
