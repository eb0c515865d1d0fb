#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"
#include "render/scene/tinygltf.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::render {

struct GltfPose;

/// A file that was guarded and validated.
struct GltfFile {
    JsonDocument document;
    tinygltf::Model gltf;
    std::vector<std::string> warnings;
};
/// Throws Failure as `loadGltf` does.
[[nodiscard]] GltfFile readGltfFile(const std::string& bytes, const std::filesystem::path&, const GltfLimits&);

/// From the node's space to its parent's.
[[nodiscard]] glm::dmat4 nodeTransform(const tinygltf::Node&);

/// Turns a validated file into a Model, as `loadGltf` says; deformed, where there is a `pose`. Throws Failure.
[[nodiscard]] Model convertGltf(const tinygltf::Model&, const JsonDocument&, const GltfLimits&,
                                const std::function<bool()>& canceled, const GltfPose* pose = nullptr);

}  // namespace vitrine::render
