// The program as a command line sees it: exit codes, messages, files; no display anywhere.

#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using vitrine::render::Json;

struct Result {
    int code = -1;
    std::string out, error;
};

class Cli : public testing::Test {
protected:
    void SetUp() override
    {
        std::string pattern = (fs::temp_directory_path() / "vitrine-cli-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::string read(const std::string& name) const { return vitrine::render::readFile(folder_ / name, 1U << 28U); }

    /// Runs the program without display, its caches in a folder of this test.
    Result run(const std::string& arguments, const std::string& environment = "") const
    {
        const std::string errorFile = path("stderr");
        const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY " + environment + " '" VITRINE_PROGRAM "' " + arguments + " 2>'" + errorFile + "' </dev/null";
        Result result;
        FILE* pipe = popen(command.c_str(), "r");
        if (!pipe) return result;
        std::array<char, 65536> buffer{};
        for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) result.out.append(buffer.data(), n);
        const int status = pclose(pipe);
        result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + status;
        result.error = vitrine::render::readFile(errorFile, 1U << 20U);
        return result;
    }

    fs::path folder_;
};

std::size_t lines(const std::string& text)
{
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Cli, ListNamesExhibitsAndEverythingAboutTheirParameters)
{
    const Result result = run("list --json");
    ASSERT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(result.error, "");
    const Json list = vitrine::render::parseJson(result.out, "list").root();
    bool found = false;
    for (const Json& exhibit : list) {
        for (const char* key : {"name", "title", "summary"}) EXPECT_FALSE(exhibit.at(key).get<std::string>().empty());
        int quality = 0;
        for (const Json& row : exhibit.at("parameters")) {
            for (const char* key : {"name", "kind", "unit", "low", "high", "softLow", "softHigh", "scale", "initial", "help", "choices", "quality"})
                EXPECT_TRUE(row.contains(key)) << exhibit["name"] << ' ' << row["name"] << ": " << key;
            EXPECT_LE(row["low"].get<double>(), row["softLow"].get<double>());
            EXPECT_GE(row["high"].get<double>(), row["softHigh"].get<double>());
            if (!row["quality"].is_null()) {
                EXPECT_TRUE(row["quality"].contains("reference"));
                ++quality;
            }
        }
        EXPECT_GT(quality, 0) << exhibit["name"];
        found = found || exhibit["name"] == "sdf_morph";
    }
    EXPECT_TRUE(found);
    EXPECT_NE(run("list").out.find("sdf_morph"), std::string::npos);
}

TEST_F(Cli, HelpNeedsNeitherDisplayNorOpenGl)
{
    for (const char* arguments : {"--help", "render --help", "preset check --help", "--version"}) {
        const Result result = run(arguments, "MESA_GL_VERSION_OVERRIDE=3.3 __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null");
        EXPECT_EQ(result.code, 0) << arguments << result.error;
        EXPECT_FALSE(result.out.empty());
    }
}

TEST_F(Cli, WrongUsageIsExitCodeTwoAndOneMessage)
{
    const std::string out = " --out '" + path("a.png") + "'";
    for (const std::string& arguments : {std::string("--no-such-option"), std::string("render"), "render no_such_exhibit" + out, "render sdf_morph --out '" + path("a.gif") + "'",
                                         "render sdf_morph --size 0x10" + out, "render sdf_morph --size 64" + out, "render sdf_morph --set morph" + out,
                                         "render sdf_morph --set nothing=1" + out, "render sdf_morph --set morph=warm" + out, "render sdf_morph --set morph=nan" + out,
                                         "render sdf_morph --set nobody.morph=1" + out, "render hall --alone" + out, "render sdf_morph --scale 0,1,1" + out,
                                         "render sdf_morph --eye 1,2" + out, "render sdf_morph --fov 500" + out, "render sdf_morph --channels depth" + out,
                                         "render sdf_morph --channels color,heat --out '" + path("a.exr") + "'"}) {
        const Result result = run(arguments);
        EXPECT_EQ(result.code, 2) << arguments << ": " << result.error;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_FALSE(result.error.empty()) << arguments;
    }
    EXPECT_FALSE(fs::exists(path("a.png")));
    EXPECT_NE(run("render sdf_morph --set morph=warm" + out).error.find("morph"), std::string::npos);
}

TEST_F(Cli, WithoutOpenGl45ItSaysSoAndExitsWithThree)
{
    for (const char* command : {"render sdf_morph --size 8x8 --out '/nonexistent/a.png'", "doctor"}) {
        const Result result = run(command, "MESA_GL_VERSION_OVERRIDE=3.3");
        EXPECT_EQ(result.code, 3) << command << result.error;
    }
    EXPECT_EQ(lines(run("render sdf_morph --size 8x8 --out '" + path("a.png") + "'", "MESA_GL_VERSION_OVERRIDE=3.3").error), 1U);
}

TEST_F(Cli, AFileThatCannotBeWrittenIsExitCodeFiveAndLeavesNothing)
{
    const Result result = run("render sdf_morph --alone --size 16x9 --samples 1 --out '" + path("no/such/folder/a.png") + "'");
    EXPECT_EQ(result.code, 5) << result.error;
    EXPECT_NE(result.error.find("no/such/folder"), std::string::npos) << result.error;
    EXPECT_FALSE(fs::exists(path("no")));
    EXPECT_EQ(run("render sdf_morph --alone --size 16x9 --preset '" + path("none.json") + "' --out '" + path("a.png") + "'").code, 5);
    EXPECT_FALSE(fs::exists(path("a.png")));
}

TEST_F(Cli, TheSameInputsGiveTheSameBytesInAnyLocale)
{
    const std::string arguments = "render sdf_morph --size 64x36 --samples 2 --time 3 --seed 5 --set morph=0.3 --set shadowMethod=area --out '";
    ASSERT_EQ(run(arguments + path("a.png") + "'").code, 0);
    ASSERT_EQ(run(arguments + path("b.png") + "'").code, 0);
    ASSERT_EQ(run(arguments + path("c.png") + "'", "LC_ALL=de_DE.UTF-8").code, 0);
    EXPECT_EQ(read("a.png"), read("b.png"));
    EXPECT_EQ(read("a.png"), read("c.png"));
    ASSERT_EQ(run("render sdf_morph --size 64x36 --samples 2 --time 3 --seed 5 --set morph=0.4 --set shadowMethod=area --out '" + path("d.png") + "'").code, 0);
    EXPECT_NE(read("a.png"), read("d.png"));
}

TEST_F(Cli, APictureCarriesThePresetThatMadeIt)
{
    ASSERT_EQ(run("render sdf_morph --size 64x36 --samples 1 --set morph=0.3 --set metalness=0 --out '" + path("a.png") + "'").code, 0);
    ASSERT_EQ(run("render sdf_morph --size 64x36 --samples 1 --preset '" + path("a.png") + "' --out '" + path("b.png") + "'").code, 0);
    EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(Cli, ExrCarriesTheChannelsAskedForAndTheReportSaysWhatRan)
{
    const Result result = run("render sdf_morph --alone --transparent --size 96x54 --samples 1 --channels color,depth,normal,evaluations --set morph=0 --out '" + path("a.exr") +
                              "' --report '" + path("a.json") + "'");
    ASSERT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(result.out, "");
    const vitrine::render::Image picture = vitrine::render::readImage(folder_ / "a.exr");
    const auto channel = [&](const std::string& name) {
        for (std::size_t c = 0; c < picture.channelNames.size(); ++c)
            if (picture.channelNames[c] == name) return static_cast<int>(c);
        ADD_FAILURE() << "no channel " << name;
        return 0;
    };
    const int alpha = channel("A");
    const int depth = channel("depth.Z");
    const int normal = channel("normal.X");
    const int evaluations = channel("evaluations");
    int covered = 0;
    double sum = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            sum += picture.at(x, y, evaluations);
            if (picture.at(x, y, alpha) < 0.5F) continue;
            ++covered;
            EXPECT_TRUE(picture.at(x, y, depth) > 0.3F && picture.at(x, y, depth) < 5.0F);
            const glm::vec3 n(picture.at(x, y, normal), picture.at(x, y, normal + 1), picture.at(x, y, normal + 2));
            EXPECT_NEAR(glm::length(n), 1, 1e-3);
        }
    }
    EXPECT_GT(covered, 300);
    EXPECT_LT(covered, 96 * 54 / 2);

    const Json report = vitrine::render::readJson(folder_ / "a.json").root();
    for (const char* key : {"exhibit", "size", "renderer", "clock", "ran", "skipped", "counters", "ms"}) EXPECT_TRUE(report.contains(key)) << key;
    EXPECT_EQ(report["exhibit"], "sdf_morph");
    for (const char* key : {"median", "low", "high", "runs"}) EXPECT_TRUE(report["ms"].contains(key)) << key;
    for (const char* key : {"method", "trusted"}) EXPECT_TRUE(report["clock"].contains(key)) << key;
    bool marched = false;
    for (const Json& step : report["ran"]) marched = marched || step["name"] == "sdf_morph/march";
    EXPECT_TRUE(marched);
    bool skippedHall = false;
    for (const Json& step : report["skipped"]) skippedHall = skippedHall || (step["name"] == "hall/walls" && !step["reason"].get<std::string>().empty());
    EXPECT_TRUE(skippedHall);
    EXPECT_NEAR(report["counters"]["evaluations"].get<double>(), sum, 1.0 + 1e-4 * sum);
}

TEST_F(Cli, PresetCheckTellsGoodFromBad)
{
    std::ofstream(path("good.json")) << R"({"format":"vitrine-preset","version":1,"app":"0.1.0","exhibit":"sdf_morph","name":"A","values":{"morph":7,"unheardOf":1}})";
    std::ofstream(path("bad.json")) << "{\"format\":\"vitrine-preset\",\n\"version\":1,\"exhibit\":\"sdf_morph\",\"name\":\"A\",\n\"values\":{\"morph\":\"much\"}}";
    const Result good = run("preset check '" + path("good.json") + "'");
    EXPECT_EQ(good.code, 0) << good.error;
    EXPECT_NE(good.out.find("morph 7 -> 1"), std::string::npos) << good.out;
    EXPECT_NE(good.out.find("unheardOf"), std::string::npos) << good.out;
    const Result bad = run("preset check '" + path("bad.json") + "'");
    EXPECT_EQ(bad.code, 5);
    EXPECT_NE(bad.error.find("line 3"), std::string::npos) << bad.error;
    EXPECT_NE(bad.error.find("morph"), std::string::npos) << bad.error;
}

TEST_F(Cli, DoctorSaysWhatThisMachineCanDo)
{
    const Result result = run("doctor --json");
    ASSERT_EQ(result.code, 0) << result.error;
    const Json report = vitrine::render::parseJson(result.out, "doctor").root();
    EXPECT_TRUE(report["opengl"]["usable"].get<bool>());
    EXPECT_GT(report["limits"]["textureSize"].get<int>(), 2047);
    EXPECT_FALSE(report["clock"]["why"].get<std::string>().empty());
    EXPECT_TRUE(report["libraries"].contains("Qt"));
    EXPECT_TRUE(report["libraries"].contains("OpenImageIO"));
}

TEST_F(Cli, WithoutDisplayTheWindowSaysSo)
{
    const Result result = run("");
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(lines(result.error), 1U) << result.error;
}

}  // namespace
