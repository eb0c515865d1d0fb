#pragma once

#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

namespace vitrine {

/// A plinth's mesh, its foot in the middle of the floor at the origin: a foot, a shaft and a slab on top, every edge
/// broken, as nothing catches light without one. Meters, both greater than 0; one unit of uv is a meter.
[[nodiscard]] render::AssetStore::Made<render::Mesh> makePlinth(double halfWidth, double height);

}  // namespace vitrine
