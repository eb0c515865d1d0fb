#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"
#include "render/scene/tinygltf.h"

namespace vitrine::render {

/// Turns a validated file into a Model, as `loadGltf` says. Throws Failure.
[[nodiscard]] Model convertGltf(const tinygltf::Model&, const JsonDocument&, const GltfLimits&,
                                const std::function<bool()>& canceled);

}  // namespace vitrine::render
