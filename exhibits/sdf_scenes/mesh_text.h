#pragma once

#include "exhibits/sdf_scenes/scene_mesh.h"

#include <string>

namespace vitrine::scenes {

/// Returns a Wavefront OBJ file: meters, y up, with normals and the sRGB color of each vertex behind its position.
[[nodiscard]] std::string objFile(const SceneMesh&, const std::string& name);

/// Returns a 3MF file (3D Manufacturing Format, Core Specification 1.3 with the color groups of the Materials Extension
/// 1.2): millimeters, z up, on the build plate, with the sRGB color of each corner.
[[nodiscard]] std::string threeMfFile(const SceneMesh&, const std::string& name);

}  // namespace vitrine::scenes
