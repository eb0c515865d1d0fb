#pragma once

#include <cstdint>
#include <span>

namespace vitrine::render {

/// Lengths in bits of a Huffman code for symbols that occur `counts[i]` times, none longer than `longest` (at most 15):
/// 0 for what does not occur, 1 for a symbol that is alone. The codes that lengths give are complete where two or more
/// symbols occur. Lengths are optimal unless the limit cuts them; then close to it (the repair of the Kraft sum in
/// miniz, R. Geldreich, 2013). `counts` has at most 288 entries, and so has `lengths`.
void huffmanLengths(std::span<const std::uint32_t> counts, int longest, std::span<std::uint8_t> lengths);

/// The canonical codes of these lengths as deflate numbers them, first bit lowest (RFC 1951, 3.2.2).
void huffmanCodes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

}  // namespace vitrine::render
