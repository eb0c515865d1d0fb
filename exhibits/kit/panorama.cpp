#include "exhibits/kit/panorama.h"

#include "render/image/image_io.h"
#include "render/scene/held_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace vitrine {
namespace {

double brightestOf(const render::Texture& picture)
{
    if (picture.floats.empty()) return 1;
    double brightest = 0;
    for (const float value : picture.floats)
        if (std::isfinite(value)) brightest = std::max(brightest, static_cast<double>(value));
    return brightest;
}

}  // namespace

render::AssetStore::Made<Panorama> readPanorama(const std::string& path)
{
    auto picture = render::loadTexture(path, true, true);
    const double brightest = brightestOf(*picture);
    const std::uint64_t bytes = heldBytes(*picture);
    return {std::make_shared<Panorama>(Panorama{std::move(picture), brightest}), bytes};
}

}  // namespace vitrine
