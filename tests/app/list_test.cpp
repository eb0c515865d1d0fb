#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/job_options.h"
#include "render/files/strict_json.h"
#include "tests/app/child_process.h"
#include "tests/support/german_locale.h"

#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using render::Json;
using test::Ended;

std::set<std::string> keysOf(const Json& object)
{
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

TEST(List, NamesTheHallAndTheExhibits)
{
    const Ended ended = test::vitrine({"list"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_EQ(ended.out.rfind("hall ", 0), 0U) << ended.out;
    EXPECT_NE(ended.out.find("\nsdf_morph "), std::string::npos) << ended.out;
}

TEST(List, OfJobsHasASchemaOfEachAndTheirHelpEveryOption)
{
    const Ended listed = test::vitrine({"list", "--jobs"}), ended = test::vitrine({"list", "--jobs", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json schemas = render::parseJson(ended.out, "list").root();
    ASSERT_EQ(schemas.size(), jobs::allJobs().size());
    for (std::size_t i = 0; i < schemas.size(); ++i) {
        const jobs::Job& job = *jobs::allJobs()[i];
        EXPECT_EQ(schemas[i]["title"], std::string(job.name()));
        EXPECT_NE(listed.out.find(std::string(job.summary())), std::string::npos) << listed.out;
        std::istringstream command{std::string(job.command())};
        std::vector<std::string> words{std::istream_iterator<std::string>(command), {}};
        words.emplace_back("--help");
        const Ended help = test::vitrine(words);
        ASSERT_EQ(help.code, 0) << help.err;
        for (const jobs::JobOption& option : jobs::optionsOf(job.parameters())) {
            const bool shown = help.out.find("  " + option.name) != std::string::npos;
            const bool shownOff = option.isFlag && help.out.find("  " + jobs::withoutFlag(option)) != std::string::npos;
            EXPECT_TRUE(shown || shownOff) << job.name() << ' ' << option.name;
            const std::string type = jobs::typeText(job.parameters(), option);
            EXPECT_NE(help.out.find(type), std::string::npos) << job.name() << ' ' << option.name;
        }
    }
    EXPECT_EQ(test::vitrine({"list", "--jobs", "--manual", "fur"}).code, 2);
}

TEST(List, AsJsonHasExactlyTheFieldsThatArePromised)
{
    const Ended ended = test::vitrine({"list", "--json"});
    ASSERT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
    const Json document = render::parseJson(ended.out, "list").root();
    EXPECT_EQ(document["format"], "vitrine-exhibits");
    EXPECT_EQ(document["version"], 1);
    const Json& all = document["exhibits"];
    ASSERT_TRUE(all.is_array());
    const std::set<std::string> kinds{"real", "count", "toggle", "choice", "color", "direction", "file", "text"};
    int rows = 0, qualities = 0, conditions = 0, offers = 0;
    for (const Json& exhibit : all) {
        EXPECT_EQ(keysOf(exhibit),
                  (std::set<std::string>{"name", "complete", "title", "summary", "parameters", "comparisons"}));
        for (const Json& offered : exhibit["comparisons"]) {
            ++offers;
            EXPECT_EQ(keysOf(offered), (std::set<std::string>{"name", "title", "help", "values"}));
            EXPECT_FALSE(offered["values"].empty()) << offered["name"];
        }
        for (const Json& row : exhibit["parameters"]) {
            ++rows;
            EXPECT_EQ(keysOf(row),
                      (std::set<std::string>{"name", "label", "group", "kind", "unit", "low", "high", "softLow",
                                             "softHigh", "scale", "initial", "help", "choices", "quality", "actsWhen"}))
                << row["name"];
            EXPECT_TRUE(kinds.contains(row["kind"].get<std::string>())) << row["kind"];
            EXPECT_TRUE(row["scale"] == "linear" || row["scale"] == "logarithmic");
            EXPECT_TRUE(row["choices"].is_array());
            EXPECT_EQ(row["choices"].empty(), row["kind"] != "choice");
            if (!row["quality"].is_null()) {
                ++qualities;
                EXPECT_EQ(keysOf(row["quality"]), std::set<std::string>{"reference"});
            }
            if (!row["actsWhen"].is_null()) {
                ++conditions;
                const Json& when = row["actsWhen"];
                const bool ofParts = when["test"] == "all" || when["test"] == "any";
                EXPECT_EQ(keysOf(when), ofParts ? (std::set<std::string>{"test", "parts"})
                                                : (std::set<std::string>{"test", "row", "values"}))
                    << row["name"];
            }
            if (row["name"] == "timeOfDay") {
                EXPECT_EQ(row["actsWhen"], (Json{{"test", "among"}, {"row", "sunBy"}, {"values", {"time of day"}}}));
            }
            if (row["kind"] == "real" || row["kind"] == "count") {
                EXPECT_LE(row["low"].get<double>(), row["initial"].get<double>());
                EXPECT_GE(row["high"].get<double>(), row["initial"].get<double>());
            }
        }
    }
    EXPECT_GE(offers, 9);
    EXPECT_GT(rows, 40);
    EXPECT_GT(qualities, 5);
    EXPECT_GT(conditions, 50);
    const auto sdf = std::find_if(all.begin(), all.end(), [](const Json& e) { return e["name"] == "sdf_morph"; });
    ASSERT_NE(sdf, all.end());
    EXPECT_EQ((*sdf)["parameters"][0]["name"], "morph");
}

TEST(List, PrintsTheParametersOfAnExhibitAsATable)
{
    const Ended ended = test::vitrine({"list", "sdf_morph"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json document = render::parseJson(test::vitrine({"list", "sdf_morph", "--json"}).out, "list").root();
    ASSERT_EQ(document["exhibits"].size(), 1U);
    const Json& exhibit = document["exhibits"][0];
    EXPECT_EQ(exhibit["name"], "sdf_morph");
    const std::size_t lines = static_cast<std::size_t>(std::count(ended.out.begin(), ended.out.end(), '\n'));
    std::set<std::string> groups;
    for (const Json& row : exhibit["parameters"]) {
        groups.insert(row["group"].get<std::string>());
        EXPECT_NE(ended.out.find("\n  " + row["name"].get<std::string>() + ' '), std::string::npos) << row["name"];
        EXPECT_NE(ended.out.find(row["help"].get<std::string>() + '\n'), std::string::npos) << row["name"];
    }
    EXPECT_GE(lines, exhibit["parameters"].size() + groups.size());
    EXPECT_TRUE(std::regex_search(ended.out, std::regex("\n  morph +0\\.62 +0\\.\\.1 +"))) << ended.out;
    test::expectOneSentence(test::vitrine({"list", "sdf_morhp"}), {"sdf_morhp", "sdf_morph"});
}

TEST(LongList, SpeaksTheSameInEveryLocale)
{
    const test::GermanLocale german;
    if (!german.active()) GTEST_SKIP() << "there is no German locale here";
    const std::string plain = test::vitrine({"list", "--json"}, {{"LC_ALL", "C"}}).out;
    EXPECT_NE(plain.find("0.62"), std::string::npos);
    EXPECT_EQ(test::vitrine({"list", "--json"}, {{"LC_ALL", "de_DE.UTF-8"}}).out, plain);
}

TEST(Doctor, SaysWhatThisMachineCanDo)
{
    const Ended ended = test::vitrine({"doctor", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    const Json report = render::parseJson(ended.out, "doctor").root();
    EXPECT_EQ(report["format"], "vitrine-doctor");
    EXPECT_EQ(report["version"], 1);
    EXPECT_TRUE(report["opengl"]["usable"].get<bool>());
    EXPECT_GE(report["limits"]["textureSize"].get<int>(), 4096);
    EXPECT_FALSE(report["clock"]["method"].get<std::string>().empty());
    EXPECT_FALSE(report["clock"]["why"].get<std::string>().empty());
    const std::regex version(R"(\d+(\.\d+)+.*)");
    for (const char* library : {"Bullet", "CLI11", "GLM", "OpenImageIO", "QCustomPlot", "Qt", "libavcodec", "libepoxy",
                                "libpng", "nlohmann-json", "tinygltf"})
        EXPECT_TRUE(std::regex_match(report["libraries"].value(library, ""), version))
            << library << " " << report["libraries"].value(library, "is missing");
    EXPECT_NE(test::vitrine({"doctor"}).out.find(report["opengl"]["renderer"].get<std::string>()), std::string::npos);
}

TEST(DoctorStability, TriesTheHardCasesOnTheDriver)
{
    const Ended ended = test::vitrine({"doctor", "--stability", "--presets", "2", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    // Only progress is printed; the number of lines depends on the time.
    const std::regex progress(
        "vitrine: trying the hard cases, then up to 2 random settings of each exhibit, for 5 minutes at "
        "most\\.\n"
        "(vitrine: hard cases and random settings \\d+ %(, \\d+:\\d\\d left)?\n)*");
    EXPECT_TRUE(std::regex_match(ended.err, progress)) << ended.err;
    const Json report = render::parseJson(ended.out, "doctor").root();
    EXPECT_FALSE(report["opengl"]["renderer"].get<std::string>().empty());
    ASSERT_GT(report["cases"].size(), 20U);
    for (const Json& line : report["cases"]) {
        EXPECT_TRUE(line["holds"].get<bool>()) << line.dump();
        EXPECT_LE(line["value"].get<double>(), line["limit"].get<double>()) << line.dump();
    }
    EXPECT_FALSE(report["limitedByTime"].get<bool>()) << ended.out;
    // A million settings are not tried in three seconds. The table says how many were, and every exhibit has its line;
    // nothing that was not run is said to hold.
    const std::string table = test::vitrine({"doctor", "--stability", "--presets", "1000000", "--minutes", "0.05"}).out;
    for (const char* part : {"renderer  ", "H22 ", "sdf_morph: ", "holds",
                             "your_shader: ", "The time of 0.05 minutes was over before 1000000 settings"})
        EXPECT_NE(table.find(part), std::string::npos) << part << '\n' << table;
    EXPECT_TRUE(std::regex_search(table, std::regex("\nEverything( that was tried)? holds\\.\n"))) << table;
    EXPECT_FALSE(std::regex_search(table, std::regex("holds .* in 0 pictures"))) << table;
    EXPECT_EQ(test::vitrine({"doctor", "--stability", "--presets", "0"}).code, 2);
}

TEST(Doctor, OnAnOldMachineSaysWhatIsThereAndWhatIsNeeded)
{
    const Ended ended = test::vitrine({"doctor", "--json"}, {{"MESA_GL_VERSION_OVERRIDE", "3.3"}});
    EXPECT_EQ(ended.code, 3);
    const Json report = render::parseJson(ended.out, "doctor").root();
    EXPECT_FALSE(report["opengl"]["usable"].get<bool>());
    EXPECT_NE(report["opengl"]["why"].get<std::string>().find("4.5"), std::string::npos);
}

}  // namespace
}  // namespace vitrine
