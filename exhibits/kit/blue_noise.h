#pragma once

#include "render/scene/mesh.h"

#include <memory>

namespace vitrine {

/// Returns a square of blue noise that tiles: 64 x 64, one channel. Each level occurs equally often, and neighbors are
/// as different as possible. Ulichney 1993, "The Void-and-Cluster Method for Dither Array Generation". Made at the
/// first call, always the same.
[[nodiscard]] std::shared_ptr<const render::Texture> blueNoise();

}  // namespace vitrine
