#include "render/image/piece_deflater.h"

#include "render/image/deflate_block.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace vitrine::render {
namespace {

/// Shorter matches take more bits than their bytes do where a filter has made most of them small; prints with shorter
/// ones are larger and take longer.
constexpr std::size_t shortest = 8;
constexpr std::size_t longest = 258;
constexpr std::size_t farthest = 32768;
constexpr unsigned tableBits = 12;  // 8 KB stay in the first cache.
constexpr std::size_t blockBytes = 1U << 16U;
constexpr std::size_t blockSequences = 1U << 13U;
/// After so many bytes without a match, the next ones are tried more rarely: noise has none.
constexpr std::size_t patience = 64;
/// Of a long match the first bytes are enough to find it again.
constexpr std::size_t enteredOfMatch = 4;

std::uint64_t eight(const std::uint8_t* at)
{
    std::uint64_t value = 0;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// The same everywhere.
std::size_t slotOf(std::uint64_t value)
{
    if constexpr (std::endian::native == std::endian::big) value = __builtin_bswap64(value);
    return (value * 0x9E3779B97F4A7C15U) >> (64U - tableBits);  // Knuth's multiplicative hash.
}

/// How many bytes from `a` and `b` on are equal; `most` may be read at both.
std::size_t equalBytes(const std::uint8_t* a, const std::uint8_t* b, std::size_t most)
{
    std::size_t n = 0;
    for (; n + 8 <= most; n += 8) {
        if (const std::uint64_t differing = eight(a + n) ^ eight(b + n)) {
            const int zeros =
                std::endian::native == std::endian::little ? std::countr_zero(differing) : std::countl_zero(differing);
            return n + static_cast<std::size_t>(zeros) / 8;
        }
    }
    while (n < most && a[n] == b[n]) ++n;
    return n;
}

}  // namespace

PieceDeflater::PieceDeflater()
    : table_(std::size_t{1} << tableBits), written_(blockBytes + 256)  // Stored blocks at worst.
{
    sequences_.reserve(blockSequences);
}

/// Fills `sequences_` with the block that begins at `begin`; returns its end.
std::size_t PieceDeflater::findMatches(std::span<const std::uint8_t> data, std::size_t begin)
{
    const std::uint8_t* const bytes = data.data();
    const std::size_t end = std::min(begin + blockBytes, data.size());
    std::size_t literal = begin;
    std::size_t at = begin;
    sequences_.clear();
    while (at + shortest <= end && sequences_.size() + 1 < blockSequences) {
        const std::uint64_t value = eight(bytes + at);
        std::size_t distance = 1;
        if (at == 0 || value != eight(bytes + at - 1)) {
            std::uint16_t& slot = table_[slotOf(value)];
            distance = (at - slot) & 0xFFFFU;
            slot = static_cast<std::uint16_t>(at);
            // Whatever the table says, and it forgets what is far: the bytes are the same, or it is no match.
            if (distance == 0 || distance > std::min(at, farthest) || eight(bytes + at - distance) != value) {
                at += 1 + (at - literal) / patience;
                continue;
            }
        }
        const std::uint8_t* const beyond = bytes + at + shortest;
        const std::size_t length =
            shortest + equalBytes(beyond, beyond - distance, std::min(longest, end - at) - shortest);
        sequences_.push_back({static_cast<std::uint32_t>(at - literal), static_cast<std::uint16_t>(length),
                              static_cast<std::uint16_t>(distance)});
        if (distance > 1) {
            const std::size_t entered = std::min(at + enteredOfMatch, end - shortest + 1);
            for (std::size_t place = at + 1; place < entered; ++place)
                table_[slotOf(eight(bytes + place))] = static_cast<std::uint16_t>(place);
        }
        at += length;
        literal = at;
    }
    if (sequences_.size() + 1 < blockSequences) at = end;  // Otherwise it ends with a match.
    sequences_.push_back({static_cast<std::uint32_t>(at - literal), 0, 0});
    return at;
}

void PieceDeflater::append(std::span<const std::uint8_t> data, std::vector<std::uint8_t>& out)
{
    assert(data.size() <= std::size_t{1} << 30U);
    std::fill(table_.begin(), table_.end(), std::uint16_t{0});
    BitWriter writer(written_.data());
    const auto takeOver = [&] {
        out.insert(out.end(), written_.data(), writer.end());
        writer.restart(written_.data());
    };
    for (std::size_t at = 0; at < data.size(); takeOver()) {
        const std::size_t end = findMatches(data, at);
        writeBlock(data.subspan(at, end - at), sequences_, writer);
        at = end;
    }
    writeStored({}, writer);
    takeOver();
}

}  // namespace vitrine::render
