// `vitrine compare-studies`: its page, and errors for studies that cannot be compared.

#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace vitrine {
namespace {

using render::Json;
using test::Ended;

/// Two small studies of one exhibit, measured once for all tests.
class CompareStudies : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        measured = new test::TemporaryFolder;
        const auto measure = [](const char* name, const char* row, const char* values) {
            const Ended ended =
                test::vitrine({"study", "sdf_morph", row, "--values", values, "--size", "48x27", "--views", "1",
                               "--runs", "3", "--no-model-error", "--alone", "--out", (*measured / name).string()});
            ASSERT_EQ(ended.code, 0) << ended.err;
        };
        measure("tolerance", "hitTolerance", "0.25,1,4");
        measure("steps", "stepLimit", "8,32,128");
    }
    static void TearDownTestSuite() { delete measured; }

    [[nodiscard]] static std::string file(const char* name) { return (*measured / name / "study.json").string(); }
    /// Returns a changed copy of the second study.
    [[nodiscard]] std::string changed(const char* pointer, const Json& value) const
    {
        Json json = render::readJson(file("steps"), {}).root();
        json[Json::json_pointer(pointer)] = value;
        const std::string path = folder_ / "changed.json";
        test::writeBytes(path, render::writeJson(json));
        return path;
    }
    [[nodiscard]] Ended compare(const std::string& a, const std::string& b,
                                const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> words{"compare-studies", a, b, "--out", out_};
        words.insert(words.end(), more.begin(), more.end());
        return test::vitrine(words);
    }

    static test::TemporaryFolder* measured;
    test::TemporaryFolder folder_;
    std::string out_ = folder_ / "compared";
};
test::TemporaryFolder* CompareStudies::measured = nullptr;

TEST_F(CompareStudies, OneChartOneTableOnePage)
{
    const Ended ended = compare(file("tolerance"), file("steps"), {"--cost", "evaluations"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_NE(ended.out.find("index.html"), std::string::npos);
    const Json json = render::readJson(out_ + "/study-comparison.json").root();
    EXPECT_EQ(json["format"], "vitrine-study-comparison");
    EXPECT_EQ(json["cost"], "evaluations");
    ASSERT_EQ(json["studies"].size(), 2U);
    EXPECT_EQ(json["studies"][0]["name"], "tolerance");
    EXPECT_EQ(json["studies"][1]["name"], "steps");
    // Counts per pixel: the study's own counts, divided by its pixels.
    const Json study = render::readJson(file("tolerance")).root();
    std::vector<double> costs;
    for (const Json& point : study["points"])
        costs.push_back(point["counters"]["evaluations"].get<double>() / (48 * 27));
    std::sort(costs.begin(), costs.end());
    for (std::size_t i = 0; i < costs.size(); ++i)
        EXPECT_DOUBLE_EQ(json["studies"][0]["points"][i]["cost"].get<double>(), costs[i]);
    EXPECT_FALSE(json["differences"].empty());
    EXPECT_EQ(render::readImage(out_ + "/chart.png").width, 1440);
    EXPECT_NE(test::bytesOf(out_ + "/chart.svg").find("<svg"), std::string::npos);
    const std::string page = test::bytesOf(out_ + "/index.html");
    for (const char* part :
         {"<svg", "tolerance", "steps", "field evaluations per pixel", "Error of the other study at this cost"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_NE(test::bytesOf(out_ + "/study-comparison.csv").find("\ntolerance,"), std::string::npos);

    // The page also has the times.
    for (const char* part : {"milliseconds of a picture", "<button data-cost=\"ms\"", "data-with-cost=\"ms\" hidden"})
        EXPECT_NE(page.find(part), std::string::npos) << part;

    // A second run writes the same bytes again. Without --cost, times are used if the clock is exact enough.
    ASSERT_EQ(compare(file("tolerance"), file("steps"), {"--cost", "evaluations"}).code, 0);
    EXPECT_EQ(test::bytesOf(out_ + "/index.html"), page);
    ASSERT_EQ(compare(file("tolerance"), file("steps")).code, 0);
    EXPECT_EQ(render::readJson(out_ + "/study-comparison.json").root()["cost"],
              study["clock"]["trusted"].get<bool>() ? "ms" : "evaluations");
    ASSERT_EQ(compare(file("tolerance"), file("steps"), {"--cost", "work"}).code, 0);
    EXPECT_EQ(render::readJson(out_ + "/study-comparison.json").root()["cost"], "evaluations");
    ASSERT_EQ(compare(file("tolerance"), file("steps"), {"--cost", "ms"}).code, 0);
    EXPECT_EQ(render::readJson(out_ + "/study-comparison.json").root()["cost"], "ms");
}

TEST_F(CompareStudies, TimesOfTwoMachinesAreRefusedAndWorkIsOffered)
{
    const std::string other = changed("/machine/renderer", "a graphics card");
    const Ended refused = compare(file("tolerance"), other, {"--cost", "ms"});
    EXPECT_EQ(refused.code, 1);
    test::expectOneSentence(refused, {"--cost ms", "different machines", "evaluations"});
    EXPECT_FALSE(std::filesystem::exists(out_));
    const Ended compared = compare(file("tolerance"), other);
    ASSERT_EQ(compared.code, 0) << compared.err;
    EXPECT_NE(compared.out.find("different machines"), std::string::npos);
    EXPECT_NE(test::bytesOf(out_ + "/index.html").find("different machines"), std::string::npos);
}

TEST_F(CompareStudies, WhatCannotBeReadOrComparedIsOneSentence)
{
    const auto expect = [&](const Ended& ended, int code, const std::vector<std::string>& parts) {
        EXPECT_EQ(ended.code, code) << ended.err;
        test::expectOneSentence(ended, parts);
        EXPECT_FALSE(std::filesystem::exists(out_));
    };
    expect(compare(file("tolerance"), folder_ / "none.json"), 5, {"none.json"});
    expect(compare(file("tolerance"), changed("/points/0/cost", "much")), 5, {"changed.json", "points[0].cost"});
    expect(compare(file("tolerance"), file("steps"), {"--cost", "beauty"}), 2, {"beauty", "evaluations"});
    expect(test::vitrine({"compare-studies", file("steps"), "--out", out_}), 2, {"two"});
    std::filesystem::create_directory(folder_ / "mine");
    test::writeBytes(folder_ / "mine/letter.txt", "dear");
    const Ended refused =
        test::vitrine({"compare-studies", file("steps"), file("tolerance"), "--out", folder_ / "mine"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(test::bytesOf(folder_ / "mine/letter.txt"), "dear");
}

}  // namespace
}  // namespace vitrine
