// `vitrine sprite`: sprite sheets read by another reader, and refused input.

#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/app/child_process.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <tuple>

namespace vitrine {
namespace {

using test::Ended;
using test::TemporaryFolder;

nlohmann::json readJson(const std::string& file)
{
    std::ifstream in(file);
    return nlohmann::json::parse(in);
}

/// Writes a triangle without normals, whose only morph target lifts its tip during a second.
std::string liftedIn(const TemporaryFolder& folder)
{
    test::GltfBuilder b;
    const int mesh = b.triangle();
    auto& json = b.json["meshes"][static_cast<std::size_t>(mesh)];
    json["primitives"][0]["targets"] =
        render::Json::array({{{"POSITION", b.floats({0, 0, 0, 0, 0, 0, 0, 2, 0}, "VEC3")}}});
    json["weights"] = {0.0};
    const int node = b.node({{"mesh", mesh}});
    b.json["animations"] = render::Json::array(
        {{{"name", "lift"},
          {"samplers",
           render::Json::array({{{"input", b.floats({0, 1}, "SCALAR")}, {"output", b.floats({0, 1}, "SCALAR")}}})},
          {"channels",
           render::Json::array(
               {{{"sampler", 0U}, {"target", {{"node", static_cast<unsigned>(node)}, {"path", "weights"}}}}})}}});
    const std::string file = folder / "lifted.glb";
    test::writeBytes(file, b.glb());
    return file;
}

int seen(const render::Image& sheet, const nlohmann::json& frame)
{
    int count = 0;
    for (int y = 0; y < frame["h"].get<int>(); ++y)
        for (int x = 0; x < frame["w"].get<int>(); ++x)
            count += sheet.at(frame["x"].get<int>() + x, frame["y"].get<int>() + y, 3) > 0.5F;
    return count;
}

TEST(SpriteCommand, WritesASheetItsMapsAndItsDescription)
{
    const TemporaryFolder folder;
    const std::string out = folder / "pillar.png";
    const Ended ended = test::vitrine(
        {"sprite", "--directions", "3", "--frames", "2", "--size", "31x40", "--colors", "6", "--out", out});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const render::Image sheet = render::readImage(out);
    ASSERT_EQ(sheet.width, 62);
    ASSERT_EQ(sheet.height, 120);
    std::set<std::tuple<int, int, int>> colors;
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x)
            if (sheet.at(x, y, 3) > 0.5F)
                colors.insert({render::srgb8FromLinear(sheet.at(x, y, 0)), render::srgb8FromLinear(sheet.at(x, y, 1)),
                               render::srgb8FromLinear(sheet.at(x, y, 2))});
    EXPECT_GE(colors.size(), 3U);
    EXPECT_LE(colors.size(), 6U);
    const auto json = readJson(folder / "pillar.json");
    EXPECT_EQ(json["meta"]["image"], "pillar.png");
    ASSERT_EQ(json["frames"].size(), 6U);
    for (const auto& frame : json["frames"]) EXPECT_GT(seen(sheet, frame["frame"]), 50);
    render::ReadOptions raw;
    raw.raw = true;
    const render::Image normal = render::readImage(folder / "pillar_normal.png", raw);
    const render::Image depth = render::readImage(folder / "pillar_depth.png", raw);
    ASSERT_EQ(normal.width, sheet.width);
    ASSERT_EQ(depth.height, sheet.height);
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x) {
            EXPECT_EQ(normal.at(x, y, 3), sheet.at(x, y, 3));
            EXPECT_EQ(depth.at(x, y) > 0, sheet.at(x, y, 3) > 0);
            if (sheet.at(x, y, 3) < 0.5F) continue;
            const glm::vec3 n(normal.at(x, y, 0) * 2 - 1, normal.at(x, y, 1) * 2 - 1, normal.at(x, y, 2) * 2 - 1);
            EXPECT_NEAR(glm::length(n), 1, 0.02);
            EXPECT_GT(n.z, -0.05F);
        }
}

TEST(SpriteCommand, PlaysTheAnimationOfAFileWithoutNormals)
{
    const TemporaryFolder folder;
    const std::string out = folder / "lifted.png";
    const Ended ended =
        test::vitrine({"sprite", liftedIn(folder), "--directions", "1", "--frames", "4", "--size", "48x48", "--set",
                       "azimuth=0", "--trim", "--no-normals", "--no-depth", "--palette", "Game Boy", "--out", out});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(test::withoutProgress(ended.err), "");
    const render::Image sheet = render::readImage(out);
    const auto json = readJson(folder / "lifted.json");
    ASSERT_EQ(json["frames"].size(), 4U);
    int last = 0;
    for (const auto& frame : json["frames"]) {
        EXPECT_GT(frame["frame"]["h"].get<int>(), last);
        last = frame["frame"]["h"].get<int>();
    }
    EXPECT_EQ(folder.files(),
              (std::vector<std::string>{"lifted.glb", "lifted.json", "lifted.png", "lifted.png.vitrine-job.json"}));
}

TEST(SpriteCommand, SaysWhatItCannotDo)
{
    const TemporaryFolder folder;
    const std::string file = liftedIn(folder);
    const auto refused = [&](std::vector<std::string> more, int code, const std::string& part) {
        std::vector<std::string> words{"sprite", file, "--out", folder / "a.png"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, code) << part;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    };
    refused({"--animation", "jump"}, 2, "lift");
    refused({"--palette", "Amiga"}, 2, "Game Boy");
    refused({"--dither", "noise"}, 2, "error diffusion");
    refused({"--pivot", "left"}, 2, "bottom");
    refused({"--motion", "walk"}, 2, "in place");
    refused({"--size", "9000x9000", "--directions", "8"}, 2, "16384");
    refused({"--set", "nothing=1"}, 2, "nothing");
    EXPECT_EQ(test::vitrine({"sprite", file, "--out", folder / "a.exr"}).code, 2);
    EXPECT_EQ(test::vitrine({"sprite", folder / "none.glb", "--out", folder / "a.png"}).code, 5);
    EXPECT_EQ(folder.files().size(), 1U);
    test::GltfBuilder nothing;
    nothing.node({{"mesh", nothing.triangle()}, {"scale", {0, 0, 0}}});
    test::writeBytes(folder / "nothing.glb", nothing.glb());
    const Ended ended = test::vitrine({"sprite", folder / "nothing.glb", "--out", folder / "a.png"});
    EXPECT_EQ(ended.code, 5);
    EXPECT_NE(ended.err.find("nothing.glb is to be seen: it is scaled to a point"), std::string::npos) << ended.err;
    EXPECT_EQ(folder.files().size(), 2U);
}

}  // namespace
}  // namespace vitrine
