#pragma once

#include "exhibits/sdf_scenes/scene_mesh.h"
#include "render/image/image.h"

namespace vitrine::jobs {

/// Draws a mesh without perspective, shaded by its normals and as large as the picture. `toEye`: direction from the
/// mesh to the eye; `up`: another direction, which points up in the picture. Edges are drawn if the triangles are large
/// enough to be told apart. Returns linear light with opacity; an empty mesh gives a transparent picture.
[[nodiscard]] render::Image meshPicture(const scenes::SceneMesh&, const glm::dvec3& toEye, const glm::dvec3& up,
                                        const glm::ivec2& size);

}  // namespace vitrine::jobs
