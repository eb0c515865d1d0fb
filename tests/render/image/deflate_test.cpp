// Writer of deflate streams, checked with zlib.

#include "render/image/piece_deflater.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <isa-l.h>
#include <malloc.h>
#include <sys/mman.h>
#include <zlib.h>

#include <algorithm>
#include <random>

namespace vitrine::render {
namespace {

using Bytes = RawBytes;

/// Unpacks concatenated pieces with zlib, followed by a last block. Fails the test if zlib does not accept all of it.
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

/// Returns bytes of many kinds: noise, runs, periods, few symbols, distant repetitions, and mixtures of these.
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

/// ISA-L hashes the third byte of a stream depending on the address of its state, in steps of 64 KB. With these bytes,
/// one address of 8192 finds another match.
TEST(PieceDeflater, TheBytesDoNotDependOnWhereItLiesInMemory)
{
    Bytes data(600, 0);
    data[0] = 2;  // First byte of a filtered row that equals the one above.
    const Bytes expected = deflated(data);
    // Makes every state a memory mapping of its own. A mapping without memory fills the place of a released one.
    mallopt(M_MMAP_THRESHOLD, 1 << 14);
    constexpr std::size_t placeBytes = (sizeof(isal_zstream) + 0x1100) / 0x1000 * 0x1000;
    std::vector<void*> places;
    std::size_t others = 0;
    for (int i = 0; i < 20000; ++i) {
        others += deflated(data) == expected ? 0U : 1U;
        places.push_back(mmap(nullptr, placeBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
    }
    for (void* place : places)
        if (place != MAP_FAILED) munmap(place, placeBytes);
    EXPECT_EQ(others, 0U);
}

TEST(PieceDeflater, WhatIsWholeWithoutItGrowsByLessThanAThousandth)
{
    std::mt19937 random(3);
    Bytes noise(1 << 20);
    for (std::uint8_t& x : noise) x = static_cast<std::uint8_t>(random());
    EXPECT_LT(deflated(noise).size(), noise.size() + noise.size() / 1000);
    EXPECT_LT(deflated(Bytes(1 << 20, 0)).size(), 6000U);  // A match of 258 bytes takes at least two bits.
}

}  // namespace
}  // namespace vitrine::render
