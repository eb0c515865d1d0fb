#pragma once

#include "exhibits/framework/files/preset.h"
#include "render/files/strict_json.h"

#include <string_view>

namespace vitrine {

/// Returns the JSON Schema (draft 2020-12) of the presets of an exhibit. Unknown keys are allowed, since reading keeps
/// them.
[[nodiscard]] render::Json presetSchema(std::string_view exhibit, const ParameterValues& initial);

/// Returns the JSON Schema of settings of the whole museum, whose keys are "hall.exposure".
[[nodiscard]] render::Json exhibitionSchema(const NamedValues& initial);

}  // namespace vitrine
