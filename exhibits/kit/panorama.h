#pragma once

#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

#include <memory>
#include <string>

namespace vitrine {

/// A picture of all directions, as the visitor gives one in place of a sky.
struct Panorama {
    std::shared_ptr<const render::Texture> picture;
    double brightest = 0;  ///< Its largest value; 1 for what is stored as bytes. NaN and infinity count as 0.
};

/// For `AssetStore::get`. Throws where the file cannot be read.
[[nodiscard]] render::AssetStore::Made<Panorama> readPanorama(const std::string& path);

}  // namespace vitrine
