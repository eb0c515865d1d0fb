// `vitrine shader check`: findings, JSON and exit codes.

#include "render/files/strict_json.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

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
    const render::Json report = render::Json::parse(json.out);
    ASSERT_EQ(report.size(), 2U);
    EXPECT_EQ(report[0]["errors"][0]["line"], 2);
    EXPECT_EQ(report[0]["errors"][0]["column"], 25);
    EXPECT_EQ(report[1]["good"], true);
    EXPECT_EQ(report[1]["form"], "ISF 2");
    EXPECT_EQ(report[1]["inputs"][0]["type"], "bool");
}

}  // namespace
}  // namespace vitrine
