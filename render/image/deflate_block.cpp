#include "render/image/deflate_block.h"

#include "render/image/huffman.h"

#include <algorithm>
#include <array>

namespace vitrine::render {
namespace {

// RFC 1951, 3.2.5 to 3.2.7.
constexpr std::size_t literalSymbols = 286;
constexpr std::size_t distanceSymbols = 30;
constexpr std::size_t lengthSymbols = 19;
constexpr std::size_t endOfBlock = 256;
constexpr std::array<std::uint8_t, lengthSymbols> lengthOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                                 11, 4,  12, 3, 13, 2, 14, 1, 15};
constexpr int longestCode = 15;
constexpr int longestLengthCode = 7;
constexpr std::size_t mostStored = 65535;

/// A symbol and the bits that follow it.
struct Coded {
    unsigned symbol, extraBits, extra;
};

constexpr Coded codedLength(unsigned length)
{
    const unsigned at = length - 3;
    if (length == 258) return {285, 0, 0};
    if (at < 8) return {257 + at, 0, 0};
    const auto bits = static_cast<unsigned>(std::bit_width(at)) - 3;
    return {257 + 4 * (bits + 1) + ((at >> bits) & 3U), bits, at & ((1U << bits) - 1)};
}

constexpr Coded codedDistance(unsigned distance)
{
    const unsigned at = distance - 1;
    if (at < 4) return {at, 0, 0};
    const auto bits = static_cast<unsigned>(std::bit_width(at)) - 2;
    return {2 * (bits + 1) + ((at >> bits) & 1U), bits, at & ((1U << bits) - 1)};
}

constexpr auto lengthCodes = [] {
    std::array<Coded, 259> table{};
    for (unsigned length = 3; length < table.size(); ++length) table.at(length) = codedLength(length);
    return table;
}();

template <std::size_t count> struct Code {
    std::array<std::uint32_t, count> counts{};
    std::array<std::uint8_t, count> bits{};
    std::array<std::uint32_t, count> codes{};  ///< And the bits once more, from bit 16 on: both in one look.

    void make(int longest)
    {
        huffmanLengths(counts, longest, bits);
        std::array<std::uint16_t, count> plain{};
        huffmanCodes(bits, plain);
        for (std::size_t i = 0; i < count; ++i) codes[i] = std::uint32_t{bits[i]} << 16U | plain[i];
    }
    [[nodiscard]] std::uint64_t cost() const
    {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += std::uint64_t{counts[i]} * bits[i];
        return sum;
    }
    [[nodiscard]] std::size_t used(std::size_t least) const
    {
        std::size_t n = count;
        while (n > least && bits[n - 1] == 0) --n;
        return n;
    }
    void put(std::size_t symbol, BitWriter& out) const { out.put(codes[symbol] & 0xFFFFU, codes[symbol] >> 16U); }
};

/// The codes of a block and the bits that come after their symbols.
struct BlockCodes {
    Code<literalSymbols> literals{};
    Code<distanceSymbols> distances{};
    std::uint64_t extraBits = 0;

    BlockCodes(const std::uint8_t* at, std::span<const PieceDeflater::Sequence> sequences)
    {
        // Two counters each: a processor waits when it counts the same byte twice in a row.
        std::array<std::array<std::uint32_t, 256>, 2> counts{};
        for (const PieceDeflater::Sequence& sequence : sequences) {
            std::uint32_t i = 0;
            for (; i + 2 <= sequence.literals; i += 2) {
                ++counts[0][at[i]];
                ++counts[1][at[i + 1]];
            }
            if (i < sequence.literals) ++counts[0][at[i]];
            at += sequence.literals + sequence.length;
            if (sequence.length == 0) continue;
            const Coded& length = lengthCodes[sequence.length];
            const Coded distance = codedDistance(sequence.distance);
            ++literals.counts[length.symbol];
            ++distances.counts[distance.symbol];
            extraBits += length.extraBits + distance.extraBits;
        }
        for (std::size_t i = 0; i < 256; ++i) literals.counts[i] = counts[0][i] + counts[1][i];
        literals.counts[endOfBlock] = 1;
        literals.make(longestCode);
        distances.make(longestCode);
    }
};

/// The lengths of both codes, run by run, and the code that they are written in.
class Header {
public:
    explicit Header(const BlockCodes& codes) : literals_(codes.literals.used(257)), distances_(codes.distances.used(1))
    {
        std::array<std::uint8_t, literalSymbols + distanceSymbols> lengths{};
        std::copy_n(codes.literals.bits.begin(), literals_, lengths.begin());
        std::copy_n(codes.distances.bits.begin(), distances_, lengths.begin() + static_cast<std::ptrdiff_t>(literals_));
        const std::size_t all = literals_ + distances_;
        for (std::size_t i = 0; i < all;) {
            std::size_t run = 1;
            while (i + run < all && lengths.at(i + run) == lengths.at(i)) ++run;
            addRun(lengths.at(i), run);
            i += run;
        }
        code_.make(longestLengthCode);
        kept_ = lengthSymbols;
        while (kept_ > 4 && code_.bits.at(lengthOrder.at(kept_ - 1)) == 0) --kept_;
    }

    [[nodiscard]] std::uint64_t cost() const { return 3 + 5 + 5 + 4 + 3 * kept_ + code_.cost() + extraBits_; }

    void write(BitWriter& out) const
    {
        out.put(0b100, 3);  // Not the last; a code of its own.
        out.put(literals_ - 257, 5);
        out.put(distances_ - 1, 5);
        out.put(kept_ - 4, 4);
        out.flush();
        for (std::size_t i = 0; i < kept_; ++i) {
            out.put(code_.bits.at(lengthOrder.at(i)), 3);
            out.flush();
        }
        for (std::size_t i = 0; i < count_; ++i) {
            code_.put(runs_.at(i).symbol, out);
            out.put(runs_.at(i).extra, runs_.at(i).extraBits);
            out.flush();
        }
    }

private:
    void add(unsigned symbol, unsigned extraBits = 0, std::size_t extra = 0)
    {
        runs_.at(count_++) = {symbol, extraBits, static_cast<unsigned>(extra)};
        ++code_.counts.at(symbol);
        extraBits_ += extraBits;
    }
    void addRun(std::uint8_t length, std::size_t run)
    {
        while (length == 0 && run >= 11) {
            const std::size_t part = std::min<std::size_t>(run, 138);
            add(18, 7, part - 11);
            run -= part;
        }
        if (length == 0 && run >= 3) {
            add(17, 3, run - 3);
            return;
        }
        if (length != 0 && run >= 4) {
            add(length);
            for (--run; run >= 3;) {
                const std::size_t part = std::min<std::size_t>(run, 6);
                add(16, 2, part - 3);
                run -= part;
            }
        }
        for (; run > 0; --run) add(length);
    }

    std::size_t literals_, distances_;
    std::array<Coded, literalSymbols + distanceSymbols> runs_{};
    std::size_t count_ = 0;
    Code<lengthSymbols> code_{};
    std::size_t kept_ = 0;  ///< Of the lengths of `code_`.
    std::uint64_t extraBits_ = 0;
};

[[gnu::always_inline]] inline void writeLiterals(const std::uint8_t* at, std::size_t count,
                                                 const Code<literalSymbols>& code, BitWriter& out)
{
    std::size_t i = 0;
    for (; i + 3 <= count; i += 3) {  // Three of 15 bits, and 7 that were left, fit.
        code.put(at[i], out);
        code.put(at[i + 1], out);
        code.put(at[i + 2], out);
        out.flush();
    }
    for (; i < count; ++i) code.put(at[i], out);
    out.flush();
}

void writeCoded(const std::uint8_t* at, std::span<const PieceDeflater::Sequence> sequences, const BlockCodes& codes,
                BitWriter& writer)
{
    BitWriter out = writer;  // In registers: what is written could otherwise be the writer itself.
    for (const PieceDeflater::Sequence& sequence : sequences) {
        writeLiterals(at, sequence.literals, codes.literals, out);
        at += sequence.literals + sequence.length;
        if (sequence.length == 0) continue;
        const Coded& length = lengthCodes[sequence.length];
        const Coded distance = codedDistance(sequence.distance);
        codes.literals.put(length.symbol, out);
        out.put(length.extra, length.extraBits);
        codes.distances.put(distance.symbol, out);
        out.put(distance.extra, distance.extraBits);
        out.flush();  // 15, 5, 15 and 13 bits at most.
    }
    codes.literals.put(endOfBlock, out);
    out.flush();
    writer = out;
}

}  // namespace

void BitWriter::copy(const std::uint8_t* bytes, std::size_t size)
{
    std::memcpy(at_, bytes, size);
    at_ += size;
}

void writeStored(std::span<const std::uint8_t> data, BitWriter& out)
{
    std::size_t at = 0;
    do {
        const std::size_t size = std::min(data.size() - at, mostStored);
        out.put(0, 3);
        out.align();
        out.put(size, 16);
        out.put(~size & 0xFFFFU, 16);
        out.flush();
        out.copy(data.data() + at, size);
        at += size;
    } while (at < data.size());
}

void writeBlock(std::span<const std::uint8_t> data, std::span<const PieceDeflater::Sequence> sequences, BitWriter& out)
{
    const BlockCodes codes(data.data(), sequences);
    const Header header(codes);
    const std::uint64_t coded = header.cost() + codes.literals.cost() + codes.distances.cost() + codes.extraBits;
    const std::uint64_t stored = 8 * (data.size() + 5 * (data.size() / mostStored + 1));
    if (stored <= coded) {
        writeStored(data, out);
        return;
    }
    header.write(out);
    writeCoded(data.data(), sequences, codes, out);
}

}  // namespace vitrine::render
