#pragma once

#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"

namespace vitrine::app {

/// Every row's value by its name, as presets write it.
[[nodiscard]] render::Json valuesJson(const ParameterValues&);
/// How rows move, by their names.
[[nodiscard]] render::Json motionsJson(const ParameterValues&);
/// {"exhibit", "values", "motions"} of the rows that are not as before; null where all are. A row that moved and rests
/// now has null for a motion.
[[nodiscard]] render::Json changeJson(std::string_view exhibit, const ParameterValues& before,
                                      const ParameterValues& now);

}  // namespace vitrine::app
