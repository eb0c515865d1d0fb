#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::render {
namespace {

/// Clamps to [0, 1]; NaN gives 0.
double unit(float x)
{
    return x > 0 ? std::min(static_cast<double>(x), 1.0) : 0.0;
}

}  // namespace

double srgbFromLinear(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linearFromSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb8FromLinear(float linear)
{
    // Linear values halfway between two codes: searching them is far faster than pow.
    static const std::array<double, 255> halfway = [] {
        std::array<double, 255> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table.at(i) = linearFromSrgb((static_cast<double>(i) + 0.5) / 255);
        return table;
    }();
    // Start of the search for each cell of values. Codes are never closer than a cell, so at most two must be compared.
    constexpr std::size_t cells = 4096;
    static const std::array<std::uint8_t, cells + 1> first = [] {
        std::array<std::uint8_t, cells + 1> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table.at(i) = static_cast<std::uint8_t>(
                std::upper_bound(halfway.begin(), halfway.end(), static_cast<double>(i) / cells) - halfway.begin());
        return table;
    }();
    const double x = unit(linear);
    std::size_t code = first[static_cast<std::size_t>(x * cells)];
    while (code < halfway.size() && halfway[code] <= x) ++code;
    return static_cast<std::uint8_t>(code);
}

std::uint16_t srgb16FromLinear(float linear)
{
    return static_cast<std::uint16_t>(std::lround(65535 * srgbFromLinear(unit(linear))));
}

std::uint8_t code8(float value)
{
    return static_cast<std::uint8_t>(std::lround(255 * unit(value)));
}

std::uint16_t code16(float value)
{
    return static_cast<std::uint16_t>(std::lround(65535 * unit(value)));
}

}  // namespace vitrine::render
