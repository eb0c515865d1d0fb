#pragma once

#include "render/image/raw_bytes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace vitrine::render {

/// Deflates one piece of a stream after the other, for pictures' rows after their filter, by Intel's ISA-L. Pieces know
/// nothing of each other and end with whole bytes, so that they can be made at the same time and put in a row.
/// The same bytes in every run on the same machine; another processor may find other matches.
/// P. Deutsch, DEFLATE Compressed Data Format Specification version 1.3, RFC 1951, 1996.
class PieceDeflater {
public:
    PieceDeflater();
    ~PieceDeflater();
    PieceDeflater(const PieceDeflater&) = delete;
    PieceDeflater& operator=(const PieceDeflater&) = delete;

    /// Appends `data`, at most 2^30 bytes, as blocks of which none is the last, then an empty stored one.
    void append(std::span<const std::uint8_t> data, RawBytes& out);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
