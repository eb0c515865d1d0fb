#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::render {

/// Deflates one piece of a stream after the other, for pictures' rows after their filter, by Intel's ISA-L: several times
/// faster than zlib's level 1 at about its size. Pieces know nothing of each other and end with whole bytes, so that they
/// can be made at the same time and put in a row (P. Deutsch, RFC 1951, 1996).
class PieceDeflater {
public:
    PieceDeflater();
    ~PieceDeflater();

    /// Appends `data`, at most 2^30 bytes, as blocks of which none is the last, then an empty stored one.
    void append(std::span<const std::uint8_t> data, std::vector<std::uint8_t>& out);

private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
};

}  // namespace vitrine::render
