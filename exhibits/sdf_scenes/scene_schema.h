#pragma once

#include "render/files/strict_json.h"

namespace vitrine::scenes {

/// What may stand in a scene file, as a JSON Schema (draft 2020-12): made of the tables that the reader reads by. What
/// it cannot say, the reader alone finds: names that are not there, expressions, shapes without extent.
/// assets/scenes/scene.schema.json holds it.
[[nodiscard]] render::Json sceneSchema();

}  // namespace vitrine::scenes
