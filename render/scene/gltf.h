#pragma once

#include "render/scene/gltf_limits.h"
#include "render/scene/mesh.h"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::render {

/// Reads a glTF 2.0 file, .glb or .gltf, as untrusted input. The container, the JSON, every index, range, path and
/// number is checked before use (see gltf_guard.h and gltf_validate.h). Other files are opened only below the folder of
/// `path`, or beside it (see `gltfReference`). Meshes that Draco or meshoptimizer compressed are decoded (see
/// gltf_compression.h). An accessor without a view and a buffer without a URI are filled with
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
[[nodiscard]] Message whyNothingIsSeen(const std::string& name, const Box& bounds);

}  // namespace vitrine::render
