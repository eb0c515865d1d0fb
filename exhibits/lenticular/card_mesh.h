#pragma once

#include "render/scene/mesh.h"

#include <memory>

namespace vitrine::lenticular {

/// Returns the card: a slab with rounded corners and chamfered edges, made once. The center of its front is the origin,
/// and z points out of it. The front's normals are exactly (0, 0, 1).
[[nodiscard]] std::shared_ptr<const render::Mesh> cardMesh();

}  // namespace vitrine::lenticular
