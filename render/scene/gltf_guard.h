#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"

#include <string>

namespace vitrine::render {

/// The JSON of a glTF file, checked before tinygltf sees the file. tinygltf 2.7.0 reads beyond its buffer
/// for some BIN chunks, recurses over nested `extras`, opens any path and points anywhere for images in
/// buffers; this is what keeps such files from it:
///  - the GLB container: lengths agree with the file in 64-bit arithmetic, chunks are aligned, nothing follows;
///  - the JSON is read by the strict reader; strings are short;
///  - buffers, views of them and counts are within the limits and within one another;
///  - references to files stay below their folder; required extensions are known.
/// Throws Failure naming `name`, line and key.
[[nodiscard]] JsonDocument guardGltf(const std::string& bytes, const std::string& name, const GltfLimits&);

/// Whether `bytes` start like a GLB container.
[[nodiscard]] bool isGlb(const std::string& bytes);

}  // namespace vitrine::render
