// Equal inputs give equal bytes, whatever the time: each file is made twice, with the program's clock set a day and
// some seconds apart, at once and in parts.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using CommandWords = std::vector<std::string>;

test::Environment clockAhead(const std::string& seconds)
{
    return {{"LD_PRELOAD", VITRINE_OTHER_CLOCK}, {"VITRINE_TEST_CLOCK", seconds}};
}

CommandWords longer(CommandWords words, const CommandWords& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

const CommandWords ofPicture{"render", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1", "--out"};
const CommandWords ofRecording{"record", "sdf_morph", "--alone", "--samples", "1",   "--size",
                               "32x18",  "--fps",     "5",       "--seconds", "0.4", "--out"};
const CommandWords ofPrint{"print",      "--exhibit",   "sdf_morph",   "--alone", "--samples", "1",     "--count",
                           "3",          "--view-size", "32x24",       "--lpi",   "40",        "--dpi", "300",
                           "--width-mm", "20",          "--height-mm", "15",      "--out"};

/// Makes `name` with two clocks and compares all written files.
void expectSameBytes(const CommandWords& command, const std::string& name, const CommandWords& more = {})
{
    const TemporaryFolder a, b;
    for (const auto& [folder, seconds] : {std::pair{&a, "0"}, {&b, "86407"}}) {
        const test::Ended ended =
            test::vitrine(longer(longer(command, {(*folder / name).string()}), more), clockAhead(seconds));
        ASSERT_EQ(ended.code, 0) << name << ": " << ended.err;
    }
    const std::vector<std::string> files = a.files();
    ASSERT_FALSE(files.empty()) << name;
    EXPECT_EQ(files, b.files()) << name;
    for (const std::string& file : files)
        EXPECT_TRUE(test::bytesOf(a / file) == test::bytesOf(b / file)) << file << " differs from itself";
}

TEST(LongSameBytes, OfAFileOfEachJobWhateverTheClock)
{
    expectSameBytes(ofPicture, "a.png");
    expectSameBytes(ofPrint, "a.tif");
    expectSameBytes(ofRecording, "a.mp4");
    expectSameBytes({"sprite", "--directions", "2", "--size", "16x16", "--out"}, "hero.png");
}

TEST(LongSameBytes, OfPicturesWhateverTheClock)
{
    for (const char* name : {"a.exr", "a.tif"}) expectSameBytes(ofPicture, name);
    expectSameBytes(ofPicture, "deep.tif", {"--sixteen-bit"});
    expectSameBytes(
        ofPicture, "moved.exr",
        {"--transparent", "--channels", "color,depth,normal,evaluations", "--time", "3.5", "--set", "animate=on"});
}

TEST(LongSameBytes, OfPrintsChartsAndProofsWhateverTheClock)
{
    expectSameBytes(ofPrint, "a.png");
    const TemporaryFolder views;
    ASSERT_EQ(test::vitrine(longer(ofPrint, {views / "p.tif"})).code, 0);
    expectSameBytes({"proof", views / "p.tif", "--angle", "5", "--out"}, "seen.tif");
    expectSameBytes(
        {"print", "--chart", "pitch", "--lpi", "40", "--dpi", "300", "--width-mm", "50", "--height-mm", "50", "--out"},
        "chart.tif");
    expectSameBytes(ofPrint, "small.tif", {"--compression", "deflate"});
}

TEST(LongSameBytes, OfViewsInEveryFormatWhateverTheClock)
{
    for (const char* format : {"png", "jpg"}) {
        CommandWords command = ofPrint;
        command.back() = "--view-format";
        expectSameBytes(longer(command, {format, "--save-views"}), "views");
    }
}

TEST(LongSameBytes, OfRecordingsWhateverTheClock)
{
    for (const char* name : {"a.webm", "a.gif", "a.webp", "a.apng"}) expectSameBytes(ofRecording, name);
    expectSameBytes(ofRecording, "%d.png");
}

TEST(LongSameBytes, OfAPrintInPartsAndInOnePieceWhateverTheClock)
{
    const TemporaryFolder folder;
    for (const char* name : {"print.tif", "print.png"}) {
        const std::string out = folder / name;
        const CommandWords command = longer(ofPrint, {out});
        ASSERT_EQ(test::vitrine(command, clockAhead("0")).code, 0);
        const std::string whole = test::bytesOf(out), described = test::bytesOf(out + ".json");
        fs::remove(out);
        for (const char* part : {"1/2", "2/2"})
            ASSERT_EQ(test::vitrine(longer(command, {"--shard", part}), clockAhead("100")).code, 0);
        const test::Ended merged = test::vitrine({"merge", out}, clockAhead("86407"));
        ASSERT_EQ(merged.code, 0) << merged.err;
        EXPECT_TRUE(test::bytesOf(out) == whole) << name;
        EXPECT_EQ(test::bytesOf(out + ".json"), described) << name;
    }
}

TEST(SameBytes, TheOtherClockIsAnother)
{
    // Control: without the other clock, the tests above would compare equal times.
    const TemporaryFolder folder;
    const std::string command = std::string("VITRINE_TEST_CLOCK=86400 LD_PRELOAD=") + VITRINE_OTHER_CLOCK +
                                " date +%s > " + (folder / "ahead").string() + "; date +%s > " +
                                (folder / "now").string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    const double ahead = std::stod(test::bytesOf(folder / "ahead")) - std::stod(test::bytesOf(folder / "now"));
    EXPECT_NEAR(ahead, 86400, 60);
}

}  // namespace
}  // namespace vitrine
