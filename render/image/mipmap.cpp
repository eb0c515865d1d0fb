#include "render/image/mipmap.h"

#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vitrine::render {
namespace {

/// Along one axis: the texels of the larger level that one texel covers, and their weights.
struct Cover {
    int first = 0, count = 0;
    std::array<float, 3> weights{};
};

Cover coverOf(int texel, int size)
{
    if (size == 1) return {0, 1, {1, 0, 0}};
    if (size % 2 == 0) return {2 * texel, 2, {0.5F, 0.5F, 0}};
    const int half = size / 2;
    const auto whole = static_cast<float>(size);
    return {2 * texel,
            3,
            {static_cast<float>(half - texel) / whole, static_cast<float>(half) / whole,
             static_cast<float>(texel + 1) / whole}};
}

constexpr int mostLinear = 65535;

struct SrgbTables {
    std::array<std::uint16_t, 256> linear{};
    std::array<std::uint8_t, mostLinear + 1> code{};
};

const SrgbTables& srgbTables()
{
    static const SrgbTables tables = [] {
        SrgbTables t;
        for (std::size_t i = 0; i < t.linear.size(); ++i)
            t.linear.at(i) = code16(static_cast<float>(linearFromSrgb(static_cast<double>(i) / 255)));
        for (std::size_t i = 0; i < t.code.size(); ++i)
            t.code.at(i) = srgb8FromLinear(static_cast<float>(i) / mostLinear);
        return t;
    }();
    return tables;
}

/// Conversions of a channel's values for averaging and for storing.
struct Linear8 {
    static float read(std::uint8_t code) { return code; }
    static std::uint8_t write(float mean) { return static_cast<std::uint8_t>(std::lround(mean)); }
};
struct Srgb8 {
    const SrgbTables& tables = srgbTables();
    [[nodiscard]] float read(std::uint8_t code) const { return tables.linear[code]; }
    [[nodiscard]] std::uint8_t write(float mean) const
    {
        return tables.code[static_cast<std::size_t>(std::lround(mean))];
    }
};
struct Float {
    static float read(float value) { return value; }
    static float write(float mean) { return mean; }
};

/// Downsamples a channel of one layer; `stride` is the distance from texel to texel.
template <typename Value, typename Channel>
void halveChannel(const Channel& channel, const Value* from, int width, int height, std::size_t stride, Value* to)
{
    const int toWidth = std::max(width / 2, 1);
    const int toHeight = std::max(height / 2, 1);
    for (int y = 0; y < toHeight; ++y) {
        const Cover rows = coverOf(y, height);
        for (int x = 0; x < toWidth; ++x, to += stride) {
            const Cover columns = coverOf(x, width);
            float mean = 0;
            for (int r = 0; r < rows.count; ++r) {
                const Value* at = from + (static_cast<std::size_t>(rows.first + r) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(columns.first)) *
                                             stride;
                float sum = 0;
                for (int c = 0; c < columns.count; ++c, at += stride)
                    sum += columns.weights[static_cast<std::size_t>(c)] * channel.read(*at);
                mean += rows.weights[static_cast<std::size_t>(r)] * sum;
            }
            *to = channel.write(mean);
        }
    }
}

/// The same for all channels at once, if both sides are even, the usual case: the mean of four texels in integers.
template <typename Linear, typename Code>
void halveEven(const Texture& texture, const std::uint8_t* from, std::uint8_t* to, Linear linear, Code code)
{
    const auto channels = static_cast<std::size_t>(texture.channels);
    const std::size_t stride = static_cast<std::size_t>(texture.width) * channels;
    for (int y = 0; y < texture.height / 2; ++y, from += 2 * stride) {
        const std::uint8_t* at = from;
        for (int x = 0; x < texture.width / 2; ++x, at += 2 * channels)
            for (std::size_t c = 0; c < channels; ++c)
                *to++ = code((linear(at[c]) + linear(at[c + channels]) + linear(at[c + stride]) +
                              linear(at[c + channels + stride]) + 2) /
                             4);
    }
}

void halveLayer(const Texture& from, const std::uint8_t* in, std::uint8_t* out)
{
    const auto channels = static_cast<std::size_t>(from.channels);
    const bool even = from.width % 2 == 0 && from.height % 2 == 0;
    const bool colors = from.sRgb && channels > 1;
    if (even && !colors)
        return halveEven(
            from, in, out, [](std::uint8_t code) { return static_cast<int>(code); },
            [](int mean) { return static_cast<std::uint8_t>(mean); });
    if (even && channels == 3)
        return halveEven(
            from, in, out, [&t = srgbTables()](std::uint8_t code) { return static_cast<int>(t.linear[code]); },
            [&t = srgbTables()](int mean) { return t.code[static_cast<std::size_t>(mean)]; });
    for (std::size_t c = 0; c < channels; ++c) {
        if (colors && c < 3)
            halveChannel(Srgb8{}, in + c, from.width, from.height, channels, out + c);
        else
            halveChannel(Linear8{}, in + c, from.width, from.height, channels, out + c);
    }
}

}  // namespace

Texture halved(const Texture& from)
{
    Texture to;
    to.name = from.name;
    to.width = std::max(from.width / 2, 1);
    to.height = std::max(from.height / 2, 1);
    to.channels = from.channels;
    to.sRgb = from.sRgb;
    to.repeat = from.repeat;
    to.mipmaps = from.mipmaps;
    to.layers = from.layers;
    const auto channels = static_cast<std::size_t>(from.channels);
    const std::size_t samples = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height) * channels;
    const std::size_t fewer = static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * channels;
    const auto layers = static_cast<std::size_t>(from.layers);
    to.bytes.resize(from.floats.empty() ? fewer * layers : 0);
    to.floats.resize(from.floats.empty() ? 0 : fewer * layers);
    for (std::size_t layer = 0; layer < layers; ++layer) {
        if (from.floats.empty()) {
            halveLayer(from, from.bytes.data() + layer * samples, to.bytes.data() + layer * fewer);
            continue;
        }
        for (std::size_t c = 0; c < channels; ++c)
            halveChannel(Float{}, from.floats.data() + layer * samples + c, from.width, from.height, channels,
                         to.floats.data() + layer * fewer + c);
    }
    return to;
}

}  // namespace vitrine::render
