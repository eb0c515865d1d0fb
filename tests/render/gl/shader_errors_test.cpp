// Shaders that do not build: the error message, and the programs that are kept.

#include "render/failure.h"
#include "render/gl/program.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

namespace vitrine {
namespace {

using render::ShaderKey;
using render::ShaderSource;
using render::gl::buildProgram;
using render::gl::BuiltProgram;

class ShaderErrors : public test::GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        write("good.vert", "void main()\n{\n    gl_Position = vec4(0.0);\n}\n");
        write("lib/half.glsl", "float half_(float x)\n{\n    return 0.5 * x;\n}\n");
    }
    void TearDown() override {}  // These tests cause errors of the driver.
    void write(const std::string& file, const std::string& text) { test::writeBytes(folder_ / file, text); }
    BuiltProgram build(const std::string& fragment, std::vector<std::string> defines = {})
    {
        return buildProgram(ShaderSource(folder_.path()), {"good.vert", fragment, "", std::move(defines)});
    }

    test::TemporaryFolder folder_;
};

constexpr const char* good = "#include \"lib/half.glsl\"\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    "
                             "color = vec4(half_(1.0));\n}\n";

TEST_F(ShaderErrors, AGoodProgramBuilds)
{
    write("good.frag", good);
    const BuiltProgram built = build("good.frag");
    EXPECT_TRUE(built.program) << built.problem.text;
    EXPECT_EQ(built.files, (std::vector<std::string>{"good.vert", "good.frag", "lib/half.glsl"}));
}

TEST_F(ShaderErrors, ATypoNamesFileLineAndWhatIsWrong)
{
    write("bad.frag", "layout(location = 0) out vec4 color;\nvoid main()\n{\n    color = vec4(undeclaredName);\n}\n");
    const BuiltProgram built = build("bad.frag");
    EXPECT_FALSE(built.program);
    EXPECT_EQ(built.problem.file, "bad.frag");
    EXPECT_EQ(built.problem.line, 4);
    EXPECT_NE(built.problem.text.find("undeclaredName"), std::string::npos) << built.problem.text;
}

TEST_F(ShaderErrors, ATypoAfterAnIncludeStillNamesItsOwnLine)
{
    write("bad.frag", "#include \"lib/half.glsl\"\n\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    color = "
                      "nonsense;\n}\n");
    const BuiltProgram built = build("bad.frag", {"ONE 1", "TWO"});
    EXPECT_EQ(built.problem.file, "bad.frag");
    EXPECT_EQ(built.problem.line, 6);
}

TEST_F(ShaderErrors, ATypoInAnIncludedFileNamesThatFile)
{
    write("lib/half.glsl", "float half_(float x)\n{\n    return 0.5 * y;\n}\n");
    write("good.frag", good);
    const BuiltProgram built = build("good.frag");
    EXPECT_EQ(built.problem.file, "lib/half.glsl");
    EXPECT_EQ(built.problem.line, 3);
}

TEST_F(ShaderErrors, AMissingIncludeIsNamedWithWhoWantsIt)
{
    write("bad.frag", "#include \"lib/gone.glsl\"\nvoid main()\n{\n}\n");
    const BuiltProgram built = build("bad.frag");
    EXPECT_FALSE(built.program);
    EXPECT_NE(built.problem.text.find("lib/gone.glsl"), std::string::npos) << built.problem.text;
    EXPECT_NE(built.problem.text.find("bad.frag"), std::string::npos) << built.problem.text;
}

TEST_F(ShaderErrors, IncludesInACircleAreReadOnce)
{
    write("a.glsl", "#include \"b.glsl\"\nfloat a() { return 1.0; }\n");
    write("b.glsl", "#include \"a.glsl\"\nfloat b() { return 2.0; }\n");
    write(
        "circle.frag",
        "#include \"a.glsl\"\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    color = vec4(a() + b());\n}\n");
    EXPECT_TRUE(build("circle.frag").program);
}

TEST_F(ShaderErrors, IncludesNestedTooDeepAreRefused)
{
    for (int i = 0; i < 30; ++i)
        write("deep" + std::to_string(i) + ".glsl", "#include \"deep" + std::to_string(i + 1) + ".glsl\"\n");
    write("deep30.glsl", "float deep() { return 1.0; }\n");
    write("deep.frag", "#include \"deep0.glsl\"\nvoid main()\n{\n}\n");
    const BuiltProgram built = build("deep.frag");
    EXPECT_FALSE(built.program);
    EXPECT_NE(built.problem.text.find("16"), std::string::npos) << built.problem.text;
}

TEST_F(ShaderErrors, StagesThatDoNotFitAreAProblemOfTheirLink)
{
    write("bad.frag", "in vec3 nobodyWritesThis;\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    color = "
                      "vec4(nobodyWritesThis, 1.0);\n}\n");
    const BuiltProgram built = build("bad.frag");
    EXPECT_FALSE(built.program);
    EXPECT_NE(built.problem.text.find("nobodyWritesThis"), std::string::npos) << built.problem.text;
}

TEST_F(ShaderErrors, DriversLogsOfThreeMakersAreUnderstood)
{
    const std::vector<std::string> files{"a.frag", "lib/b.glsl", "lib/c.glsl"};
    for (const char* log : {"2:17(5): error: `y' undeclared", "2(17) : error C1503: undefined variable \"y\"",
                            "ERROR: 2:17: 'y' : undeclared identifier"}) {
        const render::ShaderMessage message = render::firstError(log, files);
        EXPECT_EQ(message.file, "lib/c.glsl") << log;
        EXPECT_EQ(message.line, 17) << log;
        EXPECT_NE(message.text.find('y'), std::string::npos) << log;
    }
    EXPECT_EQ(render::firstError("something else went wrong", files).text, "something else went wrong");
    EXPECT_EQ(render::firstError("99:1(1): error: out of the list", files).file, "");
}

TEST_F(ShaderErrors, APlanWithABrokenShaderFailsWithFileAndLineAndKeepsThePicture)
{
    test::Shot shot;
    const render::Image before = shot.take().image;
    render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, shot.request.frame,
                                           test::gallery().renderer.persistentState());
    render::Pass broken;
    broken.name = "broken";
    broken.phase = render::PassPhase::present;
    broken.shader = {"lib/fullscreen.vert", "hall/sky.frag", "", {"skyRadiance 1 +"}};
    broken.colors = {{"frame", render::Load::keep, {}, -1, 0}};
    broken.draws = {render::Draw{}};
    plan.add(std::move(broken));
    try {
        (void)test::gallery().renderer.draw(plan);
        FAIL() << "nothing was thrown";
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::shader);
        EXPECT_NE(std::string(failure.what()).find("shaders/"), std::string::npos) << failure.what();
        EXPECT_NE(std::string(failure.what()).find("line "), std::string::npos) << failure.what();
    }
    EXPECT_EQ(test::largestDifference(shot.take().image, before), 0);
}

}  // namespace
}  // namespace vitrine
