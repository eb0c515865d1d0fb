#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// The JSON of a glTF file, checked before tinygltf sees it, whole numbers as integers however they are written.
/// tinygltf 2.7.0 recurses over nested `extras`, takes what is of another type for absent, and checks no range; this is
/// what keeps such files from it:
///  - the GLB container: lengths agree with the file in 64-bit arithmetic, chunks are aligned and in order; chunks of
///    unknown types may follow and are passed over;
///  - the JSON is read by the strict reader, and its members are of the schema's types; strings are short;
///  - buffers, views of them and counts are within the limits and within one another;
///  - references to files stay below their folder; required extensions are known.
/// Throws Failure naming `name`, line and key.
[[nodiscard]] JsonDocument guardGltf(const std::string& bytes, const std::string& name, const GltfLimits&);

/// The BIN chunk of a container; empty where there is none.
[[nodiscard]] std::string_view binOf(const std::string& bytes, const std::string& name);

/// Whether `bytes` start like a GLB container.
[[nodiscard]] bool isGlb(const std::string& bytes);

}  // namespace vitrine::render
