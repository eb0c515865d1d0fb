#pragma once

#include "render/scene/mesh.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::render {

/// What a glTF file may hold at most.
struct GltfLimits {
    std::uint64_t fileBytes = 512ULL << 20U;  ///< Of the file, and of each file it names.
    std::uint64_t jsonBytes = 32ULL << 20U;
    std::uint64_t bufferBytes = 1ULL << 30U;  ///< Of all buffers together; the same again for packed images.
    std::uint64_t zeroBytes = 64ULL << 20U;   ///< Of buffers and accessors that the file gives no data for.
    std::uint64_t nodes = 100'000;
    std::uint64_t nodeDepth = 256;
    std::uint64_t primitives = 100'000;
    std::uint64_t vertices = 20'000'000;
    std::uint64_t indices = 60'000'000;
    std::uint64_t images = 256;
    std::uint64_t textureBytes = 2ULL << 30U;  ///< Once unpacked; counted before each picture is unpacked.
    std::uint64_t stringBytes = 4096;          ///< Of one name or reference; data: URIs are counted as JSON.
};

/// Reads a glTF 2.0 file, .glb or .gltf, as untrusted input: the container, the JSON, every index, range,
/// path and number is checked before it is used (see gltf_guard.h and gltf_validate.h), and other files are
/// opened only below the folder of `path`. What the standard leaves without data (an accessor without a view,
/// a buffer without a uri) is zeros.
///
/// The node tree is flattened: one Part per triangle primitive and node, a Marker for each node without a
/// mesh. Missing normals become flat normals, as the format asks. Missing tangents, where a normal map needs
/// them, are summed per triangle at shared vertices: like MikkTSpace (Mikkelsen 2008) for meshes whose
/// texture charts do not mirror across a shared vertex, but not bit-equal to it. Texture coordinates keep
/// glTF's sense: v = 0 is the top row of a picture, and row 0 of `Texture`.
///
/// What the file asks for and this program does not draw (skins, animations, morph targets, lines, points,
/// extensions, pictures that cannot be read) is left out and listed in `warnings`.
/// `canceled` (may be empty) is asked between primitives and between pictures.
/// Throws Failure naming file, line and key of what is broken or beyond `limits`.
[[nodiscard]] Model loadGltf(const std::filesystem::path&, const GltfLimits& = {},
                             const std::function<bool()>& canceled = {});

/// The same from the bytes of a file named `path`, which need not exist.
[[nodiscard]] Model parseGltf(const std::string& bytes, const std::filesystem::path&, const GltfLimits& = {},
                              const std::function<bool()>& canceled = {});

/// Why nothing of a model in these bounds can be seen, a sentence with its name: it has no triangles, or they are
/// scaled to a point or a line. Empty where something can be seen.
[[nodiscard]] std::string whyNothingIsSeen(const std::string& name, const Box& bounds);

}  // namespace vitrine::render
