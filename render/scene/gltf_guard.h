#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Checks the JSON of a glTF file before tinygltf sees it. tinygltf 2.7.0 recurses over nested `extras`, ignores
/// members of a wrong type, and checks no ranges. Whole numbers become integers, however they are written. The checks
/// are:
///  - the GLB container: lengths agree with the file in 64-bit arithmetic, chunks are aligned and in order; chunks of
///    unknown types may follow and are skipped;
///  - the JSON is read by the strict reader, and its members have the schema's types; strings are short;
///  - buffers, their views and all counts are within the limits and within one another;
///  - references to files stay below their folder; required extensions are known.
/// Throws Failure naming `name`, line and key.
[[nodiscard]] JsonDocument guardGltf(const std::string& bytes, const std::string& name, const GltfLimits&);

/// Returns whether the effect of an extension is shown, so that a file may require it.
[[nodiscard]] bool isDrawnExtension(std::string_view name);

/// Returns the BIN chunk of a container; empty if there is none.
[[nodiscard]] std::string_view binOf(const std::string& bytes, const std::string& name);

/// Returns whether `bytes` start like a GLB container.
[[nodiscard]] bool isGlb(const std::string& bytes);

}  // namespace vitrine::render
