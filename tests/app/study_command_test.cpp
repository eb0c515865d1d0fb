// `vitrine study`: written files, chosen settings, and errors for what cannot be measured.

#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
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

/// Runs a small study that takes a second or two.
Ended study(const std::string& out, std::vector<std::string> more)
{
    std::vector<std::string> words{"study",  "sdf_morph", "--size",           "48x27",   "--views", "2",
                                   "--runs", "3",         "--no-model-error", "--alone", "--out",   out};
    words.insert(words.begin() + 2, more.begin(), more.end());
    return test::vitrine(words);
}

TEST(LongStudyCommand, TakesEveryStudyOfTheResults)
{
    const test::TemporaryFolder folder;
    const std::string list = folder / "list";
    ASSERT_EQ(std::system(("sh '" VITRINE_SOURCE_DIR "/tests/bench/results.sh' --list >'" + list + "'").c_str()), 0);
    std::istringstream lines(textOf(list));
    const std::string program = " build/release/vitrine ";
    int studies = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto at = line.find(program);
        if (line.rfind("study_", 0) != 0 || at == std::string::npos) continue;
        const std::string command = VITRINE_PROGRAM " " + line.substr(at + program.size()) + " --dry-run >/dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        ++studies;
    }
    EXPECT_GE(studies, 20);
}

TEST(StudyCommand, AFolderThatCannotBeMadeIsSaidBeforeItMeasures)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "file", "");
    const Ended ended = study(folder / "file/study", {"hitTolerance"});
    EXPECT_EQ(ended.code, 5);
    test::expectOneSentence(ended, {"file/study", "the folder cannot be made", "--out"});
}

TEST(StudyCommand, WritesWhatItMeasuredAndAPageThatShowsIt)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "new/study";
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
    for (const render::Json& point : json["points"]) {  // A larger tolerance has more error and less work.
        EXPECT_GT(point["error"].get<double>(), lastError);
        EXPECT_LT(point["cost"].get<double>(), lastCost);
        lastError = point["error"].get<double>();
        lastCost = point["cost"].get<double>();
        EXPECT_EQ(point["views"].size(), 2U);
        EXPECT_EQ(point["views"][0]["ms"].size(), 3U);
        EXPECT_EQ(point["ms"]["runs"], 3);
    }
    EXPECT_TRUE(json["points"][1]["present"].get<bool>());

    // A header and a line for every point and view.
    const std::string csv = textOf(out + "/study.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 2);
    EXPECT_EQ(csv.rfind("hitTolerance,view,rmse,", 0), 0U) << csv.substr(0, 60);

    EXPECT_EQ(render::readImage(out + "/chart.png").width, 1440);
    EXPECT_NE(textOf(out + "/chart.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(render::readImage(out + "/pictures/point-3-view-2-heat.png").width, 48);
    const std::string page = textOf(out + "/index.html");
    for (const char* part : {"<svg", "pictures/reference-", "data-point=\"2\"", "Hit tolerance"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* network : {"http://", "https://", "//cdn", "@import"}) {
        // Names of XML namespaces are not loaded by the page.
        for (std::size_t at = page.find(network); at != std::string::npos; at = page.find(network, at + 1))
            EXPECT_EQ(page.substr(at, 18), "http://www.w3.org/") << page.substr(at, 60);
    }
}

/// Returns the texts of an SVG in their order.
std::string textsOf(const std::string& svg)
{
    std::string texts;
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
        const std::size_t start = svg.find('>', at) + 1;
        texts += svg.substr(start, svg.find("</text>", start) - start) + '\n';
    }
    return texts;
}

TEST(LongStudyCommand, ChartsShowMillisecondsWhereTheClockIsTrustedAndWorkWhereItIsAskedFor)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const std::vector<std::string> what{"hitTolerance", "--values", "0.25,1,4"};
    ASSERT_EQ(study(out, what).code, 0);
    const bool trusted = render::readJson(out + "/study.json").root()["clock"]["trusted"].get<bool>();
    const auto has = [&](const char* file, const char* words) {
        return textsOf(textOf(out + file)).find(words) != std::string::npos;
    };
    EXPECT_EQ(has("/chart.svg", "milliseconds of a picture"), trusted);
    EXPECT_EQ(has("/chart.svg", "field evaluations in all views"), !trusted);
    // The page has both charts, one of them hidden, and a button for each.
    const std::string page = textOf(out + "/index.html");
    EXPECT_TRUE(has("/index.html", "milliseconds of a picture"));
    EXPECT_TRUE(has("/index.html", "field evaluations in all views"));
    for (const char* cost : {"ms", "evaluations"}) {
        EXPECT_NE(page.find("<button data-cost=\"" + std::string(cost) + '"'), std::string::npos) << cost;
        const bool shown = (std::string(cost) == "ms") == trusted;
        const std::string chart = "<div class=\"chart\" data-with-cost=\"" + std::string(cost) + '"';
        ASSERT_NE(page.find(chart), std::string::npos) << cost;
        EXPECT_EQ(page.substr(page.find(chart) + chart.size(), 1), shown ? ">" : " ") << cost;
    }

    std::vector<std::string> asked = what;
    asked.insert(asked.end(), {"--cost", "work"});
    ASSERT_EQ(study(out, asked).code, 0);
    EXPECT_TRUE(has("/chart.svg", "field evaluations in all views"));
    EXPECT_FALSE(has("/chart.svg", "milliseconds of a picture"));
    EXPECT_TRUE(has("/index.html", "milliseconds of a picture"));
    asked.back() = "soup";
    const Ended refused = study(out, asked);
    EXPECT_EQ(refused.code, 2);
    test::expectOneSentence(refused, {"--cost", "soup", "ms", "work"});
}

TEST(StudyCommand, TheChartShowsWhatIsLeftAgainstEverythingExact)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const Ended ended = test::vitrine({"study", "sdf_morph", "hitTolerance", "--values", "0.25,1,4", "--size", "48x27",
                                       "--views", "1", "--runs", "3", "--alone", "--out", out});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (const char* file : {"/chart.svg", "/index.html"})
        EXPECT_NE(textsOf(textOf(out + file)).find("against everything exact"), std::string::npos) << file;
}

TEST(StudyCommand, ReplacesAStudyAndNothingElse)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    ASSERT_EQ(study(out, {"hitTolerance", "--values", "1,4"}).code, 0);
    ASSERT_EQ(study(out, {"stepLimit", "--values", "16,128"}).code, 0);
    EXPECT_EQ(render::readJson(out + "/study.json").root()["parameters"][0]["name"], "stepLimit");
    const auto entries = std::filesystem::directory_iterator(std::filesystem::path(out).parent_path());
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 2) << "part or old folders stayed beside the settings";

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

TEST(StudyCommand, NamesTheSettingsThatRepeatIt)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const std::vector<std::string> words{"relaxationFactor", "--values", "1.2,1.8"};
    std::vector<std::string> first = words;
    first.insert(first.end(), {"--set", "morph=0.4"});
    const Ended ended = study(out, first);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const std::string sentence =
        "Studied with “relaxation” at fixed instead of automatic, so that “relaxationFactor” acts.";
    EXPECT_NE(ended.out.find(sentence), std::string::npos) << ended.out;
    const render::Json json = render::readJson(out + "/study.json").root();
    const render::Json& changed = json["situation"]["changed"];
    ASSERT_EQ(changed.size(), 1U);
    EXPECT_EQ(changed[0], (render::Json{{"name", "relaxation"}, {"value", "fixed"}, {"instead", "automatic"}}));
    EXPECT_EQ(json["situation"]["sentences"], render::Json::array({sentence}));
    const std::string csv = textOf(out + "/study.csv");
    EXPECT_NE(csv.find("relaxation=fixed"), std::string::npos) << csv;
    EXPECT_NE(textOf(out + "/index.html").find("so that “Relaxation factor” acts."), std::string::npos);

    std::vector<std::string> again = words;
    for (const render::Json& setting : json["situation"]["set"])
        again.insert(again.end(), {"--set", setting.get<std::string>()});
    ASSERT_GE(again.size(), words.size() + 4) << "the morph and the relaxation";
    const std::string repeated = folder / "repeated";
    ASSERT_EQ(study(repeated, again).code, 0);
    const render::Json same = render::readJson(repeated + "/study.json").root();
    EXPECT_EQ(same["situation"]["changed"].size(), 0U);
    EXPECT_EQ(same["situation"]["set"], json["situation"]["set"]);
    ASSERT_EQ(same["points"].size(), json["points"].size());
    for (std::size_t i = 0; i < same["points"].size(); ++i) {
        EXPECT_EQ(same["points"][i]["error"], json["points"][i]["error"]);
        EXPECT_EQ(same["points"][i]["counters"], json["points"][i]["counters"]);
    }
}

TEST(StudyCommand, AsSetChangesNothingAndSaysThatNothingShows)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    ASSERT_EQ(study(out, {"relaxationFactor", "--values", "1.2,1.8", "--as-set"}).code, 0);
    const render::Json json = render::readJson(out + "/study.json").root();
    EXPECT_EQ(json["situation"]["changed"].size(), 0U);
    EXPECT_EQ(json["reference"]["why"].get<std::string>().rfind("Nothing depends on relaxationFactor", 0), 0U);
}

TEST(StudyCommand, SaysWhatItWouldMeasureAndStartsFromADocument)
{
    const test::TemporaryFolder folder;
    const std::string out = folder / "study";
    const std::vector<std::string> what{"relaxationFactor", "--values", "1.2,1.8", "--set", "morph=0.4"};
    std::vector<std::string> dry = what;
    dry.insert(dry.end(), {"--dry-run", "--json"});
    const Ended planned = study(out, dry);
    ASSERT_EQ(planned.code, 0) << planned.err;
    const render::Json plan = render::Json::parse(planned.out);
    EXPECT_EQ(plan["facts"][0], (render::Json{{"label", "Settings"}, {"value", 2.0}}));
    EXPECT_EQ(plan["files"][0]["path"], out);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));

    ASSERT_EQ(study(out, what).code, 0);
    const std::string again = folder / "again";
    ASSERT_EQ(test::vitrine({"study", "--like", out, "--out", again}).code, 0);
    const render::Json first = render::readJson(out + "/study.json").root();
    const render::Json second = render::readJson(again + "/study.json").root();
    EXPECT_EQ(second["situation"], first["situation"]);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(second["points"][i]["error"], first["points"][i]["error"]);
    const Ended other =
        test::vitrine({"study", "sdf_morph", "stepLimit", "--values", "8,16,32", "--like", out, "--dry-run"});
    EXPECT_NE(other.out.find("settings 3, views at most 2, picture size 48 × 27 px"), std::string::npos) << other.out;
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
    expectUsage({"hitTolerence"}, {"hitTolerence", "no such parameter; did you mean hitTolerance?"});
    expectUsage({"morph"}, {"morph", "no value of it is more exact", "hitTolerance"});
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
