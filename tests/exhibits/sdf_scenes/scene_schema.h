#pragma once

#include "render/files/strict_json.h"

namespace vitrine::scenes {

/// Returns a JSON Schema (draft 2020-12) of scene files, made from the tables that the reader uses. Some errors only
/// the reader finds: missing names, expressions, shapes without extent. assets/scenes/scene.schema.json contains it.
[[nodiscard]] render::Json sceneSchema();

}  // namespace vitrine::scenes
