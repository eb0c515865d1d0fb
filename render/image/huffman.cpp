#include "render/image/huffman.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace vitrine::render {
namespace {

constexpr std::size_t mostSymbols = 288;
constexpr std::size_t mostBits = 15;

struct Symbol {
    std::uint32_t count;
    std::uint16_t index;
};

/// How deep the leaves of the optimal tree lie: `depths[i]` is that of the i-th symbol, counts rising. Leaves and inner
/// nodes stand in two queues, both by rising count.
void leafDepths(std::span<const Symbol> symbols, std::span<std::uint16_t> depths)
{
    const std::size_t leaves = symbols.size();
    std::array<std::uint64_t, mostSymbols> innerCount{};
    std::array<std::uint16_t, 2 * mostSymbols> parent{};  // Leaves first, then inner nodes.
    std::size_t leaf = 0;
    std::size_t inner = 0;
    for (std::size_t made = 0; made + 1 < leaves; ++made) {
        for (int side = 0; side < 2; ++side) {
            const bool takesLeaf = inner == made || (leaf < leaves && symbols[leaf].count <= innerCount.at(inner));
            innerCount.at(made) += takesLeaf ? symbols[leaf].count : innerCount.at(inner);
            parent.at(takesLeaf ? leaf++ : leaves + inner++) = static_cast<std::uint16_t>(leaves + made);
        }
    }
    const std::size_t nodes = 2 * leaves - 1;
    std::array<std::uint16_t, 2 * mostSymbols> depth{};
    for (std::size_t node = nodes - 1; node-- > 0;)
        depth.at(node) = static_cast<std::uint16_t>(depth.at(parent.at(node)) + 1);
    std::copy_n(depth.begin(), leaves, depths.begin());
}

/// Moves leaves up to `longest`, and others down until all fit again.
void limit(std::array<std::uint32_t, mostSymbols>& perLength, std::size_t longest)
{
    std::uint32_t taken = 0;  // In parts of 2^longest.
    for (std::size_t bits = longest + 1; bits < perLength.size(); ++bits) {
        perLength.at(longest) += perLength.at(bits);
        perLength.at(bits) = 0;
    }
    for (std::size_t bits = 1; bits <= longest; ++bits) taken += perLength.at(bits) << (longest - bits);
    for (; taken > 1U << longest; --taken) {
        --perLength.at(longest);
        std::size_t bits = longest - 1;
        while (perLength.at(bits) == 0) --bits;
        --perLength.at(bits);
        perLength.at(bits + 1) += 2;
    }
}

}  // namespace

void huffmanLengths(std::span<const std::uint32_t> counts, int longest, std::span<std::uint8_t> lengths)
{
    assert(counts.size() <= mostSymbols && lengths.size() == counts.size());
    std::array<Symbol, mostSymbols> symbols{};
    std::size_t used = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) symbols.at(used++) = {counts[i], static_cast<std::uint16_t>(i)};
    std::fill(lengths.begin(), lengths.end(), std::uint8_t{0});
    if (used == 0) return;
    if (used == 1) {
        lengths[symbols[0].index] = 1;
        return;
    }
    std::sort(
        symbols.begin(), symbols.begin() + static_cast<std::ptrdiff_t>(used),
        [](const Symbol& a, const Symbol& b) { return a.count != b.count ? a.count < b.count : a.index < b.index; });
    std::array<std::uint16_t, mostSymbols> depths{};
    leafDepths({symbols.data(), used}, depths);
    std::array<std::uint32_t, mostSymbols> perLength{};
    for (std::size_t i = 0; i < used; ++i) ++perLength.at(depths.at(i));
    limit(perLength, static_cast<std::size_t>(longest));
    std::size_t at = 0;  // The rarest symbols get the longest codes.
    for (auto bits = static_cast<std::size_t>(longest); bits > 0; --bits)
        for (std::uint32_t i = 0; i < perLength.at(bits); ++i)
            lengths[symbols.at(at++).index] = static_cast<std::uint8_t>(bits);
}

void huffmanCodes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes)
{
    std::array<std::uint32_t, mostBits + 2> next{};
    for (const std::uint8_t bits : lengths)
        if (bits > 0) ++next.at(bits + 1U);
    for (std::size_t bits = 1; bits < next.size(); ++bits) next.at(bits) = (next.at(bits) + next.at(bits - 1)) << 1U;
    // next[b] is now the first code of b bits, shifted as RFC 1951 does it.
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        std::uint32_t reversed = 0;
        if (lengths[i] > 0) {
            std::uint32_t code = next.at(lengths[i])++;
            for (std::uint8_t bit = 0; bit < lengths[i]; ++bit, code >>= 1U) reversed = reversed << 1U | (code & 1U);
        }
        codes[i] = static_cast<std::uint16_t>(reversed);
    }
}

}  // namespace vitrine::render
