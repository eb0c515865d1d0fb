#include "exhibits/your_shader/guest_pictures.h"

#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "render/scene/held_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace vitrine::guest {
namespace {

/// Turns the rows of a picture over.
template <typename T> void turnOver(std::vector<T>& values, int height)
{
    if (values.empty() || height < 2) return;
    const auto row = static_cast<std::ptrdiff_t>(values.size() / static_cast<std::size_t>(height));
    for (std::ptrdiff_t low = 0, high = height - 1; low < high; ++low, --high)
        std::swap_ranges(values.begin() + low * row, values.begin() + (low + 1) * row, values.begin() + high * row);
}

}  // namespace

render::AssetStore::Made<render::Texture> readPicture(const std::string& path, bool mipmaps)
{
    auto picture = std::make_shared<render::Texture>(*render::loadTexture(path, true, false));
    picture->sRgb = false;
    picture->mipmaps = mipmaps;
    for (std::size_t i = 0; i < picture->floats.size(); ++i) {
        const bool isAlpha = picture->channels == 4 && i % 4 == 3;
        if (!isAlpha) picture->floats[i] = static_cast<float>(render::srgbFromLinear(picture->floats[i]));
    }
    turnOver(picture->bytes, picture->height);
    turnOver(picture->floats, picture->height);
    const std::uint64_t bytes = heldBytes(*picture);
    return {std::move(picture), bytes};
}

std::shared_ptr<const render::Texture> testPicture(bool mipmaps)
{
    const auto make = [](bool hasMipmaps) {
        constexpr int side = 512;
        auto made = std::make_shared<render::Texture>();
        made->name = "test_picture";
        made->width = made->height = side;
        made->repeat = false;
        made->mipmaps = hasMipmaps;
        const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double u = (x + 0.5) / side, v = (y + 0.5) / side;
                const double ring = 0.5 + 0.5 * std::cos(40 * std::hypot(u - 0.5, v - 0.5));
                const double diagonal = std::fmod(8 * (u + v), 2.0) < 1 ? 1 : 0.75;
                for (const double color : {u * diagonal, ring * diagonal, v * diagonal, 1.0})
                    made->bytes.push_back(byte(color));
            }
        return made;
    };
    static const std::shared_ptr<const render::Texture> withMipmaps = make(true), without = make(false);
    return mipmaps ? withMipmaps : without;
}

std::shared_ptr<const render::Texture> blackPicture()
{
    static const auto black = [] {
        auto made = std::make_shared<render::Texture>();
        made->name = "black";
        made->width = made->height = 1;
        made->bytes = {0, 0, 0, 255};
        made->mipmaps = false;
        return made;
    }();
    return black;
}

}  // namespace vitrine::guest
