#include "exhibits/jobs/sprite/sprite_colors.h"

#include "exhibits/kit/blue_noise.h"
#include "exhibits/pixel_art/palette.h"

#include <algorithm>

namespace vitrine::jobs {
namespace {

using render::Image;

constexpr std::array<std::size_t, 16> bayer{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

glm::vec3 colorAt(const Image& image, int x, int y)
{
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

void setColor(Image& image, int x, int y, const glm::vec3& color)
{
    for (int k = 0; k < 3; ++k) image.at(x, y, k) = color[k];
}

/// Returns which of the sixteen colors a pixel of a frame gets.
std::size_t rankAt(SpriteDither dither, int x, int y)
{
    if (dither == SpriteDither::ordered) return bayer[static_cast<std::size_t>(4 * (y % 4) + x % 4)];
    const render::Texture& noise = *blueNoise();
    return noise.bytes[static_cast<std::size_t>(noise.width * (y % noise.height) + x % noise.width)] / 16U;
}

float luminanceOf(const glm::vec3& linear)
{
    return glm::dot(linear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

}  // namespace

SpriteColors::SpriteColors(const std::vector<Rgb8>& palette, SpriteDither dither) : dither_(dither)
{
    for (const Rgb8& c : palette) {
        linear_.push_back(pixel_art::linearOf(c));
        lab_.push_back(pixel_art::oklab(linear_.back()));
    }
}

std::size_t SpriteColors::nearest(const glm::vec3& linear)
{
    const auto search = [&] {
        const glm::vec3 wanted = pixel_art::oklab(glm::clamp(linear, 0.0F, 1.0F));
        std::size_t found = 0;
        float least = 1e9F;
        for (std::size_t i = 0; i < lab_.size(); ++i)
            if (const glm::vec3 d = lab_[i] - wanted; glm::dot(d, d) < least) {
                least = glm::dot(d, d);
                found = i;
            }
        return found;
    };
    if (dither_ != SpriteDither::none) return search();  // Hardly any color comes twice.
    const auto [at, isNew] = nearest_.try_emplace({linear.r, linear.g, linear.b}, 0);
    if (isNew) at->second = search();
    return at->second;
}

const SpriteColors::Pattern& SpriteColors::patternOf(const glm::vec3& linear)
{
    const auto [at, isNew] = patterns_.try_emplace({linear.r, linear.g, linear.b});
    Pattern& pattern = at->second;
    if (!isNew) return pattern;
    const glm::vec3 wanted = glm::clamp(linear, 0.0F, 1.0F);
    glm::vec3 owed(0);
    for (std::size_t& index : pattern) {
        index = nearest(wanted + owed);
        owed += wanted - linear_[index];
    }
    std::stable_sort(pattern.begin(), pattern.end(), [this](std::size_t a, std::size_t b) {
        return luminanceOf(linear_[a]) < luminanceOf(linear_[b]);
    });
    return pattern;
}

Image SpriteColors::diffused(const Image& frame)
{
    Image wanted = frame, made = frame;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            if (!isSeen(frame, x, y)) continue;
            // The accumulated error may exceed the range of colors, but it must not grow without limit if no palette
            // color is near.
            const glm::vec3 here = glm::clamp(colorAt(wanted, x, y), -1.0F, 2.0F);
            const glm::vec3 color = linear_[nearest(here)];
            setColor(made, x, y, color);
            const auto hand = [&](int toX, int toY, float share) {
                if (toX < 0 || toX >= frame.width || toY >= frame.height || !isSeen(frame, toX, toY)) return;
                setColor(wanted, toX, toY, colorAt(wanted, toX, toY) + share * (here - color));
            };
            hand(x + 1, y, 7.0F / 16);
            hand(x - 1, y + 1, 3.0F / 16);
            hand(x, y + 1, 5.0F / 16);
            hand(x + 1, y + 1, 1.0F / 16);
        }
    return made;
}

Image SpriteColors::of(const Image& frame)
{
    if (dither_ == SpriteDither::errorDiffusion) return diffused(frame);
    Image made = frame;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            if (!isSeen(frame, x, y)) continue;
            const glm::vec3 color = colorAt(frame, x, y);
            const bool plain = dither_ == SpriteDither::none;
            setColor(made, x, y, linear_[plain ? nearest(color) : patternOf(color)[rankAt(dither_, x, y)]]);
        }
    return made;
}

}  // namespace vitrine::jobs
