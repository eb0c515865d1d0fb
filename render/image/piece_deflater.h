#pragma once

#include "render/image/raw_bytes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace vitrine::render {

/// Deflates a stream in independent pieces, for filtered rows of pictures, by Intel's ISA-L. Each piece ends on a whole
/// byte, so pieces can be made in parallel and concatenated. The bytes are the same in every run on the same machine;
/// another processor may find other matches.
/// P. Deutsch, DEFLATE Compressed Data Format Specification version 1.3, RFC 1951, 1996.
class PieceDeflater {
public:
    PieceDeflater();
    ~PieceDeflater();
    PieceDeflater(const PieceDeflater&) = delete;
    PieceDeflater& operator=(const PieceDeflater&) = delete;

    /// Appends `data`, at most 2^30 bytes, as blocks without the final flag, then an empty stored block.
    void append(std::span<const std::uint8_t> data, RawBytes& out);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
