#pragma once

#include "render/files/assets.h"
#include "render/image/image_io.h"

#include <future>
#include <memory>
#include <string>

namespace vitrine::hall {

using BakedPicture = std::shared_ptr<const render::Texture>;

/// Reads a picture of light beside hall.glb on another thread, without mipmaps. The result throws Failure if it cannot
/// be read.
[[nodiscard]] inline std::future<BakedPicture> startReadingBaked(const std::string& file)
{
    return std::async(std::launch::async, [path = render::asset("models/" + file)]() -> BakedPicture {
        auto picture = std::make_shared<render::Texture>(*render::loadTexture(path, false, false));
        picture->mipmaps = false;
        return picture;
    });
}

}  // namespace vitrine::hall
