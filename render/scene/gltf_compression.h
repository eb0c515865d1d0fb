#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/tinygltf.h"

#include <cstddef>
#include <vector>

namespace vitrine::render {

/// Returns, for each accessor of a file with a checked schema, whether a primitive stores its values with
/// KHR_draco_mesh_compression. Such an accessor needs no view.
[[nodiscard]] std::vector<bool> dracoAccessors(const JsonDocument&);

/// Returns whether EXT_meshopt_compression marks a buffer as a fallback: a place for the decoded bytes, without data in
/// the file.
[[nodiscard]] bool isFallbackBuffer(const Json& buffer);

/// Decodes the buffer views that EXT_meshopt_compression compresses (all its modes and filters), and the primitives
/// that KHR_draco_mesh_compression compresses. Their views and accessors then refer to new buffers. Call it for a
/// guarded file, whose buffers have been read, before its accessors are validated. All decoded bytes together are at
/// most `limits.bufferBytes`. Throws Failure naming file, line and key of broken data.
void decompress(tinygltf::Model&, const JsonDocument&, const GltfLimits&);

}  // namespace vitrine::render
