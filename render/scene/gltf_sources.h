#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/tinygltf.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Reads every buffer of a guarded file, each of its `byteLength`: from the GLB container (`bin`, the first buffer
/// only), a data: URI, or a file (`gltfReference`). A buffer without a source is filled with zeros, and a sentence in
/// `warnings` says so. A fallback buffer (`isFallbackBuffer`) stays empty. Throws Failure naming file, line and key if
/// a source is missing or too short, or if there are more zeros than `limits` allow.
[[nodiscard]] std::vector<tinygltf::Buffer> readBuffers(const JsonDocument&, std::string_view bin,
                                                        const std::filesystem::path& folder, const GltfLimits& limits,
                                                        std::vector<Message>& warnings);

/// Reads the encoded bytes of every picture that is not in a buffer, from the same kinds of source, and the names and
/// buffer views of all. A picture whose file cannot be read stays empty. If its reference leaves the allowed folders, a
/// sentence in `warnings` says so. Throws Failure if a picture has no source or two, if a data: URI is broken, or if
/// all together are larger than `limits` allow.
[[nodiscard]] std::vector<tinygltf::Image> readImages(const JsonDocument&, const std::filesystem::path& folder,
                                                      const GltfLimits& limits, std::vector<Message>& warnings);

/// Decodes a percent-encoded reference (RFC 3986).
[[nodiscard]] std::string percentDecoded(std::string_view uri);

/// The same with `/` in place of the backslashes that some exporters on Windows write. The path is relative to the
/// model's folder and may also lead into the parent folder (`Reach::parent`): asset packs keep textures beside models.
[[nodiscard]] std::string gltfReference(std::string_view uri);

}  // namespace vitrine::render
