#pragma once

#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

namespace vitrine::hall {

/// Makes a plinth with the center of its foot at the origin: a foot, a shaft and a slab on top. Every edge is beveled
/// to catch light. `halfWidth` and `height` are in meters and above 0; one unit of uv is a meter.
[[nodiscard]] render::AssetStore::Made<render::Mesh> makePlinth(double halfWidth, double height);

}  // namespace vitrine::hall
