#pragma once

#include "render/scene/mesh.h"

#include <memory>

namespace vitrine {

/// A square of blue noise that tiles: every level once per 256 texels or so, neighbors as unlike as can be.
/// 64 x 64, one channel. Ulichney 1993, "The Void-and-Cluster Method for Dither Array Generation"; made when it is
/// first asked for, always the same.
[[nodiscard]] std::shared_ptr<const render::Texture> blueNoise();

}  // namespace vitrine
