#pragma once

#include "exhibits/printing/interlace.h"

#include <cstdint>

namespace vitrine::lenticular {

/// What is added to a code before it is rounded down, 0 to 1: an ordered pattern without visible period, even over
/// every small neighborhood. It depends on the place on the raster and nothing else.
/// J. Jimenez, Next generation post processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014 (interleaved
/// gradient noise).
[[nodiscard]] double ditherAt(std::int64_t x, std::int64_t y, int channel);

/// Codes of 8 bits from codes of 16, a region's rows without padding. Codes that 8 bits have stay as they are.
void ditherRows(const Region&, const std::uint16_t* from, std::uint8_t* to);

}  // namespace vitrine::lenticular
