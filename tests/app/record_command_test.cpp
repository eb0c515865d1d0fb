// `vitrine record`, as users call it.

#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/job_options.h"
#include "exhibits/recording/tour.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <regex>
#include <set>
#include <thread>

namespace vitrine {
namespace {

using test::TemporaryFolder;
using Words = std::vector<std::string>;

Words recording(const std::string& subject, const std::string& out, const Words& more = {})
{
    Words words{"record", subject, "--samples", "1", "--out", out};
    const auto otherwise = [&](const Words& option) {
        if (std::find(more.begin(), more.end(), option.front()) == more.end())
            words.insert(words.end(), option.begin(), option.end());
    };
    otherwise({"--size", "32x18"});
    otherwise({"--fps", "4"});
    if (std::find(more.begin(), more.end(), "--alone") == more.end())
        words.insert(words.end(), {"--set", "hall.probeSize=32", "--set", "hall.shadowMapSize=512"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Returns the mean difference over pixels and colors, in linear light.
double differenceOf(const render::Image& a, const render::Image& b)
{
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
    return sum / static_cast<double>(a.pixels.size());
}

TEST(RecordCommand, TurnsRoundAnExhibitAndGivesTheSameBytesAgain)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.apng", "b.apng"}) {
        const test::Ended ended =
            test::vitrine(recording("sdf_morph", folder / name, {"--alone", "--seconds", "1", "--set", "morph=1"}));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(ended.out, (folder / name).string() + ": frames 4, frame size 32 × 18 px\n");
    }
    EXPECT_EQ(test::bytesOf(folder / "a.apng"), test::bytesOf(folder / "b.apng"));
}

TEST(LongRecordCommand, AFramesTimeIsItsNumberOverTheRateAndItsPresetBringsItBack)
{
    const TemporaryFolder folder;
    const Words film{"--alone", "--seconds", "1", "--path", "still", "--set", "animate=on", "--time", "1"};
    const test::Ended ended = test::vitrine(recording("sdf_morph", folder / "f/%03d.png", film));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(folder.files(),
              (Words{"f/%03d.png.vitrine-job.json", "f/001.png", "f/002.png", "f/003.png", "f/004.png"}));
    // The third frame, at 2 / 4 s, compared with pictures of that time and of the preset inside it.
    const Words picture{"render", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1", "--time", "1.5"};
    Words plain = picture, preset = picture;
    plain.insert(plain.end(), {"--set", "animate=on", "--out", folder / "plain.png"});
    preset.insert(preset.end(), {"--preset", folder / "f/003.png", "--out", folder / "preset.png"});
    ASSERT_EQ(test::vitrine(plain).code, 0);
    const test::Ended fromPreset = test::vitrine(preset);
    ASSERT_EQ(fromPreset.code, 0) << fromPreset.err;
    const render::Image third = render::readImage(folder / "f/003.png");
    EXPECT_EQ(differenceOf(third, render::readImage(folder / "plain.png")), 0);
    EXPECT_LT(differenceOf(third, render::readImage(folder / "preset.png")),
              1e-3);  // Its camera was converted to the hall's space and back.
    EXPECT_GT(differenceOf(third, render::readImage(folder / "f/001.png")), 1e-3) << "the control: it melts";
}

TEST(LongRecordCommand, FramesOfOpenExrHoldLinearLightAndAreKept)
{
    const TemporaryFolder folder;
    const Words film{"--alone", "--seconds", "0.5", "--path", "still"};
    ASSERT_EQ(test::vitrine(recording("sdf_morph", folder / "f/%02d.exr", film)).code, 0);
    EXPECT_EQ(folder.files(), (Words{"f/%02d.exr.vitrine-job.json", "f/01.exr", "f/02.exr"}));
    const test::Ended picture = test::vitrine({"render", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1",
                                               "--time", "0.25", "--out", folder / "a.exr"});
    ASSERT_EQ(picture.code, 0) << picture.err;
    EXPECT_EQ(differenceOf(render::readImage(folder / "f/02.exr"), render::readImage(folder / "a.exr")), 0);
    const test::Ended again = test::vitrine(recording("sdf_morph", folder / "f/%02d.exr", film));
    EXPECT_NE(again.out.find("kept 2"), std::string::npos) << again.out;
}

TEST(LongRecordCommand, FollowsATourAndSaysWhatItLeftOut)
{
    const TemporaryFolder folder;
    recording::Tour tour{"Short", {{"a", {}}, {"b", {}}}, false, recording::Pace::constant};
    tour.bookmarks[1].camera.eye = {0.5, 1.65, 10};
    test::writeBytes(folder / "tour.json", recording::tourText(tour));
    const test::Ended ended =
        test::vitrine(recording("hall", folder / "a.mp4", {"--seconds", "0.5", "--tour", folder / "tour.json"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(folder.files(), (Words{"a.mp4", "a.mp4.vitrine-job.json", "tour.json"}));
    test::writeBytes(folder / "tour.json", "{\"format\": \"vitrine-tour\",\n\"version\": 1}");
    const test::Ended broken = test::vitrine(recording("hall", folder / "b.mp4", {"--tour", folder / "tour.json"}));
    EXPECT_EQ(broken.code, 5);
    test::expectOneSentence(broken, {"tour.json", "bookmarks", "missing"});
    EXPECT_EQ(folder.files(), (Words{"a.mp4", "a.mp4.vitrine-job.json", "tour.json"}));
}

TEST(RecordCommand, WhatCannotBeRecordedIsUsage)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& subject, const char* out, const Words& more, const Words& parts) {
        const test::Ended ended = test::vitrine(recording(subject, folder / out, more));
        EXPECT_EQ(ended.code, 2) << ended.err;
        test::expectOneSentence(ended, parts);
    };
    refused("sdf_morph", "a.avi", {}, {"a.avi", ".mp4", ".png"});
    refused("sdf_morph", "a.mp4", {"--size", "33x18"}, {"34x18"});
    refused("sdf_morph", "a.gif", {"--fps", "60"}, {"50"});
    refused("sdf_morph", "a.mp4", {"--alone", "--transparent"}, {"transparent"});
    refused("nothing", "a.mp4", {}, {"nothing", "vitrine list"});
    refused("sdf_morph", "a.mp4", {"--alone", "--path", "tour"}, {"tour", "alone"});
    refused("sdf_morph", "a.png", {}, {"a.png", "%04d.png"});
    refused("noise", "a.mp4", {"--turn", "360"}, {"turn", "alone"});
    for (const Words& more : {Words{"--seconds", "0"}, {"--fps", "nan"}, {"--shutter", "2"}, {"--path", "up"}})
        EXPECT_EQ(test::vitrine(recording("sdf_morph", folder / "a.mp4", more)).code, 2) << more.front();
    EXPECT_TRUE(folder.files().empty());
}

/// Returns the options that `vitrine COMMAND --help` names.
std::set<std::string> optionsOf(const std::string& command)
{
    const std::string help = test::vitrine({command, "--help"}).out;
    std::set<std::string> names;
    const std::regex name("(?:^|\n) +(?:-h,)?(--[a-z-]+)");
    for (std::sregex_iterator at(help.begin(), help.end(), name), end; at != end; ++at) names.insert((*at)[1]);
    return names;
}

TEST(RecordCommand, HasTheOptionsOfItsTableOfEverySceneAndOfEveryJobAndNoOther)
{
    std::set<std::string> expected{"--help", "--out", "--like", "--dry-run", "--json", "--shard"};
    for (const std::string& option : optionsOf("render"))
        if (const std::set<std::string> own{"--size", "--samples", "--run-everything", "--channels", "--sixteen-bit",
                                            "--report"};
            own.count(option) == 0)
            expected.insert(option);
    for (const jobs::JobOption& option : jobs::optionsOf(jobs::findJob("record")->parameters()))
        expected.insert(option.name);
    EXPECT_EQ(optionsOf("record"), expected);
}

TEST(RecordCommand, GoesOnFromTheSettingsBesideAFilm)
{
    const TemporaryFolder folder;
    const Words film{"--alone", "--seconds", "1", "--shutter", "0.5", "--shutter-samples", "2", "--set", "morph=0.8"};
    ASSERT_EQ(test::vitrine(recording("sdf_morph", folder / "a.apng", film)).code, 0);
    const test::Ended again = test::vitrine({"record", "--like", folder / "a.apng", "--out", folder / "b.apng"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(test::bytesOf(folder / "a.apng"), test::bytesOf(folder / "b.apng"));
    const test::Ended longer = test::vitrine(
        {"record", "--like", folder / "a.apng", "--seconds", "2", "--dry-run", "--json", "--out", folder / "c.apng"});
    ASSERT_EQ(longer.code, 0) << longer.err;
    EXPECT_NE(longer.out.find("\"value\": 8"), std::string::npos) << longer.out;
    EXPECT_FALSE(std::filesystem::exists(folder / "c.apng"));
}

TEST(RecordCommand, StoppedByCtrlCLeavesWholeFramesAndGoesOnLater)
{
    const TemporaryFolder folder;
    // So many frames that the recording cannot end before it is stopped.
    const Words words = recording("sdf_morph", folder / "%04d.png", {"--alone", "--seconds", "9000"});
    const pid_t child = test::startProgram(words);
    for (int i = 0; i < 6000 && !std::filesystem::exists(folder / "0003.png"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(std::filesystem::exists(folder / "0003.png"));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    for (const std::string& file : folder.files()) EXPECT_NO_THROW(static_cast<void>(render::readImage(folder / file)));
}

}  // namespace
}  // namespace vitrine
