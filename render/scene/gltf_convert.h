#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/mesh.h"
#include "render/scene/tinygltf.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::render {

struct GltfPose;

/// A glTF file after `guardGltf` and `validateGltf`.
struct GltfFile {
    JsonDocument document;
    tinygltf::Model gltf;
    std::vector<Message> warnings;
};
/// Throws Failure as `loadGltf` does.
[[nodiscard]] GltfFile readGltfFile(const std::string& bytes, const std::filesystem::path&, const GltfLimits&);

/// Returns the transform from the node's space to its parent's.
[[nodiscard]] glm::dmat4 nodeTransform(const tinygltf::Node&);

/// Converts a validated file to a Model, as described at `loadGltf`. If `pose` is given, meshes are deformed by it.
/// Throws Failure.
[[nodiscard]] Model convertGltf(const tinygltf::Model&, const JsonDocument&, const GltfLimits&,
                                const std::function<bool()>& canceled, const GltfPose* pose = nullptr);

}  // namespace vitrine::render
