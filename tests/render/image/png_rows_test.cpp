// Large PNGs written by rows and in pieces: checked with other readers, and on a failing disk.

#include "render/image/oiio_codec.h"
#include "render/image/picture_stream.h"
#include "render/image/png_filter.h"
#include "render/image/png_row_reader.h"
#include "tests/support/failures.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <bit>
#include <cerrno>
#include <cstring>

namespace vitrine::render {
namespace {

using namespace test;

struct Raster {
    std::int64_t width = 1, height = 1;
    int bits = 8;
    std::vector<std::uint8_t> bytes{};  ///< Samples in the machine's byte order.

    [[nodiscard]] std::size_t stride() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(3 * bits / 8);
    }
};

/// Returns a raster of one of six kinds: noise, one color, ramp, noise with rows repeated four times, mostly white,
/// gray.
Raster someRaster(std::uint64_t seed, std::int64_t width, std::int64_t height, int bits)
{
    test::Random random(seed);
    Raster raster{width, height, bits, {}};
    const std::size_t stride = raster.stride();
    raster.bytes.resize(stride * static_cast<std::size_t>(height));
    const auto kind = seed % 6;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        std::uint8_t* row = raster.bytes.data() + y * stride;
        for (std::size_t i = 0; i < stride; ++i) {
            int value = random.below(256);
            if (kind == 1) value = 77;
            if (kind == 2) value = static_cast<int>((i / 3 + 2 * y) & 255U);
            if (kind == 3 && y % 4 != 0) value = raster.bytes[(y - 1) * stride + i];
            if (kind == 4 && value > 2) value = 255;
            if (kind == 5 && i % 3 != 0) value = row[i - 1];
            row[i] = static_cast<std::uint8_t>(value);
        }
    }
    return raster;
}

/// Writes a raster in bands of different heights.
void write(const std::filesystem::path& path, const Raster& raster, int threads, FileOps& ops = systemFileOps())
{
    PictureStream stream(path,
                         {.width = raster.width,
                          .height = raster.height,
                          .bits = raster.bits,
                          .dpiX = 600,
                          .dpiY = 300,
                          .likeRowAbove = raster.width % 2 == 0,
                          .json = "{}",
                          .threads = threads},
                         ops);
    std::int64_t band = 1;
    for (std::int64_t y = 0; y < raster.height; y += band, band = band % 97 * 3 + 1) {
        band = std::min(band, raster.height - y);
        stream.write(raster.bytes.data() + static_cast<std::size_t>(y) * raster.stride(), band);
    }
    stream.finish();
    stream.publish();
}

std::vector<std::uint8_t> readByLibpng(const std::filesystem::path& path, const Raster& as)
{
    PngRowReader reader(path);
    EXPECT_EQ(reader.begin(), "");
    EXPECT_EQ(reader.bits(), as.bits);
    std::vector<std::uint8_t> bytes(as.bytes.size());
    if (reader.width() != as.width || reader.height() != as.height) return {};
    EXPECT_EQ(reader.read(bytes.data(), as.height), "");
    return bytes;
}

std::vector<std::uint8_t> readByOpenImageIo(const std::filesystem::path& path)
{
    StoredPicture picture;
    EXPECT_EQ(oiioCodec().decode(bytesOf(path), ImageFormat::png, {}, picture), "");
    EXPECT_EQ(picture.channels, 3);
    if (const auto* eight = std::get_if<0>(&picture.samples)) return *eight;
    const auto& sixteen = std::get<1>(picture.samples);
    std::vector<std::uint8_t> bytes(sixteen.size() * 2);
    std::memcpy(bytes.data(), sixteen.data(), bytes.size());
    return bytes;
}

std::uint32_t bigEndian(const std::string& text, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(text.at(at + i));
    return value;
}

/// Checks all chunks with their checksums, and unpacks the single zlib stream in them; every byte must be used.
void expectStrict(const std::filesystem::path& path, const Raster& raster)
{
    const std::string file = bytesOf(path);
    std::string stream;
    std::string last;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t size = bigEndian(file, at);
        last = file.substr(at + 4, 4);
        const auto* typed = reinterpret_cast<const Bytef*>(file.data() + at + 4);
        ASSERT_LE(at + 12 + size, file.size());
        EXPECT_EQ(crc32(0, typed, static_cast<uInt>(size + 4)), bigEndian(file, at + 8 + size)) << last;
        if (last == "IDAT") stream += file.substr(at + 8, size);
        at += 12 + size;
    }
    EXPECT_EQ(last, "IEND");
    std::vector<Bytef> out((raster.stride() + 1) * static_cast<std::size_t>(raster.height));
    uLongf outSize = out.size();
    uLong inSize = stream.size();
    EXPECT_EQ(uncompress2(out.data(), &outSize, reinterpret_cast<const Bytef*>(stream.data()), &inSize), Z_OK);
    EXPECT_EQ(outSize, out.size());
    EXPECT_EQ(inSize, stream.size());
}

TEST(PngRows, RandomPicturesAreReadBackByLibpngAndByOpenImageIo)
{
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < 36; ++seed) {
        test::Random random(seed);
        const Raster raster =
            someRaster(seed, 1 + random.below(400), 1 + random.below(300), seed / 6 % 2 == 0 ? 8 : 16);
        write(folder / "a.png", raster, 1 + static_cast<int>(seed % 3));
        ASSERT_TRUE(readByLibpng(folder / "a.png", raster) == raster.bytes) << seed;
        if (seed % 3 == 0) {
            ASSERT_TRUE(readByOpenImageIo(folder / "a.png") == raster.bytes) << seed;
        }
        expectStrict(folder / "a.png", raster);
    }
}

TEST(PngRows, SinglePixelsRowsAndColumnsAreReadBack)
{
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 2}, {2, 1}, {1, 700}, {30000, 1}, {5, 5}, {6, 3}})
        for (const int bits : {8, 16})
            for (const std::uint64_t kind : {0U, 1U, 2U}) {
                const Raster raster = someRaster(kind, width, height, bits);
                write(folder / "a.png", raster, 2);
                ASSERT_TRUE(readByLibpng(folder / "a.png", raster) == raster.bytes) << width << ' ' << height;
                ASSERT_TRUE(readByOpenImageIo(folder / "a.png") == raster.bytes) << width << ' ' << height;
                expectStrict(folder / "a.png", raster);
            }
}

TEST(PngRows, TheFileIsTheSameForAnyNumberOfThreads)
{
    const TemporaryFolder folder;
    const Raster raster = someRaster(3, 901, 1700, 8);  // Large enough for nine pieces.
    write(folder / "1.png", raster, 1);
    const std::string one = bytesOf(folder / "1.png");
    for (const int threads : {2, 3, 7}) {
        write(folder / "n.png", raster, threads);
        EXPECT_TRUE(bytesOf(folder / "n.png") == one) << threads;
    }
    ASSERT_TRUE(readByLibpng(folder / "1.png", raster) == raster.bytes);
    expectStrict(folder / "1.png", raster);
}

/// Disk that is full after this many bytes, takes few at a time, and is sometimes interrupted.
class SmallDisk : public FileOps {
public:
    SmallDisk(std::size_t room, int error) : room_(room), error_(error) {}
    ssize_t write(int fd, const void* bytes, std::size_t size) override
    {
        if (++calls_ % 5 == 0) {
            errno = EINTR;
            return -1;
        }
        if (room_ == 0) {
            errno = error_;
            return -1;
        }
        const ssize_t wrote = FileOps::write(fd, bytes, std::min({size, room_, std::size_t{70001}}));
        room_ -= static_cast<std::size_t>(std::max<ssize_t>(wrote, 0));
        return wrote;
    }

private:
    std::size_t room_;
    int error_, calls_ = 0;
};

TEST(PngRows, AFullDiskIsSaidWhereverItComesAndLeavesNothing)
{
    const TemporaryFolder folder;
    const Raster raster = someRaster(0, 500, 1100, 8);  // Noise: about 1.65 MB.
    {
        SmallDisk large(100'000'000, ENOSPC);
        write(folder / "a.png", raster, 2, large);
        ASSERT_TRUE(readByLibpng(folder / "a.png", raster) == raster.bytes);
    }
    const std::size_t size = bytesOf(folder / "a.png").size();
    std::filesystem::remove(folder / "a.png");
    for (const std::size_t room : {std::size_t{0}, std::size_t{20}, size / 4, size / 2, size - 13, size - 1}) {
        for (const int error : {ENOSPC, EFBIG}) {
            SmallDisk disk(room, error);
            EXPECT_FAILURE(write(folder / "a.png", raster, 2, disk), std::strerror(error));
            EXPECT_EQ(folder.files(), std::vector<std::string>{}) << room;
        }
    }
}

TEST(PngRows, WhoStopsHalfwayLeavesNothing)
{
    const TemporaryFolder folder;
    const Raster raster = someRaster(0, 500, 1100, 8);
    {
        PictureStream stream(folder / "a.png", {.width = 500, .height = 1100, .dpiX = 600, .dpiY = 600, .threads = 3});
        stream.write(raster.bytes.data(), 900);
    }
    EXPECT_EQ(folder.files(), std::vector<std::string>{});
    EXPECT_THROW(PictureStream(folder / "a.png", {.width = 2147483648, .height = 1}), Failure);
}

TEST(PngFilter, TakesTheLeastSumOrOneThatIsHardlyLarger)
{
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const std::size_t pixel = seed % 2 == 0 ? 3 : 6;
        const Raster raster = someRaster(seed, 1 + static_cast<int>(seed) * 37, 2, pixel == 3 ? 8 : 16);
        const std::size_t bytes = raster.stride();
        const std::uint8_t* above = raster.bytes.data();
        const std::uint8_t* row = above + bytes;
        std::vector<std::uint8_t> out(bytes + 1);
        PngFilter kind = PngFilter::above;
        filterPngRow(row, above, bytes, pixel, kind, out.data());
        const auto differences = [&](int filter, std::size_t i) {
            const int before = i >= pixel ? row[i - pixel] : 0;
            return static_cast<std::uint8_t>(row[i] - (filter == 0 ? 0 : filter == 1 ? before : above[i]));
        };
        std::array<double, 3> sums{};
        for (int filter = 0; filter < 3; ++filter)
            for (std::size_t i = 0; i < bytes; ++i) {
                const std::uint8_t d = differences(filter, i);
                sums.at(static_cast<std::size_t>(filter)) += i >= pixel ? std::min<int>(d, 256 - d) : 0;
            }
        const std::uint8_t taken = out[0];
        ASSERT_LE(taken, 2);
        EXPECT_LE(sums.at(taken) * 15 / 16, *std::min_element(sums.begin(), sums.end()) + 1) << seed;
        for (std::size_t i = 0; i < bytes; ++i) ASSERT_EQ(out[i + 1], differences(taken, i)) << seed << ' ' << i;
    }
}

}  // namespace
}  // namespace vitrine::render
