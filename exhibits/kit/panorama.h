#pragma once

#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// A picture of all directions, as the visitor gives one in place of a sky.
struct Panorama {
    std::shared_ptr<const render::Texture> picture;
    double brightest = 0;  ///< Its largest value; 1 for what is stored as bytes. NaN and infinity count as 0.
    /// Full sentences that name the file: what it holds and is not shown, and that it is stretched.
    std::vector<std::string> notes{};
};

/// A full sentence on a picture that is stretched over the sky because it is not twice as wide as high (to two percent
/// of its height, and one pixel); else empty.
[[nodiscard]] std::string stretchedSky(const render::Texture&, const std::string& path);

/// For `AssetStore::get`. Throws where the file cannot be read.
[[nodiscard]] render::AssetStore::Made<Panorama> readPanorama(const std::string& path);

}  // namespace vitrine
