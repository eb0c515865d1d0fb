#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"
#include "render/scene/tinygltf.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// The bytes of every buffer of a guarded file, each of its `byteLength`: from the GLB container (`bin`, the first
/// buffer only), a data: URI, or a file (`gltfReference`). A buffer for which the file names no source holds zeros, and
/// a sentence in `warnings` says so. Throws Failure naming file, line and key when a source is missing or too short, or
/// when there are more zeros than `limits` allow.
[[nodiscard]] std::vector<tinygltf::Buffer> readBuffers(const JsonDocument&, std::string_view bin,
                                                        const std::filesystem::path& folder, const GltfLimits& limits,
                                                        std::vector<std::string>& warnings);

/// The packed bytes of every picture that is not in a buffer, from the same kinds of source, and the names and views of
/// all. A picture whose file cannot be read stays empty; where its reference leads too far, a sentence in `warnings`
/// says so. Throws Failure when a picture has no source or two, a data: URI is broken, or when all together are larger
/// than `limits` allow.
[[nodiscard]] std::vector<tinygltf::Image> readImages(const JsonDocument&, const std::filesystem::path& folder,
                                                      const GltfLimits& limits, std::vector<std::string>& warnings);

/// The path that a percent-encoded reference (RFC 3986) means.
[[nodiscard]] std::string percentDecoded(std::string_view uri);

/// The same with `/` in place of the backslashes that some exporters on Windows write. It is seen from the model's
/// folder and may lead into the folder that holds that one (`Reach::parent`): asset packs keep textures beside models.
[[nodiscard]] std::string gltfReference(std::string_view uri);

}  // namespace vitrine::render
