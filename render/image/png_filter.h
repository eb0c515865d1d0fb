#pragma once

#include <cstddef>
#include <cstdint>

namespace vitrine::render {

/// PNG's filter types that are tried (W3C, Portable Network Graphics (PNG) Specification, third edition, 9).
enum class PngFilter : std::uint8_t { none = 0, left = 1, above = 2 };

/// Writes a row as PNG stores it ahead of compression: the filter's number, then `bytes` differences; `out` has room
/// for bytes + 1. Of the three filters the one whose differences have the least sum of absolute values (the heuristic
/// of the specification, 12.7); where others are hardly better, `kind` stays, since rows of one kind resemble each
/// other. `kind` becomes the filter that was taken. `pixel` is the size of a pixel in bytes; `above` is the row before,
/// zeros before the first.
void filterPngRow(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t pixel,
                  PngFilter& kind, std::uint8_t* out);

}  // namespace vitrine::render
