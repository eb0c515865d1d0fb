// Videos, checked with FFmpeg's reader, and the files left after errors.

#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "render/video/video_file.h"
#include "render/video/video_frames.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/video_reader.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <set>

namespace vitrine {
namespace {

using render::Image;
using render::VideoFile;
using render::VideoFormat;
using render::VideoSpec;
using test::TemporaryFolder;

constexpr int wide = 48, high = 32, count = 7;
const std::string comment = "{\"name\": \"Frühling\"}";

/// Returns a frame with a ramp over a background of the sRGB color (180, 60, 20), which moves with every frame.
Image frameOf(int k, bool transparent = false)
{
    Image image(wide, high, 4, 1);
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            const std::array<int, 3> codes =
                y < high / 2 ? std::array<int, 3>{180, 60, 20} : std::array<int, 3>{(5 * x + 20 * k) % 256, 128, 40};
            for (int c = 0; c < 3; ++c)
                image.at(x, y, c) =
                    static_cast<float>(render::linearFromSrgb(codes.at(static_cast<std::size_t>(c)) / 255.0));
            if (transparent && x < 10) image.at(x, y, 3) = 0.5F;
        }
    return image;
}

std::uint8_t codeOf(const Image& image, std::size_t i)
{
    return i % 4 == 3 ? render::code8(image.pixels[i]) : render::srgb8FromLinear(image.pixels[i]);
}

std::filesystem::path written(const TemporaryFolder& folder, const std::string& name, VideoSpec spec)
{
    spec.format = *render::videoFormatOf(name);
    spec.width = wide;
    spec.height = high;
    spec.comment = comment;
    VideoFile video(folder / name, spec);
    for (int k = 0; k < count; ++k) video.add(frameOf(k, spec.transparent));
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << "only when it is finished";
    video.finish();
    EXPECT_EQ(folder.files(), std::vector<std::string>{name});
    return folder / name;
}

void expectTimes(const test::ReadVideo& read, double framesPerSecond, double within)
{
    ASSERT_EQ(read.times.size(), static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        EXPECT_NEAR(read.times[static_cast<std::size_t>(k)] - read.times[0], k / framesPerSecond, within) << k;
}

/// Stores the display matrix of an .mp4 in its track header (ISO/IEC 14496-12, 8.3.2).
void setDisplayMatrix(const std::filesystem::path& file, const std::array<int, 4>& turn)
{
    std::string bytes = test::bytesOf(file);
    const std::size_t header = bytes.find("tkhd");
    ASSERT_NE(header, std::string::npos);
    ASSERT_EQ(bytes[header + 4], 0) << "version 0: times have 32 bits";
    const std::size_t matrix = header + 4 + 40;
    const std::array<std::pair<std::size_t, int>, 4> places{{{0, turn[0]}, {1, turn[1]}, {3, turn[2]}, {4, turn[3]}}};
    for (const auto& [place, number] : places) {
        const auto fixed = static_cast<std::uint32_t>(number * 65536);
        for (std::size_t i = 0; i < 4; ++i)
            bytes[matrix + 4 * place + i] = static_cast<char>(fixed >> (24 - 8 * i) & 255U);
    }
    test::writeBytes(file, bytes);
}

TEST(VideoFile, FramesAreTurnedAsTheFileSays)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = written(folder, "a.mp4", {});
    const Image stored = *render::VideoFrameReader(file).frame(2);
    ASSERT_EQ(stored.width, wide);
    // All right angles, with and without a mirror.
    for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{{1, 0, 0, 1},
                                                                    {0, 1, -1, 0},
                                                                    {-1, 0, 0, -1},
                                                                    {0, -1, 1, 0},
                                                                    {-1, 0, 0, 1},
                                                                    {1, 0, 0, -1},
                                                                    {0, 1, 1, 0},
                                                                    {0, -1, -1, 0}}) {
        setDisplayMatrix(file, {a, b, c, d});
        render::VideoFrameReader reader(file);
        static_cast<void>(reader.frame(0));
        const Image shown = *reader.frame(2);
        ASSERT_EQ(shown.width, a == 0 ? high : wide);
        ASSERT_EQ(shown.height, a == 0 ? wide : high);
        for (int y = 0; y < high; ++y)
            for (int x = 0; x < wide; ++x) {
                const int left = a * x + c * y, top = b * x + d * y;
                const int toX = left + (a + c < 0 ? shown.width - 1 : 0),
                          toY = top + (b + d < 0 ? shown.height - 1 : 0);
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_EQ(shown.at(toX, toY, channel), stored.at(x, y, channel)) << a << b << c << d;
            }
    }
}

TEST(VideoFile, AnMp4HasEveryFrameAtItsTimeAndSaysWhichColorsItHas)
{
    const TemporaryFolder folder;
    const test::ReadVideo read = test::readVideo(written(folder, "a.mp4", {.framesPerSecond = 25}));
    EXPECT_EQ(read.codec, "h264");
    EXPECT_EQ(read.width, wide);
    EXPECT_EQ(read.height, high);
    EXPECT_EQ(read.comment, comment);
    EXPECT_EQ(read.primaries, "bt709");
    EXPECT_EQ(read.transfer, "iec61966-2-1");
    EXPECT_EQ(read.matrix, "bt709");
    expectTimes(read, 25, 1e-6);
    const std::string bytes = test::bytesOf(folder / "a.mp4");
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "the index comes first, so that it plays while it loads";
}

TEST(VideoFile, LossyOnesKeepFlatColors)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const test::ReadVideo read = test::readVideo(written(folder, name, {}));
        std::filesystem::remove(folder / name);
        ASSERT_EQ(read.frames.size(), static_cast<std::size_t>(count)) << name;
        for (const auto& frame : read.frames) {
            // In the middle of the background, four pixels from the ramp. A wrong matrix or range would change it by 8
            // codes.
            const std::size_t at = 4 * (static_cast<std::size_t>(8) * wide + 24);
            EXPECT_NEAR(frame[at], 180, 4) << name;
            EXPECT_NEAR(frame[at + 1], 60, 4) << name;
            EXPECT_NEAR(frame[at + 2], 20, 4) << name;
        }
    }
}

TEST(VideoFile, AWebmIsVp9AndKeepsItsComment)
{
    const TemporaryFolder folder;
    const test::ReadVideo read = test::readVideo(written(folder, "a.webm", {.framesPerSecond = 50}));
    EXPECT_EQ(read.codec.substr(0, 3), "vp9");
    EXPECT_EQ(read.comment, comment);
    EXPECT_EQ(read.matrix, "bt709");
    expectTimes(read, 50, 0.0011);  // Matroska stores milliseconds.
}

TEST(VideoFile, ATransparentWebmKeepsItsOpacity)
{
    const TemporaryFolder folder;
    const test::ReadVideo read = test::readVideo(written(folder, "a.webm", {.transparent = true}));
    EXPECT_EQ(read.codec, "libvpx-vp9");
    EXPECT_EQ(read.comment, comment);
    ASSERT_EQ(read.frames.size(), static_cast<std::size_t>(count));
    for (const auto& frame : read.frames) {
        const auto at = [&](std::size_t x, std::size_t c) { return frame[4 * (8 * wide + x) + c]; };
        EXPECT_NEAR(at(4, 3), 128, 4);
        EXPECT_NEAR(at(24, 3), 255, 4);
        for (const std::size_t x : {4U, 24U}) EXPECT_NEAR(at(x, 0), 180, 4) << "not premultiplied";
    }
}

TEST(VideoFile, AnApngHasThePixelsToTheBitAndThePresetOfAPicture)
{
    const TemporaryFolder folder;
    for (const bool transparent : {false, true}) {
        const auto path = written(folder, "a.apng", {.framesPerSecond = 30, .transparent = transparent});
        const test::ReadVideo read = test::readVideo(path);
        expectTimes(read, 30, 1e-3);
        for (int k = 0; k < count; ++k) {
            const Image frame = frameOf(k, transparent);
            int wrong = 0;
            for (std::size_t i = 0; i < frame.pixels.size(); ++i)
                wrong += read.frames.at(static_cast<std::size_t>(k)).at(i) != codeOf(frame, i);
            EXPECT_EQ(wrong, 0) << k << (transparent ? " transparent" : "");
        }
        std::filesystem::rename(path, folder / "a.png");
        EXPECT_EQ(render::embeddedPreset(folder / "a.png"), comment);
        // Programs without support for animation show the first frame.
        const Image first = render::readImage(folder / "a.png");
        EXPECT_NEAR(first.at(20, 4, 0), frameOf(0).at(20, 4, 0), 1e-4);
        std::filesystem::remove(folder / "a.png");
    }
}

TEST(VideoFile, AGifLoopsAndCarriesItsComment)
{
    const TemporaryFolder folder;
    const auto path = written(folder, "a.gif", {.framesPerSecond = 20});
    const test::ReadVideo read = test::readVideo(path);
    expectTimes(read, 20, 0.0051);  // GIF stores hundredths of a second.
    const std::string bytes = test::bytesOf(path);
    EXPECT_NE(bytes.find("NETSCAPE2.0"), std::string::npos);
    EXPECT_NE(bytes.find(comment), std::string::npos);
    EXPECT_EQ(bytes.back(), ';');
}

TEST(VideoFile, AWebpIsAnimatedLosslessAndOfTheSizeItSays)
{
    const TemporaryFolder folder;
    const std::string bytes = test::bytesOf(written(folder, "a.webp", {.framesPerSecond = 10}));
    const auto at = [&](std::size_t i, std::size_t n) {
        std::uint32_t x = 0;
        for (std::size_t k = n; k-- > 0;) x = x << 8U | static_cast<unsigned char>(bytes.at(i + k));
        return x;
    };
    ASSERT_EQ(bytes.substr(0, 4) + bytes.substr(8, 8), "RIFFWEBPVP8X");
    EXPECT_EQ(at(4, 4) + 8, bytes.size());
    int frames = 0, milliseconds = 0;
    bool found = false;
    std::string kinds;
    for (std::size_t i = 12; i < bytes.size(); i += 8 + at(i + 4, 4) + at(i + 4, 4) % 2) {
        const std::string kind = bytes.substr(i, 4);
        if (kind == "ANMF") {
            ++frames;
            milliseconds += static_cast<int>(at(i + 8 + 12, 3));
            kinds += bytes.substr(i + 8 + 16, 4);
        }
        found = found || (kind == "VTRN" && bytes.substr(i + 8, at(i + 4, 4)) == comment);
    }
    EXPECT_EQ(frames, count);
    EXPECT_NEAR(milliseconds, 100 * count, 1);
    EXPECT_EQ(kinds.find("VP8 "), std::string::npos) << "a lossy frame";
    EXPECT_TRUE(found);
}

TEST(VideoFile, TheSameFramesGiveTheSameBytes)
{
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.webp", "a.apng"}) {
        const TemporaryFolder one, other;
        EXPECT_EQ(test::bytesOf(written(one, name, {})), test::bytesOf(written(other, name, {}))) << name;
    }
}

/// x264 of Debian 13 did not do this for frames of two by two macroblocks.
TEST(VideoFile, TheSameTinyFramesGiveTheSameBytes)
{
    for (const auto& [width, height] : {std::pair{18, 18}, {24, 24}, {32, 18}}) {
        const TemporaryFolder folder;
        std::set<std::string> different;
        for (int again = 0; again < 8; ++again) {
            const std::vector<char> elsewhere(static_cast<std::size_t>(1000 + 7777 * again));
            VideoFile video(folder / "a.mp4", {VideoFormat::mp4, width, height});
            for (int k = 0; k < count; ++k) {
                const Image large = frameOf(k);
                Image image(width, height, 4, 1);
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x)
                        for (int c = 0; c < 3; ++c) image.at(x, y, c) = large.at(x, y + c, c);
                video.add(image);
            }
            video.finish();
            different.insert(test::bytesOf(folder / "a.mp4"));
        }
        EXPECT_EQ(different.size(), 1U) << width << " x " << height;
    }
}

TEST(VideoFile, WhatIsNotFinishedLeavesTheOldFile)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.mp4", "old");
    {
        VideoFile video(folder / "a.mp4", {VideoFormat::mp4, wide, high});
        video.add(frameOf(0));
    }
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.mp4"});
    EXPECT_EQ(test::bytesOf(folder / "a.mp4"), "old");
}

/// Disk with this many free bytes.
class SmallDisk final : public render::FileOps {
public:
    explicit SmallDisk(std::size_t free) : free_(free) {}
    ssize_t write(int fd, const void* bytes, std::size_t size) override
    {
        if (size > free_) {
            errno = ENOSPC;
            return -1;
        }
        free_ -= size;
        return FileOps::write(fd, bytes, size);
    }

private:
    std::size_t free_;
};

TEST(VideoFile, AFullDiskIsOneSentenceAndLeavesTheOldFile)
{
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.webp", "a.apng"})
        for (const std::size_t free : {0U, 100U, 400U}) {
            const TemporaryFolder folder;
            test::writeBytes(folder / name, "old");
            SmallDisk disk(free);
            try {
                VideoFile video(folder / name, {*render::videoFormatOf(name), wide, high, 30, false, comment}, disk);
                for (int k = 0; k < count; ++k) video.add(frameOf(k));
                video.finish();
                ADD_FAILURE() << name << ": " << free << " bytes were enough";
            } catch (const Failure& failure) {
                const std::string said = failure.what();
                EXPECT_EQ(failure.kind(), ErrorKind::file);
                EXPECT_NE(said.find(name), std::string::npos) << said;
                EXPECT_NE(said.find(std::strerror(ENOSPC)), std::string::npos) << said;
            }
            EXPECT_EQ(folder.files(), std::vector<std::string>{name});
            EXPECT_EQ(test::bytesOf(folder / name), "old") << name;
        }
}

TEST(VideoFile, WhatAFormatCannotHoldSaysWhatToGive)
{
    const auto why = [](VideoSpec spec) { return render::whyNoVideo(spec); };
    EXPECT_EQ(why({VideoFormat::mp4, 640, 360}), "");
    EXPECT_NE(why({VideoFormat::mp4, 641, 359}).find("642x360"), std::string::npos);
    EXPECT_NE(why({VideoFormat::webm, 641, 360}).find("642x360"), std::string::npos);
    EXPECT_EQ(why({VideoFormat::apng, 641, 359, 60, true}), "");
    EXPECT_EQ(why({VideoFormat::webp, 641, 359, 60, true}), "");
    EXPECT_NE(why({VideoFormat::gif, 64, 64, 60}).find("50"), std::string::npos);
    EXPECT_NE(why({VideoFormat::gif, 64, 64, 20, true}).find("transparent"), std::string::npos);
    EXPECT_NE(why({VideoFormat::mp4, 64, 64, 20, true}).find("transparent"), std::string::npos);
    EXPECT_NE(why({VideoFormat::mp4, 64, 64, std::nan("")}), "");
    EXPECT_NE(why({VideoFormat::apng, 0, 64}), "");
    EXPECT_NE(why({VideoFormat::apng, 20000, 64}), "");
    EXPECT_FALSE(render::videoFormatOf("a.avi"));
    EXPECT_EQ(render::videoFormatOf("A.MP4"), VideoFormat::mp4);
    EXPECT_THROW(VideoFile("/tmp/never.mp4", {VideoFormat::mp4, 3, 3}), Failure);
}

}  // namespace
}  // namespace vitrine
