// The writer of deflate streams: what zlib reads back, and how long its codes are.

#include "render/image/huffman.h"
#include "render/image/piece_deflater.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <numeric>
#include <queue>
#include <random>

namespace vitrine::render {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// What zlib makes of pieces that are put one after the other, with a last block behind them; fails the test where it
/// does not take all.
Bytes inflated(Bytes stream, std::size_t expected)
{
    const Bytes last = {0x01, 0x00, 0x00, 0xFF, 0xFF};
    stream.insert(stream.end(), last.begin(), last.end());
    Bytes out(expected + 1);
    z_stream z{};
    EXPECT_EQ(inflateInit2(&z, -15), Z_OK);
    z.next_in = stream.data();
    z.avail_in = static_cast<uInt>(stream.size());
    z.next_out = out.data();
    z.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(inflate(&z, Z_FINISH), Z_STREAM_END) << (z.msg ? z.msg : "");
    EXPECT_EQ(z.avail_in, 0U);
    out.resize(z.total_out);
    inflateEnd(&z);
    return out;
}

Bytes deflated(const Bytes& data)
{
    Bytes out;
    PieceDeflater().append(data, out);
    return out;
}

/// Bytes of many kinds: noise, runs, periods, few symbols, far repetitions, and one after the other of these.
Bytes someBytes(std::uint64_t seed, std::size_t size)
{
    test::Random random(seed);
    Bytes bytes;
    while (bytes.size() < size) {
        const auto part = static_cast<std::size_t>(1 + random.below(static_cast<int>(1U << (2 + random.below(16)))));
        const int kind = random.below(6);
        const auto period = static_cast<std::size_t>(1 + random.below(kind == 3 ? 40000 : 9));
        const int symbols = 1 + random.below(kind == 1 ? 4 : 256);
        for (std::size_t i = 0; i < part && bytes.size() < size; ++i) {
            const bool repeats = kind >= 2 && kind <= 3 && bytes.size() >= period;
            const double skewed = random.number(0, 1);
            if (repeats)
                bytes.push_back(bytes[bytes.size() - period]);
            else if (kind == 4)
                bytes.push_back(0);
            else if (kind == 5)
                bytes.push_back(static_cast<std::uint8_t>(std::pow(skewed, 12) * 255));
            else
                bytes.push_back(static_cast<std::uint8_t>(random.below(symbols)));
        }
    }
    return bytes;
}

TEST(PieceDeflater, WhateverItIsGivenZlibReadsBack)
{
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        test::Random random(1000 + seed);
        const Bytes data = someBytes(seed, static_cast<std::size_t>(random.below(1 << (seed % 19))));
        ASSERT_EQ(inflated(deflated(data), data.size()), data) << seed;
    }
}

TEST(PieceDeflater, SizesAtTheLimitsOfBlocksAreReadBack)
{
    for (const std::size_t limit : {std::size_t{0}, std::size_t{4}, std::size_t{258}, std::size_t{32768},
                                    std::size_t{65535}, std::size_t{65536}, std::size_t{131072}}) {
        for (std::size_t size = limit - std::min<std::size_t>(limit, 2); size <= limit + 2; ++size) {
            const Bytes zeros(size, 0);
            ASSERT_EQ(inflated(deflated(zeros), size), zeros) << size;
            const Bytes noise = someBytes(7, size);
            ASSERT_EQ(inflated(deflated(noise), size), noise) << size;
        }
    }
}

TEST(PieceDeflater, PiecesOneAfterTheOtherAreOneStreamAndKnowNothingOfEachOther)
{
    PieceDeflater deflater;
    Bytes all;
    Bytes stream;
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        const Bytes data = someBytes(50 + seed, 1 + 9000 * seed);
        const std::size_t before = stream.size();
        deflater.append(data, stream);
        all.insert(all.end(), data.begin(), data.end());
        EXPECT_EQ(Bytes(stream.begin() + static_cast<std::ptrdiff_t>(before), stream.end()), deflated(data));
    }
    EXPECT_EQ(inflated(stream, all.size()), all);
}

TEST(PieceDeflater, WhatIsWholeWithoutItGrowsByLessThanAThousandth)
{
    std::mt19937 random(3);
    Bytes noise(1 << 20);
    for (std::uint8_t& x : noise) x = static_cast<std::uint8_t>(random());
    EXPECT_LT(deflated(noise).size(), noise.size() + noise.size() / 1000);
    EXPECT_LT(deflated(Bytes(1 << 20, 0)).size(), 6000U);  // A match of 258 takes two bits at least.
}

/// Bits of the optimal code, by the textbook (D. Huffman, 1952): the sum of all inner nodes.
std::uint64_t optimalCost(const std::vector<std::uint32_t>& counts)
{
    std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> queue;
    for (const std::uint32_t count : counts)
        if (count > 0) queue.push(count);
    std::uint64_t cost = 0;
    while (queue.size() > 1) {
        const std::uint64_t a = queue.top();
        queue.pop();
        const std::uint64_t b = queue.top();
        queue.pop();
        cost += a + b;
        queue.push(a + b);
    }
    return cost;
}

std::uint64_t costOf(const std::vector<std::uint32_t>& counts, const Bytes& lengths)
{
    return std::inner_product(counts.begin(), counts.end(), lengths.begin(), std::uint64_t{0});
}

/// A complete code has 1.
double kraftSum(const Bytes& lengths)
{
    double sum = 0;
    for (const std::uint8_t length : lengths) sum += length > 0 ? std::pow(0.5, length) : 0;
    return sum;
}

TEST(Huffman, CodesAreOptimalAndComplete)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        test::Random random(seed);
        std::vector<std::uint32_t> counts(static_cast<std::size_t>(2 + random.below(285)));
        for (std::uint32_t& count : counts) count = static_cast<std::uint32_t>(random.below(1 + random.below(400)));
        counts.front() = counts.back() = 1;
        Bytes lengths(counts.size());
        huffmanLengths(counts, 15, lengths);
        EXPECT_EQ(kraftSum(lengths), 1) << seed;
        EXPECT_EQ(costOf(counts, lengths), optimalCost(counts)) << seed;
        for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(counts[i] == 0, lengths[i] == 0);
    }
}

/// Bits of the best code without codes longer than `limit`: package-merge (L. Larmore and D. Hirschberg, A fast
/// algorithm for optimal length-limited Huffman codes, 1990).
std::uint64_t optimalLimitedCost(std::vector<std::uint32_t> counts, int limit)
{
    std::sort(counts.begin(), counts.end());
    std::vector<std::uint64_t> packages;
    for (int length = 0; length < limit; ++length) {
        std::vector<std::uint64_t> pairs;
        for (std::size_t i = 0; i + 1 < packages.size(); i += 2) pairs.push_back(packages[i] + packages[i + 1]);
        pairs.insert(pairs.end(), counts.begin(), counts.end());
        std::sort(pairs.begin(), pairs.end());
        packages = pairs;
    }
    return std::accumulate(packages.begin(), packages.begin() + static_cast<std::ptrdiff_t>(2 * counts.size() - 2),
                           std::uint64_t{0});
}

TEST(Huffman, NoCodeIsLongerThanTheLimitAndFewBitsAreLostByIt)
{
    std::vector<std::uint32_t> fibonacci = {1, 1};
    while (fibonacci.size() < 40) fibonacci.push_back(fibonacci.back() + fibonacci[fibonacci.size() - 2]);
    EXPECT_EQ(optimalLimitedCost(fibonacci, 39), optimalCost(fibonacci));
    // The worst there is for a repair that does not look back: measured 6 % at 7 bits, less than 1 % at 15.
    for (const auto& [limit, most] : {std::pair{7, 1.1}, {15, 1.01}}) {
        Bytes lengths(fibonacci.size());
        huffmanLengths(fibonacci, limit, lengths);
        EXPECT_EQ(*std::max_element(lengths.begin(), lengths.end()), limit);
        EXPECT_EQ(kraftSum(lengths), 1);
        EXPECT_LT(static_cast<double>(costOf(fibonacci, lengths)),
                  most * static_cast<double>(optimalLimitedCost(fibonacci, limit)))
            << limit;
    }
}

TEST(Huffman, NoneAndOneSymbolHaveCodesOfTheirOwn)
{
    Bytes lengths(4, 9);
    huffmanLengths(std::vector<std::uint32_t>{0, 0, 0, 0}, 15, lengths);
    EXPECT_EQ(lengths, (Bytes{0, 0, 0, 0}));
    huffmanLengths(std::vector<std::uint32_t>{0, 0, 5, 0}, 15, lengths);
    EXPECT_EQ(lengths, (Bytes{0, 0, 1, 0}));
}

TEST(Huffman, CodesAreThoseOfTheSpecificationsExample)
{
    // RFC 1951, 3.2.2: lengths of A to H, and their codes, here with the first bit lowest.
    const Bytes lengths = {3, 3, 3, 3, 3, 2, 4, 4};
    std::vector<std::uint16_t> codes(8);
    huffmanCodes(lengths, codes);
    EXPECT_EQ(codes, (std::vector<std::uint16_t>{0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111}));
}

}  // namespace
}  // namespace vitrine::render
