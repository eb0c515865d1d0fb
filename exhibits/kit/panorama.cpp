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

std::string stretchedSky(const render::Texture& picture, const std::string& path)
{
    if (std::abs(picture.width - 2 * picture.height) <= std::max(1, picture.height / 50)) return {};
    return path + " has " + std::to_string(picture.width) + " × " + std::to_string(picture.height) +
           " pixels and is stretched over the sky: a picture of all directions is twice as wide as high.";
}

render::AssetStore::Made<Panorama> readPanorama(const std::string& path)
{
    std::vector<std::string> notes;
    auto picture = render::loadTexture(path, true, true, {}, &notes);
    for (std::string& note : notes) note = path + ": " + note;
    if (std::string stretched = stretchedSky(*picture, path); !stretched.empty()) notes.push_back(std::move(stretched));
    const double brightest = brightestOf(*picture);
    const std::uint64_t bytes = heldBytes(*picture);
    return {std::make_shared<Panorama>(Panorama{std::move(picture), brightest, std::move(notes)}), bytes};
}

}  // namespace vitrine
