#pragma once

#include "render/files/asset_store.h"
#include "render/image/texture.h"

#include <memory>
#include <string>

namespace vitrine::guest {

/// Reads a picture as visitors' shaders expect it: display values, the lower row first. Throws Failure.
/// Shadertoy's pictures have mip levels, those of the other forms have none.
[[nodiscard]] render::AssetStore::Made<render::Texture> readPicture(const std::string& path, bool mipmaps);

/// Returns the picture of inputs that name no file: rings and diagonals in colors, 512 x 512 pixels.
[[nodiscard]] std::shared_ptr<const render::Texture> testPicture(bool mipmaps);

/// Returns one black pixel, for pictures that do not exist.
[[nodiscard]] std::shared_ptr<const render::Texture> blackPicture();

}  // namespace vitrine::guest
