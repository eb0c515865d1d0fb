#pragma once

#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// Picture of all directions, which the user provides in place of a sky.
struct Panorama {
    std::shared_ptr<const render::Texture> picture;
    double brightest = 0;  ///< Its largest value; 1 for pictures stored as bytes. NaN and infinity count as 0.
    /// Full sentences that name the file: contents that are not shown, and whether it is stretched.
    std::vector<std::string> notes{};
};

/// Returns a full sentence if a picture is stretched over the sky, because it is not twice as wide as high. The
/// tolerance is two percent of its height, or one pixel. Otherwise empty.
[[nodiscard]] std::string stretchedSky(const render::Texture&, const std::string& path);

/// Reads a panorama for `AssetStore::get`. Throws if the file cannot be read.
[[nodiscard]] render::AssetStore::Made<Panorama> readPanorama(const std::string& path);

}  // namespace vitrine
