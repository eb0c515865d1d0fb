#pragma once

#include "render/scene/mesh.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::render {

/// Upper limits for a glTF file.
struct GltfLimits {
    std::uint64_t fileBytes = 512ULL << 20U;  ///< For the file, and for each file it references.
    std::uint64_t jsonBytes = 32ULL << 20U;
    std::uint64_t bufferBytes = 1ULL << 30U;  ///< For all buffers together; the same again for compressed images.
    std::uint64_t zeroBytes = 64ULL << 20U;   ///< For buffers and accessors without data, which are filled with zeros.
    std::uint64_t nodes = 100'000;
    std::uint64_t nodeDepth = 256;
    std::uint64_t primitives = 100'000;
    std::uint64_t vertices = 20'000'000;
    std::uint64_t indices = 60'000'000;
    std::uint64_t images = 256;
    std::uint64_t textureBytes = 2ULL << 30U;  ///< Size when decoded; checked before each picture is decoded.
    std::uint64_t stringBytes = 4096;          ///< For one name or reference; data: URIs count as JSON.
};

/// Reads a glTF 2.0 file, .glb or .gltf, as untrusted input. The container, the JSON, every index, range, path and
/// number is checked before use (see gltf_guard.h and gltf_validate.h). Other files are opened only below the folder of
/// `path`, or beside it (see `gltfReference`). An accessor without a view and a buffer without a URI are filled with
/// zeros, as the standard says.
///
/// The node tree is flattened: one MeshInstance per triangle primitive and node, a Marker for each node without a mesh.
/// Missing normals become flat normals, as the format requires. Missing tangents, if a normal map needs them, are
/// summed per triangle at shared vertices. They equal MikkTSpace's (Mikkelsen 2008), though not bit by bit, for meshes
/// without mirrored texture charts at shared vertices. Texture coordinates keep glTF's convention: v = 0 is the top row
/// of a picture, and row 0 of `Texture`.
///
/// Unsupported content (skins, animations, morph targets, lines, points, extensions, unreadable pictures) is left out
/// and listed in `warnings`.
/// `canceled` (may be empty) is polled between primitives and between pictures.
/// Throws Failure naming file, line and key of broken content or content beyond `limits`.
[[nodiscard]] Model loadGltf(const std::filesystem::path&, const GltfLimits& = {},
                             const std::function<bool()>& canceled = {});

/// The same for the content of a file named `path`, which need not exist.
[[nodiscard]] Model parseGltf(const std::string& bytes, const std::filesystem::path&, const GltfLimits& = {},
                              const std::function<bool()>& canceled = {});

/// Returns a sentence, with the model's name, that says why a model with these bounds is invisible: it has no
/// triangles, or they are scaled to a point or a line. Empty if it is visible.
[[nodiscard]] std::string whyNothingIsSeen(const std::string& name, const Box& bounds);

}  // namespace vitrine::render
