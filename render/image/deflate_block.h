#pragma once

#include "render/image/piece_deflater.h"

#include <bit>
#include <cstring>

namespace vitrine::render {

/// Bits into bytes, lowest first.
class BitWriter {
public:
    /// `at` must have room for all that follows and 8 bytes more.
    explicit BitWriter(std::uint8_t* at) : at_(at) {}

    /// Goes on elsewhere; the bits that were held stay. After `flush`.
    void restart(std::uint8_t* at) { at_ = at; }

    /// Up to 57 bits at a time between two calls of `flush`; those of `value` above `bits` must be 0.
    void put(std::uint64_t value, unsigned bits)
    {
        held_ |= value << count_;
        count_ += bits;
    }
    /// Whole bytes go out; fewer than 8 bits stay.
    void flush()
    {
        const std::uint64_t low = std::endian::native == std::endian::little ? held_ : __builtin_bswap64(held_);
        std::memcpy(at_, &low, sizeof low);
        const unsigned bytes = count_ / 8;
        at_ += bytes;
        held_ >>= 8 * bytes;
        count_ %= 8;
    }
    /// Zeros up to the next byte.
    void align()
    {
        count_ = (count_ + 7) / 8 * 8;
        flush();
    }
    /// After `align`.
    void copy(const std::uint8_t* bytes, std::size_t size);

    [[nodiscard]] std::uint8_t* end() const { return at_; }

private:
    std::uint8_t* at_;
    std::uint64_t held_ = 0;
    unsigned count_ = 0;
};

/// Writes a block that is not the last: with a Huffman code of its own, or stored where that is no longer.
/// `data` are its bytes, `sequences` what they are made of.
void writeBlock(std::span<const std::uint8_t> data, std::span<const PieceDeflater::Sequence> sequences, BitWriter&);

/// A stored block of these bytes (blocks, beyond 65535), none of them the last; an empty one ends with a whole byte.
void writeStored(std::span<const std::uint8_t> data, BitWriter&);

}  // namespace vitrine::render
