#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::render {

/// Deflates one piece of a stream after the other, for pictures' rows after their filter: fast, and as small as zlib's
/// level 1. Pieces know nothing of each other and end with whole bytes, so that they can be made at the same time and
/// put in a row. The same bytes on every machine.
/// P. Deutsch, DEFLATE Compressed Data Format Specification version 1.3, RFC 1951, 1996. Strings are looked for as
/// libdeflate's level 1 does it (E. Biggers, 2021): two candidates for each four bytes, the longer match is taken.
class PieceDeflater {
public:
    PieceDeflater();

    /// Appends `data`, at most 2^30 bytes, as blocks of which none is the last, then an empty stored one.
    void append(std::span<const std::uint8_t> data, std::vector<std::uint8_t>& out);

    /// A match after some bytes that are written as they are; the last of a block has length 0.
    struct Sequence {
        std::uint32_t literals;
        std::uint16_t length, distance;
    };

private:
    std::size_t findMatches(std::span<const std::uint8_t> data, std::size_t begin);

    std::vector<std::uint16_t> table_;  ///< For eight bytes' hash the last place, modulo 2^16.
    std::vector<Sequence> sequences_;   ///< Of the present block.
    std::vector<std::uint8_t> written_;
};

}  // namespace vitrine::render
