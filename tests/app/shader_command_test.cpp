// `vitrine shader check` and `vitrine shader export`: findings, files, JSON and exit codes.

#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace vitrine {
namespace {

using test::Ended;

TEST(ShaderCheck, NamesFileLineAndColumn)
{
    const test::TemporaryFolder folder;
    const std::string good = folder / "good.fs", bad = folder / "bad.frag";
    test::writeBytes(good, "/*{\"ISFVSN\": \"2\", \"INPUTS\": [{\"NAME\": \"on\", \"TYPE\": \"bool\"}]}*/\n"
                           "void main() { gl_FragColor = vec4(on); }\n");
    test::writeBytes(bad, "void main() {\n    gl_FragColor = vec4(of);\n}\n");
    const Ended one = test::vitrine({"shader", "check", good});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(one.out, good + ": good (ISF 2, 1 inputs, 1 passes)\n");
    const Ended both = test::vitrine({"shader", "check", good, bad});
    EXPECT_EQ(both.code, 1);
    EXPECT_NE(both.out.find(bad + ":2:25: The GLSL compiler says: 'of' : undeclared identifier.\n"), std::string::npos)
        << both.out;
    EXPECT_EQ(test::vitrine({"shader", "check", folder / "none.fs"}).code, 5);
    EXPECT_EQ(test::vitrine({"shader", "check"}).code, 2);

    const Ended json = test::vitrine({"shader", "check", "--json", bad, good});
    EXPECT_EQ(json.code, 1);
    const render::Json report = render::Json::parse(json.out)["files"];
    ASSERT_EQ(report.size(), 2U);
    EXPECT_EQ(report[0]["findings"][0]["line"], 2);
    EXPECT_EQ(report[0]["findings"][0]["column"], 25);
    EXPECT_EQ(report[1]["good"], true);
    EXPECT_EQ(report[1]["form"], "ISF 2");
    EXPECT_EQ(report[1]["inputs"][0]["type"], "bool");
}

TEST(ShaderExport, WritesTheFormOfTheEnding)
{
    const test::TemporaryFolder folder;
    const std::string own = folder / "own.frag";
    test::writeBytes(own,
                     "uniform float u_gain; // 0 .. 1, default 0.5\nvoid main() { gl_FragColor = vec4(u_gain); }\n");
    const auto exported = [&](const std::string& from, const std::string& name) {
        const Ended ended = test::vitrine({"shader", "export", from, "--set", "uGain=0.25", "--out", folder / name});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return render::readFile(folder / name, 1U << 22U);
    };
    EXPECT_EQ(exported(own, "own.fs").rfind("/*{", 0), 0U);
    EXPECT_NE(exported(own, "own.glsl").find("#iUniform float u_gain = 0.25 in {0.0, 1.0}"), std::string::npos);
    EXPECT_EQ(render::Json::parse(exported(own, "own.json"))["Shader"]["renderpass"][1]["type"], "image");
    EXPECT_EQ(exported(own, "own.html").rfind("<!DOCTYPE html>", 0), 0U);
    const Ended scene = test::vitrine(
        {"shader", "export", "sdf_scenes", "--set", "scene=torus.json", "--json", "--out", folder / "torus.fs"});
    EXPECT_EQ(scene.code, 0) << scene.err;
    EXPECT_EQ(test::vitrine({"shader", "check", folder / "torus.fs"}).code, 0);
    // The other forms are not written, and an exhibit of several passes is none.
    EXPECT_EQ(test::vitrine({"shader", "export", own, "--out", folder / "own.txt"}).code, 2);
    const Ended refused = test::vitrine({"shader", "export", "fur", "--out", folder / "fur.fs"});
    EXPECT_EQ(refused.code, 1);
    EXPECT_EQ(refused.err.rfind("vitrine: Fur with Physics cannot stand alone: ", 0), 0U) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "fur.fs"));
}

}  // namespace
}  // namespace vitrine
