#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/tinygltf.h"

namespace vitrine::render {

/// Checks everything that the conversion relies on, because tinygltf checks almost none of it:
///  - every index is in range;
///  - every accessor lies inside its view and every view inside its buffer (64-bit arithmetic);
///  - strides are 4 to 252; sparse indices rise and are in range; vertex indices name vertices;
///  - nodes form a tree: each has at most one parent, there are no cycles, and the depth is limited;
///  - transforms are finite, and counts are within the limits.
/// Skins and animations are not checked here; gltf_animation.cpp checks what it reads itself. Throws Failure naming the
/// file, the line in its JSON and the key.
void validateGltf(const tinygltf::Model&, const JsonDocument&, const GltfLimits&);

}  // namespace vitrine::render
