#pragma once

#include "render/scene/mesh.h"

#include <memory>

namespace vitrine::lenticular {

/// The card: a slab with rounded corners and chamfered edges. The middle of its front is the origin, z points
/// out of it; the front's normals are exactly (0, 0, 1). Made once.
[[nodiscard]] std::shared_ptr<const render::Mesh> cardMesh();

}  // namespace vitrine::lenticular
