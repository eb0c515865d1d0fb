#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/image/image.h"
#include "render/image/texture.h"

#include <glm/glm.hpp>

#include <memory>
#include <variant>

namespace vitrine {

/// Image with the halos of the last whole picture, and the pass that makes it.
inline constexpr const char* glareSpreadImage = "glare.spread";
inline constexpr const char* glareSpreadPass = "glare/spread";

/// Halos of a whole picture, for parts of it that are drawn by themselves.
struct Halos {
    std::shared_ptr<const render::Texture> texture;
    glm::ivec2 picture{0};  ///< Size in pixels of the picture from which they were made.
};

/// Creates the halos from the image that was read back from the GPU.
[[nodiscard]] inline std::shared_ptr<const Halos> halosOf(const render::Image& spread, glm::ivec2 picture)
{
    auto texture = std::make_shared<render::Texture>();
    texture->name = glareSpreadImage;
    texture->width = spread.width;
    texture->height = spread.height;
    texture->channels = 4;
    texture->repeat = texture->mipmaps = false;
    texture->floats.reserve(spread.pixels.size());
    for (int y = spread.height - 1; y >= 0; --y)
        for (int x = 0; x < spread.width; ++x)
            for (int c = 0; c < 4; ++c) texture->floats.push_back(c < spread.channels ? spread.at(x, y, c) : 1.0F);
    return std::make_shared<const Halos>(Halos{std::move(texture), picture});
}

/// Returns whether pictures with these values of the hall may have halos.
[[nodiscard]] inline bool mayHaveHalos(const ParameterValues& hall)
{
    const auto row = hall.table().find("glare");
    return row && std::get<double>(hall.row(*row)) > 0;
}

}  // namespace vitrine
