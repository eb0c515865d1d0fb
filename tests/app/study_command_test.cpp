// `vitrine study`: what it writes, what it chooses, and what it says of what it cannot measure.

#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace vitrine {
namespace {

using test::Ended;

std::string textOf(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// A small study that takes a second or two.
Ended study(const std::string& out, std::vector<std::string> more)
{
    std::vector<std::string> words{"study",  "sdf_morph", "--size",           "48x27",   "--views", "2",
                                   "--runs", "3",         "--no-model-error", "--alone", "--out",   out};
    words.insert(words.begin() + 2, more.begin(), more.end());
    return test::vitrine(words);
}

TEST(StudyCommand, WritesWhatItMeasuredAndAPageThatShowsIt)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const Ended ended = study(out, {"hitTolerance", "--values", "0.25,1,4"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(test::withoutProgress(ended.err), "");

    const render::Json json = render::readJson(out + "/study.json").root();
    EXPECT_EQ(json["format"], "vitrine-study");
    EXPECT_EQ(json["exhibit"], "sdf_morph");
    EXPECT_EQ(json["cost"], "evaluations");
    EXPECT_TRUE(json["clock"]["trusted"].is_boolean());
    EXPECT_TRUE(json["reference"]["converged"].is_boolean());
    ASSERT_EQ(json["points"].size(), 3U);
    double lastError = -1;
    double lastCost = 1e18;
    for (const render::Json& point : json["points"]) {  // A wider tolerance: more error, less work.
        EXPECT_GT(point["error"].get<double>(), lastError);
        EXPECT_LT(point["cost"].get<double>(), lastCost);
        lastError = point["error"].get<double>();
        lastCost = point["cost"].get<double>();
        EXPECT_EQ(point["views"].size(), 2U);
        EXPECT_EQ(point["views"][0]["ms"].size(), 3U);
        EXPECT_EQ(point["ms"]["runs"], 3);
    }
    EXPECT_TRUE(json["points"][1]["present"].get<bool>());

    // A head and a line for every point and view.
    const std::string csv = textOf(out + "/study.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 2);
    EXPECT_EQ(csv.rfind("hitTolerance,view,rmse,", 0), 0U) << csv.substr(0, 60);

    EXPECT_EQ(render::readImage(out + "/chart.png").width, 1440);
    EXPECT_NE(textOf(out + "/chart.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(render::readImage(out + "/pictures/point-3-view-2-heat.png").width, 48);
    const std::string page = textOf(out + "/index.html");
    for (const char* part : {"<svg", "pictures/reference-", "data-point=\"2\"", "hitTolerance"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* network : {"http://", "https://", "//cdn", "@import"}) {
        // Names of XML vocabularies are no addresses that a page opens.
        for (std::size_t at = page.find(network); at != std::string::npos; at = page.find(network, at + 1))
            EXPECT_EQ(page.substr(at, 18), "http://www.w3.org/") << page.substr(at, 60);
    }
}

TEST(StudyCommand, ReplacesAStudyAndNothingElse)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    ASSERT_EQ(study(out, {"hitTolerance", "--values", "1,4"}).code, 0);
    ASSERT_EQ(study(out, {"stepLimit", "--values", "16,128"}).code, 0);
    EXPECT_EQ(render::readJson(out + "/study.json").root()["parameters"][0]["name"], "stepLimit");
    const auto entries = std::filesystem::directory_iterator(std::filesystem::path(out).parent_path());
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "part or old folders stayed";

    const std::string other = folder / "mine";
    std::filesystem::create_directory(other);
    std::ofstream(other + "/letter.txt") << "dear";
    const Ended refused = study(other, {"hitTolerance"});
    EXPECT_EQ(refused.code, 2);
    test::expectOneSentence(refused, {"mine", "study"});
    EXPECT_EQ(textOf(other + "/letter.txt"), "dear");
}

TEST(StudyCommand, WritesThePresetThatItChose)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const Ended ended = study(out, {"hitTolerance", "--values", "0.05,1,4,16", "--max-error", "0.2"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("Cheapest within rmse 0.2"), std::string::npos) << ended.out;
    const render::Json preset = render::readJson(out + "/preset.json").root();
    EXPECT_EQ(preset["exhibit"], "sdf_morph");
    EXPECT_EQ(test::vitrine({"preset", "check", out + "/preset.json"}).code, 0);
    EXPECT_TRUE(render::readJson(out + "/study.json").root()["choice"]["holds"].get<bool>());
}

TEST(StudyCommand, WhatCannotBeHadIsAFailedCheckWithoutAPreset)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const Ended ended = study(out, {"hitTolerance", "--values", "4,16", "--max-error", "1e-9"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("1e-09"), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(out + "/preset.json"));
    EXPECT_TRUE(std::filesystem::exists(out + "/study.json")) << "what was measured is still worth having";
}

TEST(StudyCommand, WhatIsTypedWronglyIsSaidInOneSentence)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const auto expectUsage = [&](const std::vector<std::string>& words, const std::vector<std::string>& parts) {
        const Ended ended = study(out, words);
        EXPECT_EQ(ended.code, 2) << words[0];
        test::expectOneSentence(ended, parts);
        EXPECT_FALSE(std::filesystem::exists(out)) << words[0];
    };
    expectUsage({"hitTolerence"}, {"hitTolerence", "hitTolerance"});
    expectUsage({"morph"}, {"morph", "accuracy", "hitTolerance"});
    expectUsage({"hitTolerance", "hitTolerance"}, {"hitTolerance", "twice"});
    expectUsage({"hitTolerance", "--values", "1,soup"}, {"--values", "soup", "hitTolerance"});
    expectUsage({"hitTolerance", "--values", "1,1e9"}, {"--values", "1e9"});
    expectUsage({"hitTolerance", "stepLimit", "--values", "1"}, {"--values", "one parameter"});
    expectUsage({"hitTolerance", "--metric", "ssim"}, {"--metric", "ssim", "flip"});
    expectUsage({"hitTolerance", "--metric", "psnr"}, {"psnr", "rmse"});
    expectUsage({"fur.length"}, {"fur.length", "hall"});
    EXPECT_EQ(study(out, {"hitTolerance", "--max-error", "1", "--max-ms", "1"}).code, 2);
}

}  // namespace
}  // namespace vitrine
