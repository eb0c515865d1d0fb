#pragma once

#include <cstddef>
#include <cstdint>

namespace vitrine::render {

/// PNG filter types in use (W3C, Portable Network Graphics (PNG) Specification, third edition, 9).
enum class PngFilter : std::uint8_t { none = 0, left = 1, above = 2 };

/// Writes a row as PNG stores it before compression: the filter's number, then `bytes` differences. `out` has room for
/// bytes + 1. It chooses the filter with the least sum of absolute differences (the heuristic of the specification,
/// 12.7). If the others are hardly better, `kind` is kept, because rows with the same filter compress better. `kind` is
/// set to the chosen filter. `pixel` is the size of a pixel in bytes; `above` is the previous row, zeros for the first.
void filterPngRow(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t pixel,
                  PngFilter& kind, std::uint8_t* out);

}  // namespace vitrine::render
