#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/files/strict_json.h"

namespace vitrine {

/// Returns the JSON Schema of a parameter's value as files have it (`jsonFromValue`): its type, range and choices.
[[nodiscard]] render::Json valueSchema(const ParameterInfo&);

/// Adds label, help and unit of a parameter to a schema.
void describe(render::Json& schema, const ParameterInfo&);

}  // namespace vitrine
