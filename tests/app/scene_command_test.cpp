// `vitrine scene check` and `vitrine mesh`: findings, written files, and the files left after errors.

#include "render/files/strict_json.h"
#include "render/scene/gltf.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <thread>
#include <tuple>

namespace vitrine {
namespace {

using namespace test;
using Words = std::vector<std::string>;

const std::string scenes = VITRINE_SOURCE_DIR "/assets/scenes/";

std::string sceneText(const std::string& root, const std::string& head = "")
{
    return "{\"format\": \"vitrine-scene\", \"version\": 1, \"name\": \"test\",\n" + head + "\"root\": " + root + "}\n";
}

/// Writes a scene file with a ball whose radius is a parameter.
std::string ballIn(const TemporaryFolder& folder)
{
    const std::string file = folder / "ball.json";
    test::writeBytes(file, sceneText(R"({"kind": "sphere", "radius": "r", "material": "red"})",
                                     R"("parameters": {"r": {"value": 0.5, "unit": "m", "range": [0.1, 1]}},
                                        "materials": {"red": {"model": "phong", "color": [1, 0.25, 0]}},)"));
    return file;
}

TEST(SceneCheck, SaysOfEachFileWhatIsWrongAndWhere)
{
    const TemporaryFolder folder;
    const std::string good = ballIn(folder);
    const std::string bad = folder / "bad.json";
    test::writeBytes(bad, sceneText("{\"kind\": \"sphere\",\n \"raduis\": 1}"));
    const Ended one = test::vitrine({"scene", "check", good});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(one.out, good + ": good (\"test\", 1 nodes, 1 parameters)\n");
    const Ended both = test::vitrine({"scene", "check", good, bad});
    EXPECT_EQ(both.code, 1);
    EXPECT_NE(both.out.find(bad + ":3:2: root.raduis: "), std::string::npos) << both.out;
    EXPECT_NE(both.out.find("radius"), std::string::npos) << both.out;
    EXPECT_EQ(test::vitrine({"scene", "check", folder / "none.json"}).code, 5);
    EXPECT_EQ(test::vitrine({"scene", "check"}).code, 2);
}

TEST(SceneCheck, SaysTheSameAsJson)
{
    const TemporaryFolder folder;
    const std::string bad = folder / "bad.json";
    test::writeBytes(bad, sceneText("{\"kind\": \"sphere\",\n \"raduis\": 1}"));
    const Ended ended = test::vitrine({"scene", "check", "--json", bad, ballIn(folder)});
    EXPECT_EQ(ended.code, 1);
    const render::Json document = render::Json::parse(ended.out);
    EXPECT_EQ(document["format"], "vitrine-findings");
    EXPECT_EQ(document["version"], 1);
    EXPECT_EQ(document["command"], "scene check");
    EXPECT_EQ(document["good"], false);
    const render::Json& report = document["files"];
    ASSERT_EQ(report.size(), 2U);
    EXPECT_EQ(report[0]["good"], false);
    EXPECT_EQ(report[0]["findings"][0]["line"], 3);
    EXPECT_EQ(report[0]["findings"][0]["column"], 2);
    EXPECT_EQ(report[0]["findings"][0]["key"], "root.raduis");
    EXPECT_EQ(report[1]["good"], true);
    EXPECT_EQ(report[1]["findings"].size(), 0U);
}

TEST(SceneCheck, FindsNothingInTheScenesThatComeWithTheProgram)
{
    Words words{"scene", "check"};
    for (const auto& entry : std::filesystem::directory_iterator(scenes))
        if (entry.path().filename() != "scene.schema.json") words.push_back(entry.path());
    EXPECT_GE(words.size(), 17U);
    const Ended ended = test::vitrine(words);
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
}

// ---- Files, read by another reader ----------------------------------------------------------------

using Corner = std::array<float, 3>;
struct Soup {
    std::vector<std::array<Corner, 3>> triangles;
};

/// Returns the volume of a closed body, in which every edge, identified by positions, occurs once in each direction;
/// NaN for other bodies.
double volumeOf(const Soup& soup)
{
    std::map<std::pair<Corner, Corner>, int> edges;
    double six = 0;
    for (const auto& t : soup.triangles) {
        for (std::size_t k = 0; k < 3; ++k) edges[{t[k], t[(k + 1) % 3]}]++;
        const auto at = [&](std::size_t k) { return glm::dvec3(t[k][0], t[k][1], t[k][2]); };
        six += glm::dot(at(0), glm::cross(at(1), at(2)));
    }
    for (const auto& [edge, count] : edges)
        if (count != 1 || !edges.contains({edge.second, edge.first})) return std::nan("");
    return six / 6;
}

template <typename T> T valueAt(const std::string& bytes, std::size_t offset)
{
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

Soup readStl(const std::string& file)
{
    const std::string bytes = test::bytesOf(file);
    Soup soup;
    const auto count = valueAt<std::uint32_t>(bytes, 80);
    EXPECT_EQ(bytes.size(), 84U + 50U * count);
    for (std::size_t i = 0; i < count; ++i)
        soup.triangles.push_back(valueAt<std::array<Corner, 3>>(bytes, 84 + 50 * i + 12));
    return soup;
}

/// Reads a PLY file, with the color of the first vertex.
Soup readPly(const std::string& file, std::array<std::uint8_t, 3>& color)
{
    const std::string bytes = test::bytesOf(file);
    const std::size_t body = bytes.find("end_header\n") + 11;
    const auto counted = [&](const std::string& what) {
        return std::stoul(bytes.substr(bytes.find("element " + what) + 9 + what.size()));
    };
    const std::size_t vertices = counted("vertex"), faces = counted("face");
    EXPECT_EQ(bytes.size(), body + 27 * vertices + 13 * faces);
    color = valueAt<std::array<std::uint8_t, 3>>(bytes, body + 24);
    Soup soup;
    for (std::size_t i = 0; i < faces; ++i) {
        const std::size_t at = body + 27 * vertices + 13 * i;
        EXPECT_EQ(bytes[at], 3);
        std::array<Corner, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = valueAt<Corner>(bytes, body + 27 * valueAt<std::uint32_t>(bytes, at + 1 + 4 * k));
        soup.triangles.push_back(triangle);
    }
    return soup;
}

Soup readGlb(const std::string& file)
{
    const render::Model model = render::loadGltf(file);
    EXPECT_EQ(model.parts.size(), 1U);
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_EQ(glm::vec3(model.parts.front().material->baseColor), glm::vec3(1, 0.25, 0));
    Soup soup;
    const render::Mesh& mesh = *model.parts.front().mesh;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<Corner, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const render::Vertex& v = mesh.vertices[mesh.indices[i + k]];
            triangle[k] = {v.position.x, v.position.y, v.position.z};
            EXPECT_GT(glm::dot(v.normal, glm::normalize(v.position)), 0.99F);
        }
        soup.triangles.push_back(triangle);
    }
    return soup;
}

TEST(SceneMeshCommand, WritesClosedBodiesInThreeFormats)
{
    const TemporaryFolder folder;
    const std::string ball = ballIn(folder);
    const double truth = 4.0 / 3 * std::numbers::pi * 0.125;
    for (const char* end : {"glb", "stl", "ply"}) {
        const Ended ended =
            test::vitrine({"mesh", ball, "--cell", "20mm", "--out", folder / ("a." + std::string(end))});
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_NE(ended.out.find("volume 0.523 m"), std::string::npos) << ended.out;
        EXPECT_NE(ended.out.find("memory at most"), std::string::npos) << ended.out;
    }
    EXPECT_NEAR(volumeOf(readGlb(folder / "a.glb")), truth, 0.002 * truth);
    EXPECT_NEAR(volumeOf(readStl(folder / "a.stl")), truth * 1e9, 0.002 * truth * 1e9);
    std::array<std::uint8_t, 3> color{};
    EXPECT_NEAR(volumeOf(readPly(folder / "a.ply", color)), truth, 0.002 * truth);
    EXPECT_EQ(color, (std::array<std::uint8_t, 3>{255, 137, 0}));  // 0.25 is 137 in sRGB.
}

TEST(SceneMeshCommand, TakesParametersWithUnitsAndSaysWhatIsNone)
{
    const TemporaryFolder folder;
    const std::string ball = ballIn(folder);
    const auto meshing = [&](const Words& more) {
        Words words{"mesh", ball, "--cell", "0.02", "--out", folder / "a.stl"};
        words.insert(words.end(), more.begin(), more.end());
        return test::vitrine(words);
    };
    ASSERT_EQ(meshing({"--set", "r=25cm"}).code, 0);
    const double truth = 4.0 / 3 * std::numbers::pi * 0.015625e9;
    EXPECT_NEAR(volumeOf(readStl(folder / "a.stl")), truth, 0.01 * truth);
    EXPECT_EQ(meshing({"--set", "r=0.25"}).code, 0);
    EXPECT_EQ(meshing({"--set", "r=2"}).code, 2);
    test::expectOneSentence(meshing({"--set", "r=2"}), {"0.1 to 1 m"});
    test::expectOneSentence(meshing({"--set", "s=2"}), {"--set s", "it has r"});
    test::expectOneSentence(meshing({"--set", "ra=2"}), {"--set ra", "did you mean r?", "it has r"});
    test::expectOneSentence(test::vitrine({"mesh", ball, "--cell", "soup", "--out", folder / "b.stl"}),
                            {"--cell", "a number from"});
    EXPECT_EQ(meshing({"--low", "0,0,0"}).code, 2);
    ASSERT_EQ(meshing({"--low=-1,-1,-1", "--high=1,0,1"}).code, 0);
    EXPECT_NEAR(volumeOf(readStl(folder / "a.stl")), 2.0 / 3 * std::numbers::pi * 0.125e9, 0.002e9);
}

TEST(SceneMeshCommand, TakesTheTimeOfWhatMoves)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "moving.json", sceneText(R"({"kind": "box", "size": ["1 + sin(t) * 0.5", 1, 1]
})"));
    for (const auto& [time, volume] : {std::pair("0", 1.0), std::pair("1.5707963", 1.5)}) {
        const Ended ended =
            test::vitrine({"mesh", folder / "moving.json", "--cell", "5cm", "--time", time, "--out", folder / "a.stl"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_NEAR(volumeOf(readStl(folder / "a.stl")), volume * 1e9, 1e7);
    }
}

TEST(SceneMeshCommand, WhatCannotBeMeshedIsSaidAndLeavesTheOldFile)
{
    const TemporaryFolder folder;
    const std::string out = folder / "a.glb";
    test::writeBytes(out, "old");
    const auto refused = [&](const Words& words, int code, const Words& parts) {
        Words all{"mesh"};
        all.insert(all.end(), words.begin(), words.end());
        const Ended ended = test::vitrine(all);
        EXPECT_EQ(ended.code, code) << ended.err;
        EXPECT_EQ(ended.out, "");
        for (const std::string& part : parts) EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        EXPECT_EQ(test::bytesOf(out), "old");
    };
    const std::string ball = ballIn(folder);
    refused({ball, "--out", folder / "a.dae"}, 2, {".glb, .stl, .ply, .obj or .3mf"});
    // A torus has no closed mesh of four triangles.
    test::writeBytes(folder / "torus.json", sceneText(R"({"kind": "torus", "majorRadius": 0.4, "minorRadius": 0.1})"));
    refused({folder / "torus.json", "--cell", "5cm", "--triangles", "4", "--out", out}, 1,
            {"not closed", "--triangles"});
    refused({scenes + "unions.json", "--out", out}, 2, {"no end", "--low"});
    refused({ball, "--cell", "0.1mm", "--memory-mb", "100", "--out", out}, 2, {"GB", "give --cell"});
    refused({ball, "--out", folder / "no/a.glb"}, 5, {"a.glb"});
    refused({folder / "none.json", "--out", out}, 5, {"none.json"});
    test::writeBytes(folder / "bad.json", sceneText(R"({"kind": "sphere", "raduis": 1})"));
    refused({folder / "bad.json", "--out", out}, 1, {"bad.json:2:", "raduis"});
    test::writeBytes(folder / "sheet.json", sceneText(R"({"kind": "triangle", "thickness": 0})"));
    refused({folder / "sheet.json", "--out", out}, 1, {"thickness"});
}

/// Starts the program with its standard error in a file, and its output in one that ends in ".out". `before` is called
/// in the child process first.
template <typename Before> pid_t started(const Words& words, const std::string& err, const Before& before)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    before();
    ::dup2(::open((err + ".out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), 2);
    std::vector<char*> pointers{const_cast<char*>(VITRINE_PROGRAM)};
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    ::execv(VITRINE_PROGRAM, pointers.data());
    ::_exit(127);
}

TEST(SceneMeshCommand, AFullDiskLeavesTheOldFile)
{
    const TemporaryFolder folder, other;
    const std::string ball = ballIn(other);
    test::writeBytes(folder / "a.glb", "old");
    const pid_t child = started({"mesh", ball, "--cell", "2cm", "--out", folder / "a.glb"}, other / "err", [] {
        const rlimit limit{100'000, 100'000};  // A file with these cells is larger.
        ::setrlimit(RLIMIT_FSIZE, &limit);
    });
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 5);
    EXPECT_NE(test::bytesOf(other / "err").find("a.glb"), std::string::npos);
    EXPECT_EQ(test::bytesOf(folder / "a.glb"), "old");
    EXPECT_EQ(folder.files().size(), 1U);
}

TEST(SceneMeshCommand, StoppedByCtrlCLeavesTheOldFile)
{
    const TemporaryFolder folder, other;
    test::writeBytes(folder / "a.glb", "old");
    const pid_t child = started({"mesh", scenes + "waves.json", "--cell", "5mm", "--low=-6,-6,-6", "--high=6,6,6",
                                 "--memory-mb", "1e6", "--out", folder / "a.glb"},
                                other / "err", [] {});
    // Its first progress line comes after a second, when minutes of work are left.
    for (int i = 0; i < 6000 && (!std::filesystem::exists(other / "err") || test::bytesOf(other / "err").empty()); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << test::bytesOf(other / "err");
    EXPECT_EQ(WEXITSTATUS(status), 130) << test::bytesOf(other / "err");
    EXPECT_EQ(test::bytesOf(folder / "a.glb"), "old");
    EXPECT_EQ(folder.files().size(), 1U);
}

TEST(LongSceneMeshCommand, TakesNoMoreMemoryThanItSaid)
{
    const TemporaryFolder folder;
    const auto peak = [&](const std::string& cell, double& said) {
        rusage usage{};
        int status = 0;
        const pid_t child =
            started({"mesh", ballIn(folder), "--cell", cell, "--out", folder / "a.ply"}, folder / "err", [] {});
        ::wait4(child, &status, 0, &usage);
        EXPECT_EQ(WEXITSTATUS(status), 0) << test::bytesOf(folder / "err");
        const std::string out = test::bytesOf(folder / "err.out");
        said = std::stod(out.substr(out.find("at most ") + 8));
        std::filesystem::remove(folder / "err");
        return 1024e-6 * static_cast<double>(usage.ru_maxrss);
    };
    double saidOfSmall = 0, said = 0;
    const double small = peak("5cm", saidOfSmall);  // Memory of the program itself.
    const double large = peak("3mm", said);
    EXPECT_GT(said, 80);
    EXPECT_LT(large - small, said);
    EXPECT_GT(large - small, 0.2 * said);
}

}  // namespace
}  // namespace vitrine
