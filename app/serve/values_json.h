#pragma once

#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"

namespace vitrine::app {

/// Returns the values of all parameters by name, in the format of presets.
[[nodiscard]] render::Json valuesJson(const ParameterValues&);
/// Returns the animations by parameter name.
[[nodiscard]] render::Json motionsJson(const ParameterValues&);
/// Returns {"exhibit", "values", "motions"} of all parameters that changed; null if none did. An animation that ended
/// is null.
[[nodiscard]] render::Json changeJson(std::string_view exhibit, const ParameterValues& before,
                                      const ParameterValues& now);

}  // namespace vitrine::app
