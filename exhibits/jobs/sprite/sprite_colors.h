#pragma once

#include "exhibits/jobs/sprite/sprite_sheet.h"

#include <array>
#include <map>
#include <vector>

namespace vitrine::jobs {

/// Mapping of frames to the colors of one palette: the nearest color in Oklab, with dithering.
class SpriteColors {
public:
    /// `palette` must not be empty.
    SpriteColors(const std::vector<Rgb8>& palette, SpriteDither);

    /// Returns a frame (linear, straight alpha) in colors of the palette. Ordered dithering chooses one of sixteen
    /// colors, whose mean is the wanted color, by the pixel's position in the frame (after Knoll 1999, US 6606166,
    /// "Pattern dithering", and Bayer 1973). Blue noise chooses it by a pattern without a grid. Error diffusion is that
    /// of Floyd and Steinberg 1976, in linear light, among visible pixels.
    [[nodiscard]] render::Image of(const render::Image& frame);

private:
    using Pattern = std::array<std::size_t, 16>;
    [[nodiscard]] std::size_t nearest(const glm::vec3& linear);
    [[nodiscard]] const Pattern& patternOf(const glm::vec3& linear);
    [[nodiscard]] render::Image diffused(const render::Image&);

    std::vector<glm::vec3> linear_, lab_;
    SpriteDither dither_;
    std::map<std::array<float, 3>, std::size_t> nearest_;  ///< Each color is looked up once.
    std::map<std::array<float, 3>, Pattern> patterns_;
};

}  // namespace vitrine::jobs
