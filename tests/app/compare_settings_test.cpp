// `vitrine compare-settings`: its page, and errors for settings that cannot be compared.

#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/measure/flip.h"
#include "render/measure/metrics.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace vitrine {
namespace {

using test::Ended;

class CompareSettings : public testing::Test {
protected:
    [[nodiscard]] std::string preset(const char* name, const std::string& values) const
    {
        const std::string path = folder_ / name;
        std::ofstream(path) << R"({"format": "vitrine-preset", "version": 1, "exhibit": "sdf_morph", "name": "Mine", )"
                            << R"("values": )" << values << "}\n";
        return path;
    }
    [[nodiscard]] Ended compare(const std::string& a, const std::string& b, const std::vector<std::string>& more = {})
    {
        std::vector<std::string> words{"compare-settings", a,   b,        "--out", out_, "--size", "48x27",
                                       "--samples",        "1", "--runs", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return test::vitrine(words);
    }
    [[nodiscard]] std::string text(const char* name) const { return render::readFile(out_ + '/' + name, 16U << 20U); }
    [[nodiscard]] render::Image picture(const std::string& name) const
    {
        return render::readImage(out_ + "/pictures/" + name);
    }
    /// Returns whether the parent folder has only the result and presets.
    [[nodiscard]] bool nothingElseStayed() const
    {
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            if (entry.path() != out_ && entry.path().extension() != ".json") return false;
        return true;
    }

    test::TemporaryFolder folder_;
    std::string out_ = folder_ / "compared";
};

using LongCompareSettings = CompareSettings;

TEST_F(LongCompareSettings, ShowsBothPicturesTheirDifferencesTheRowsAndTheCosts)
{
    const std::string a = preset("a.json", R"({"morph": 0.1})"), b = preset("b.json", R"({"morph": 0.9})");
    const Ended ended = compare(a, b, {"--gain", "4"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const render::Json json = render::readJson(out_ + "/comparison.json").root();
    EXPECT_EQ(json["format"], "vitrine-comparison");
    ASSERT_EQ(json["rows"].size(), 1U) << json["rows"].dump();
    EXPECT_EQ(json["rows"][0]["name"], "morph");
    EXPECT_EQ(json["rows"][0]["a"], 0.1);
    EXPECT_EQ(json["rows"][0]["b"], 0.9);
    EXPECT_EQ(json["ms"]["b"]["runs"], 2);

    // The report's errors must be those of the pictures.
    const render::Image first = picture("a.png"), second = picture("b.png");
    ASSERT_EQ(first.width, 48);
    EXPECT_GT(json["errors"]["flip"].get<double>(), 0.002);
    EXPECT_NEAR(json["errors"]["flip"].get<double>(), render::flip(first, second), 0.01);
    const render::Image drawn = picture("signed-4.png"), expected = render::signedDifference(first, second, 4);
    EXPECT_LT(render::colorDifference(drawn, expected).rmse, 0.03) << "8 bits, four times";
    EXPECT_GT(render::colorDifference(drawn, render::signedDifference(second, first, 4)).rmse, 0.03) << "the sign";

    bool marched = false;
    for (const render::Json& pass : json["passes"])
        marched = marched || (pass["name"] == "sdf_morph/march" && pass["a"]["state"] == "ran" &&
                              pass["b"]["ms"].is_number() && pass["b"]["ms"] >= 0);
    EXPECT_TRUE(marched) << json["passes"].dump();
    EXPECT_GT(json["counters"]["evaluations"]["a"].get<double>(), 0);

    const std::string page = text("index.html");
    for (const char* part : {"pictures/a.png", "Side by side", "1 parameter differs", "sdf_morph/march", "\"gain\":4"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* network : {"http://", "https://", "@import"}) EXPECT_EQ(page.find(network), std::string::npos);
    EXPECT_TRUE(nothingElseStayed());

    // Each picture restores its settings: compared with the file that it was made from, nothing differs.
    const std::string kept = folder_ / "kept.png";
    std::filesystem::copy_file(out_ + "/pictures/b.png", kept);
    std::ofstream(out_ + "/notes.txt") << "mine";
    std::ofstream(out_ + "/pictures/thoughts.txt") << "mine, too";
    std::ofstream(out_ + "/pictures/old.png") << "of an older comparison";
    const Ended again = compare(kept, b);
    std::filesystem::remove(kept);
    ASSERT_EQ(again.code, 0) << again.err;
    const render::Json same = render::readJson(out_ + "/comparison.json").root();
    EXPECT_TRUE(same["rows"].empty()) << same["rows"].dump();
    EXPECT_EQ(same["errors"]["flip"], 0);
    EXPECT_EQ(same["errors"]["psnr"], "infinite");
    EXPECT_TRUE(nothingElseStayed()) << "the page was replaced";
    EXPECT_EQ(text("notes.txt"), "mine");
    EXPECT_EQ(text("pictures/thoughts.txt"), "mine, too");
    EXPECT_FALSE(std::filesystem::exists(out_ + "/pictures/old.png"));
}

TEST_F(LongCompareSettings, ComparesWithWhatTheExhibitOffers)
{
    const auto with = [&](const std::string& a, const std::vector<std::string>& more) {
        std::vector<std::string> words{"compare-settings", a,   "--out",  out_, "--size", "48x27",
                                       "--samples",        "1", "--runs", "1"};
        words.insert(words.end(), more.begin(), more.end());
        return test::vitrine(words);
    };
    const auto differing = [&] {
        const render::Json json = render::readJson(out_ + "/comparison.json").root();
        std::map<std::string, render::Json> rows;
        for (const render::Json& row : json["rows"]) rows[row["name"]] = row;
        return rows;
    };
    // The name of an exhibit stands for its initial values.
    const Ended field = with("sdf_morph", {"--with", "mesh"});
    ASSERT_EQ(field.code, 0) << field.err;
    auto rows = differing();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows["shownAs"]["b"], "mesh");
    EXPECT_NE(text("index.html").find("The rasterized mesh"), std::string::npos);
    const render::Image marched = picture("a.png"), mesh = picture("b.png");
    // The exhibit of settings in a file is the one that they change.
    const Ended changed = with(preset("mesh.json", R"({"shownAs": "mesh"})"), {"--with", "field"});
    ASSERT_EQ(changed.code, 0) << changed.err;
    rows = differing();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows["shownAs"]["a"], "mesh");
    EXPECT_EQ(render::colorDifference(picture("a.png"), mesh).rmse, 0) << "A there is B here";
    EXPECT_EQ(render::colorDifference(picture("b.png"), marched).rmse, 0);
    // A shipped preset can be given by name.
    const Ended shipped = with("gathered-in-screen-space", {"--exhibit", "crepuscular_rays", "--with", "air"});
    ASSERT_EQ(shipped.code, 0) << shipped.err;
    EXPECT_EQ(differing()["technique"]["b"], "volume");

    const auto refused = [&](const Ended& ended, const std::vector<std::string>& parts) {
        EXPECT_EQ(ended.code, 2) << ended.err;
        test::expectOneSentence(ended, parts);
    };
    refused(with("sdf_morph", {"--with", "soup"}), {"soup", "mesh, field, cost"});
    refused(with("fur", {"--with", "mesh"}), {"fur", "offers no comparisons"});
    refused(with("initial", {"--with", "mesh"}), {"--exhibit"});
    refused(with("sdf_morph", {}), {"--with"});
    refused(with("sdf_morph", {"initial", "--with", "mesh"}), {"not both"});
}

TEST_F(LongCompareSettings, PlansAndIsRunAgainByItsDocument)
{
    const std::string a = preset("a.json", R"({"morph": 0.1})"), b = preset("b.json", R"({"morph": 0.9})");
    const Ended planned = compare(a, b, {"--dry-run", "--json", "--time", "2"});
    ASSERT_EQ(planned.code, 0) << planned.err;
    EXPECT_FALSE(std::filesystem::exists(out_));
    const render::Json plan = render::parseJson(planned.out, "plan").root();
    EXPECT_EQ(plan["job"], "comparison");
    ASSERT_EQ(plan["files"].size(), 2U);
    EXPECT_EQ(plan["files"][0]["path"], out_);
    EXPECT_EQ(plan["facts"][1], (render::Json{{"label", "Parameters that differ"}, {"value", 1.0}}));

    ASSERT_EQ(compare(a, b, {"--time", "2", "--gain", "16", "--eye", "1,1.5,3"}).code, 0);
    const render::Json first = render::readJson(out_ + "/comparison.json").root();
    const std::string again = folder_ / "again";
    std::filesystem::remove(a);
    std::filesystem::remove(b);
    const Ended ended = test::vitrine({"compare-settings", "--like", out_, "--out", again, "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(render::parseJson(ended.out, "report").root()["facts"][0]["value"], 1.0);
    const render::Json second = render::readJson(again + "/comparison.json").root();
    for (const char* key : {"a", "b", "size", "samples", "time", "seed", "camera", "rows", "errors", "counters"})
        EXPECT_EQ(second[key], first[key]) << key;
    EXPECT_EQ(second["time"], 2.0);
    EXPECT_EQ(render::readFile(again + "/pictures/b.png", 16U << 20U), text("pictures/b.png"));
    std::filesystem::remove_all(again);
}

TEST_F(CompareSettings, WhatCannotBeReadLeavesWhatIsThere)
{
    const std::string good = preset("good.json", "{}"), bad = preset("bad.json", R"({"morph": "soup"})");
    std::filesystem::create_directory(out_);
    std::ofstream(out_ + "/comparison.json") << "old";
    const auto expectFailure = [&](const std::string& a, const std::string& b, int code,
                                   const std::vector<std::string>& parts, const std::vector<std::string>& more = {}) {
        const Ended ended = compare(a, b, more);
        EXPECT_EQ(ended.code, code) << ended.err;
        test::expectOneSentence(ended, parts);
        EXPECT_EQ(text("comparison.json"), "old");
        EXPECT_TRUE(nothingElseStayed());
    };
    expectFailure(good, bad, 5, {"bad.json", "morph"});
    expectFailure(good, folder_ / "none.json", 5, {"none.json"});
    expectFailure(good, "no-such-preset", 5, {"no-such-preset", "old-gold"}, {"--exhibit", "sdf_morph"});
    expectFailure(good, good, 2, {"no_exhibit"}, {"--exhibit", "no_exhibit"});
    expectFailure(good, good, 2, {"--eye", "1,2"}, {"--eye", "1,2"});
    EXPECT_EQ(compare(good, good, {"--gain", "3"}).code, 2);
}

TEST_F(CompareSettings, ReplacesNothingThatIsNoComparison)
{
    const std::string good = preset("good.json", "{}");
    std::filesystem::create_directory(out_);
    std::ofstream(out_ + "/letter.txt") << "dear";
    const Ended refused = compare(good, "initial");
    EXPECT_EQ(refused.code, 2);
    test::expectOneSentence(refused, {"compared", "comparison"});
    EXPECT_EQ(text("letter.txt"), "dear");
}

}  // namespace
}  // namespace vitrine
