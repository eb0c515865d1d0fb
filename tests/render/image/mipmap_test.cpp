// Mipmaps made on the CPU, compared with means over every texel's area in double precision.

#include "render/image/mipmap.h"
#include "render/image/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using vitrine::render::halved;
using vitrine::render::Texture;

Texture noiseOf(int width, int height, int channels, bool sRgb, int layers = 1)
{
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.channels = channels;
    texture.sRgb = sRgb;
    texture.layers = layers;
    std::mt19937 random(7);
    texture.bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                         static_cast<std::size_t>(channels) * static_cast<std::size_t>(layers));
    for (std::uint8_t& code : texture.bytes) code = static_cast<std::uint8_t>(random());
    return texture;
}

double shown(const Texture& texture, int x, int y, int c, int layer)
{
    const int row = layer * texture.height + y;
    const auto at = static_cast<std::size_t>((row * texture.width + x) * texture.channels + c);
    if (!texture.floats.empty()) return static_cast<double>(texture.floats[at]);
    const double code = texture.bytes[at] / 255.0;
    return texture.sRgb && texture.channels > 1 && c < 3 ? vitrine::render::linearFromSrgb(code) : code;
}

/// Returns the mean over [x0, x1] x [y0, y1], in texels.
/// Part of a texture, in texels.
struct Area {
    double x0, x1, y0, y1;
};

double meanOver(const Texture& texture, const Area& area, int c, int layer)
{
    const auto [x0, x1, y0, y1] = area;
    double sum = 0;
    for (int y = 0; y < texture.height; ++y)
        for (int x = 0; x < texture.width; ++x) {
            const double wide = std::max(std::min(x1, x + 1.0) - std::max<double>(x0, x), 0.0);
            const double high = std::max(std::min(y1, y + 1.0) - std::max<double>(y0, y), 0.0);
            sum += wide * high * shown(texture, x, y, c, layer);
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

/// Returns the largest difference from the mean of the area, in stored codes.
double worstError(const Texture& from)
{
    const Texture to = halved(from);
    double worst = 0;
    for (int layer = 0; layer < from.layers; ++layer)
        for (int y = 0; y < to.height; ++y)
            for (int x = 0; x < to.width; ++x)
                for (int c = 0; c < from.channels; ++c) {
                    const double sx = static_cast<double>(from.width) / to.width;
                    const double sy = static_cast<double>(from.height) / to.height;
                    double wanted = meanOver(from, {x * sx, (x + 1) * sx, y * sy, (y + 1) * sy}, c, layer);
                    double is = shown(to, x, y, c, layer);
                    if (from.sRgb && from.channels > 1 && c < 3) {
                        wanted = vitrine::render::srgbFromLinear(wanted);
                        is = vitrine::render::srgbFromLinear(is);
                    }
                    worst = std::max(worst, std::abs(is - wanted) * 255);
                }
    return worst;
}

}  // namespace

TEST(Mipmap, IsTheMeanOfTheAreaInLinearLightWhateverTheSize)
{
    for (const int channels : {1, 3, 4})
        for (const bool sRgb : {false, true})
            for (const auto& [width, height] :
                 {std::pair{8, 6}, {7, 5}, {8, 5}, {7, 4}, {1, 9}, {6, 1}, {2, 2}, {3, 3}})
                EXPECT_LE(worstError(noiseOf(width, height, channels, sRgb)), 0.51)
                    << channels << (sRgb ? " of sRGB, " : ", ") << width << " x " << height;
}

TEST(Mipmap, OfALayerIsMadeOfThatLayer)
{
    EXPECT_LE(worstError(noiseOf(6, 4, 3, true, 3)), 0.51);
    EXPECT_LE(worstError(noiseOf(5, 4, 1, false, 2)), 0.51);
}

TEST(Mipmap, OfFloatsKeepsWhatIsBeyondOne)
{
    Texture texture = noiseOf(5, 6, 4, false);
    std::mt19937 random(3);
    for (std::size_t i = 0; i < texture.bytes.size(); ++i)
        texture.floats.push_back(static_cast<float>(random() % 100000) / 100);
    texture.bytes.clear();
    const Texture to = halved(texture);
    ASSERT_EQ(to.floats.size(), 2U * 3 * 4);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(shown(to, 1, 2, c, 0), meanOver(texture, {2.5, 5, 4, 6}, c, 0), 1e-3);
}

TEST(Mipmap, OfOneColorIsThatColor)
{
    for (int code = 0; code < 256; ++code) {
        Texture texture = noiseOf(4, 3, 3, true);
        std::fill(texture.bytes.begin(), texture.bytes.end(), static_cast<std::uint8_t>(code));
        const Texture to = halved(texture);
        EXPECT_TRUE(std::all_of(to.bytes.begin(), to.bytes.end(), [code](std::uint8_t is) { return is == code; }))
            << code;
    }
}
