#pragma once

#include <cstdint>

namespace vitrine::render {

/// Transfer function of sRGB (IEC 61966-2-1), [0, 1] to [0, 1], and its inverse. Both continue beyond 1 by the same
/// formula and below 0 by the linear piece.
[[nodiscard]] double srgbFromLinear(double linear);
[[nodiscard]] double linearFromSrgb(double encoded);

/// Returns the nearest 8-bit or 16-bit code of a linear value: clamped to [0, 1], NaN gives 0.
[[nodiscard]] std::uint8_t srgb8FromLinear(float linear);
[[nodiscard]] std::uint16_t srgb16FromLinear(float linear);
/// The same without the transfer function, for alpha.
[[nodiscard]] std::uint8_t code8(float value);
[[nodiscard]] std::uint16_t code16(float value);

}  // namespace vitrine::render
