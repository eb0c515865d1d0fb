// Readers of visitors' shaders: forms, inputs, passes, and the place of every error.

#include "exhibits/your_shader/guest_keys.h"
#include "exhibits/your_shader/size_expression.h"
#include "exhibits/your_shader/your_shader_table.h"
#include "render/glsl/lexer.h"
#include "tests/exhibits/your_shader/shaders.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using guest::Form;
using guest::InputType;
using test::checked;
using test::errorsOf;
using test::isf;

TEST(ShaderForms, AreRecognizedByTheirContent)
{
    const auto formOf = [](const std::string& text) {
        const guest::CheckedShader shader = checked(text);
        EXPECT_EQ(errorsOf(shader), "");
        return shader.shader ? std::optional(shader.shader->form) : std::nullopt;
    };
    EXPECT_EQ(formOf(isf("\"ISFVSN\": \"2\"")), Form::isf);
    EXPECT_EQ(formOf("void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, 0.0, 1.0); }"),
              Form::shadertoy);
    EXPECT_EQ(
        formOf(
            R"({"renderpass": [{"type": "image", "code": "void mainImage(out vec4 c, in vec2 p) { c = iDate; }"}]})"),
        Form::shadertoy);
    EXPECT_EQ(formOf("/* no JSON */ void main() { gl_FragColor = vec4(1.0); }"), Form::plain);
}

TEST(IsfReader, ReadsEveryKindOfInput)
{
    const guest::CheckedShader read =
        checked(isf(R"("ISFVSN": "2", "DESCRIPTION": "All kinds", "CREDIT": "us",
"CATEGORIES": ["Test", "Kinds"], "INPUTS": [
 {"NAME": "size", "TYPE": "float", "LABEL": "Size", "MIN": 0.5, "MAX": 4, "DEFAULT": 2, "EXACT": 4},
 {"NAME": "on", "TYPE": "bool", "DEFAULT": true},
 {"NAME": "mode", "TYPE": "long", "VALUES": [3, 7], "LABELS": ["Three", "Seven"], "DEFAULT": 7},
 {"NAME": "steps", "TYPE": "long", "MIN": 1, "MAX": 9, "DEFAULT": 4},
 {"NAME": "tint", "TYPE": "color", "DEFAULT": [1, 0.5, 0, 1]},
 {"NAME": "center", "TYPE": "point2D", "MIN": [-1, -1], "MAX": [1, 1], "DEFAULT": [0.25, 0]},
 {"NAME": "bang", "TYPE": "event"},
 {"NAME": "inputImage", "TYPE": "image"},
 {"NAME": "sound", "TYPE": "audio"},
 {"NAME": "tones", "TYPE": "audioFFT", "MAX": 64}])",
                    "gl_FragColor = tint * size * IMG_THIS_PIXEL(inputImage) + IMG_NORM_PIXEL(sound, center)"
                    " + IMG_PIXEL(tones, vec2(float(mode), 0.5)) + (bang || on ? float(steps) : TIME);"));
    ASSERT_EQ(errorsOf(read), "");
    const guest::Shader& shader = *read.shader;
    EXPECT_EQ(shader.version, "2");
    EXPECT_EQ(shader.credit, "us");
    EXPECT_EQ(shader.categories, (std::vector<std::string>{"Test", "Kinds"}));
    std::vector<InputType> types;
    for (const guest::Input& input : shader.inputs) types.push_back(input.type);
    EXPECT_EQ(types, (std::vector{InputType::real, InputType::toggle, InputType::choice, InputType::integer,
                                  InputType::color, InputType::point, InputType::event, InputType::image,
                                  InputType::audio, InputType::spectrum}));
    EXPECT_EQ(shader.inputs[0].label, "Size");
    EXPECT_EQ(shader.inputs[0].low, std::vector{0.5});
    EXPECT_EQ(shader.inputs[0].high, std::vector{4.0});
    EXPECT_EQ(shader.inputs[0].initial, std::vector{2.0});
    EXPECT_EQ(shader.inputs[0].exact, 4.0);
    EXPECT_EQ(shader.inputs[1].label, "on");
    ASSERT_EQ(shader.inputs[2].choices.size(), 2U);
    EXPECT_EQ(shader.inputs[2].choices[1].value, 7);
    EXPECT_EQ(shader.inputs[2].choices[1].label, "Seven");
    EXPECT_EQ(shader.inputs[4].initial, (std::vector{1.0, 0.5, 0.0, 1.0}));
    EXPECT_EQ(shader.inputs[5].low, (std::vector{-1.0, -1.0}));
}

TEST(IsfReader, TakesTheExactValueOfAChoice)
{
    const guest::CheckedShader read = checked(isf(
        R"("INPUTS": [{"NAME": "mode", "TYPE": "long", "VALUES": [8, 32, 16], "DEFAULT": 8, "EXACT": 32},
 {"NAME": "steps", "TYPE": "long", "MIN": 1, "MAX": 9, "DEFAULT": 4, "EXACT": 9}])",
        "gl_FragColor = vec4(float(mode), float(steps), 0, 1);"));
    ASSERT_EQ(errorsOf(read), "");
    const guest::YourShaderTable table(*read.shader);
    EXPECT_EQ(table.rows()[table.ofInputs[0][0]].qualityReference, 1.0) << "the second choice";
    EXPECT_EQ(table.rows()[table.ofInputs[1][0]].qualityReference, 9.0);
    EXPECT_EQ(errorsOf(checked(isf(R"("INPUTS": [{"NAME": "m", "TYPE": "long", "VALUES": [1, 2], "EXACT": 3}])"))),
              "own.fs:1:25: EXACT of the input “m” is not one of its VALUES; write one of them.\n");
}

TEST(ShaderTable, GivesInputsPlainNames)
{
    std::string inputs = "\"INPUTS\": [";
    const std::vector<std::pair<const char*, const char*>> names{
        {"STEPS", "steps"},       {"MAX_STEPS", "maxSteps"}, {"line_width", "lineWidth"},
        {"HTMLName", "htmlName"}, {"uColor", "uColor"},      {"A", "a"},
        {"pos_X", "posX"},        {"Size", "size"},          {"u_Kd", "uKd"},
        {"_fade", "fade"},        {"FILE", "ownFile"},       {"N2", "n2"}};
    for (const auto& [written, row] : names)
        inputs += std::string(inputs.back() == '[' ? "" : ",") + "{\"NAME\": \"" + written + "\", \"TYPE\": \"bool\"}";
    const guest::CheckedShader read = checked(isf(inputs + ']'));
    ASSERT_EQ(errorsOf(read), "");
    const guest::YourShaderTable table(*read.shader);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const ParameterInfo& row = table.rows()[table.ofInputs[i][0]];
        EXPECT_EQ(row.name, names[i].second);
        EXPECT_EQ(row.label, names[i].first);
    }
}

TEST(ShaderTable, ShowsSixParametersAtFirstTheFileAndInputsBeforeTheOthers)
{
    const auto essentialsBeside = [](int inputs) {
        std::string text = "\"INPUTS\": [";
        for (int i = 0; i < inputs; ++i)
            text += std::string(i == 0 ? "" : ",") + "{\"NAME\": \"in" + std::to_string(i) + "\", \"TYPE\": \"float\"}";
        const guest::CheckedShader read = checked(isf(text + ']'));
        EXPECT_EQ(errorsOf(read), "");
        std::vector<std::string> names;
        const guest::YourShaderTable table(*read.shader);
        for (const ParameterInfo& row : table.rows())
            if (row.essential) names.emplace_back(row.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(essentialsBeside(0), (Names{"file", "animate", "moment", "mouseX", "mouseY", "loopRounds"}));
    EXPECT_EQ(essentialsBeside(3), (Names{"file", "animate", "moment", "in0", "in1", "in2"}));
    EXPECT_EQ(essentialsBeside(5), (Names{"file", "in0", "in1", "in2", "in3", "in4"}));
    EXPECT_EQ(essentialsBeside(9), (Names{"file", "in0", "in1", "in2", "in3", "in4"}));
}

TEST(IsfReader, ReadsPassesBuffersAndImports)
{
    const guest::CheckedShader read = checked(
        isf(R"json("ISFVSN": "2", "INPUTS": [{"NAME": "parts", "TYPE": "float", "MIN": 1, "MAX": 8, "DEFAULT": 4}],
 "IMPORTED": {"mask": {"PATH": "mask.png"}},
 "PASSES": [{"TARGET": "trail", "PERSISTENT": true, "FLOAT": true, "WIDTH": "floor($WIDTH / $parts)", "HEIGHT": "1"}, {}])json",
            "gl_FragColor = PASSINDEX == 0 ? IMG_THIS_PIXEL(trail) : IMG_THIS_NORM_PIXEL(mask);"));
    ASSERT_EQ(errorsOf(read), "");
    ASSERT_EQ(read.shader->passes.size(), 2U);
    const guest::Pass& first = read.shader->passes[0];
    EXPECT_EQ(first.target, "trail");
    EXPECT_TRUE(first.isPersistent && first.isFloat);
    EXPECT_EQ(first.width, "floor($WIDTH / $parts)");
    EXPECT_EQ(read.shader->passes[1].target, "");
    ASSERT_EQ(read.shader->imports.size(), 1U);
    EXPECT_EQ(read.shader->imports[0].path, "mask.png");
    EXPECT_EQ(read.programs.size(), 2U);
}

TEST(IsfReader, ReadsVersion1WithItsPersistentBuffers)
{
    const guest::CheckedShader read =
        checked(isf(R"("PERSISTENT_BUFFERS": {"last": {"WIDTH": "$WIDTH/2", "FLOAT": true}},
 "PASSES": [{"TARGET": "last"}, {}])",
                    "gl_FragColor = texture2D(last, vv_FragNormCoord);"));
    ASSERT_EQ(errorsOf(read), "");
    EXPECT_EQ(read.shader->version, "1");
    EXPECT_TRUE(read.shader->passes[0].isPersistent && read.shader->passes[0].isFloat);
    EXPECT_EQ(read.shader->passes[0].width, "$WIDTH/2");
}

TEST(IsfReader, TakesTheVertexShaderBesideTheFile)
{
    const std::string text =
        "/*{\"ISFVSN\": \"2\"}*/\nvarying vec2 left;\nvoid main() { gl_FragColor = vec4(left, 0.0, 1.0); }\n";
    const std::string vertex = "varying vec2 left;\nvoid main() {\n    isf_vertShaderInit();\n    left = "
                               "isf_FragNormCoord - 1.0 / RENDERSIZE;\n}\n";
    EXPECT_EQ(errorsOf(checked(text, {{"own.vs", vertex}})), "");
    EXPECT_EQ(
        errorsOf(checked(text, {{"own.vs", "varying vec2 left;\nvoid main() {\n    left = vec2(nothing);\n}\n"}})),
        "own.vs:3:17: The GLSL compiler says: 'nothing' : undeclared identifier.\n");
}

TEST(IsfReader, PlacesErrorsOfTheHead)
{
    EXPECT_EQ(errorsOf(checked("/*{\n \"INPUTS\": [\n  {\"NAME\": \"a\" \"TYPE\": \"float\"}]}*/\nvoid main() {}"))
                  .substr(0, 11),
              "own.fs:3:21");
    EXPECT_EQ(
        errorsOf(checked(isf("\"INPUTS\": [\n {\"NAME\": \"a\", \"TYPE\": \"flot\"}]"))),
        "own.fs:2:12: The input “a” has the unknown TYPE “flot”; use float, bool, long, color, point2D, event, image, "
        "audio or audioFFT.\n");
    EXPECT_EQ(errorsOf(checked(isf("\"INPUTS\": [\n {\"NAME\": \"a b\", \"TYPE\": \"bool\"}]"))),
              "own.fs:2:12: “a b” is no name of a variable; use letters, digits and _.\n");
    EXPECT_EQ(errorsOf(checked(isf("\"PASSES\": [\n {\"WIDTH\": \"$WIDTH / parts\"}]"))),
              "own.fs:2:13: WIDTH of a pass: “$WIDTH / parts” is not a size; write an expression of numbers, $WIDTH, "
              "$HEIGHT and "
              "inputs, such as floor($WIDTH/2).\n");
    EXPECT_EQ(errorsOf(checked(isf("\"IMPORTED\": {\"m\":\n {\"PATH\": \"/etc/passwd\"}}"))).substr(0, 44),
              "own.fs:2:12: The import “/etc/passwd” ca");
}

TEST(IsfReader, RemarksOnKeysThatStandTwice)
{
    const guest::CheckedShader read = checked(isf("\"CREDIT\": \"a\",\n\"CREDIT\": \"b\""));
    ASSERT_EQ(errorsOf(read), "");
    EXPECT_EQ(read.shader->credit, "b");
    ASSERT_EQ(read.shader->notes.size(), 1U);
    EXPECT_EQ(read.shader->notes[0].line, 2);
}

TEST(IsfReader, BoundsCounts)
{
    std::string many = "\"PASSES\": [{}";
    for (int i = 0; i < 32; ++i) many += ", {}";
    EXPECT_EQ(errorsOf(checked(isf(many + ']'))), "own.fs:1:5: The shader has more than 32 passes; remove some.\n");
    std::string inputs = "\"INPUTS\": [{\"NAME\": \"x\", \"TYPE\": \"bool\"}";
    for (int i = 0; i < 64; ++i) inputs += ", {\"NAME\": \"x" + std::to_string(i) + "\", \"TYPE\": \"bool\"}";
    EXPECT_NE(errorsOf(checked(isf(inputs + ']'))).find("The shader has more than 64 inputs of one kind"),
              std::string::npos);
}

TEST(ShadertoyReader, MakesSlidersOfDirectives)
{
    const guest::CheckedShader read =
        checked("#iUniform float strength = 0.25 in { 0.0, 2.0 } step 0.1\n"
                "#iUniform color3 tint = color3(1.0, .5, 0.)\n"
                "#iUniform int count = 3 in { 1, 9 }\n"
                "#iUniform bool on = true\n"
                "#iChannel0 \"file://sand.png\"\n"
                "#iChannel0::MinFilter \"Nearest\"\n"
                "#iChannel1 \"self\"\n"
                "void mainImage(out vec4 fragColor, in vec2 fragCoord)\n"
                "{\n"
                "    fragColor = vec4(tint * strength, on ? float(count) : 0.0) + texture(iChannel0, fragCoord)\n"
                "        + texelFetch(iChannel1, ivec2(fragCoord), 0) + iMouse + iChannelResolution[1].x;\n"
                "}\n");
    ASSERT_EQ(errorsOf(read), "");
    const guest::Shader& shader = *read.shader;
    ASSERT_EQ(shader.inputs.size(), 4U);
    EXPECT_EQ(shader.inputs[3].type, InputType::toggle);
    EXPECT_EQ(shader.inputs[3].initial, std::vector{1.0});
    EXPECT_EQ(shader.inputs[0].initial, std::vector{0.25});
    EXPECT_EQ(shader.inputs[0].high, std::vector{2.0});
    EXPECT_EQ(shader.inputs[1].type, InputType::color);
    EXPECT_EQ(shader.inputs[1].initial, (std::vector{1.0, 0.5, 0.0}));
    ASSERT_EQ(shader.passes[0].channels.size(), 2U);
    EXPECT_EQ(shader.passes[0].channels[0].source, "sand.png");
    EXPECT_EQ(shader.passes[0].channels[0].filter, "Nearest");
    EXPECT_EQ(shader.passes[0].channels[1].kind, "buffer");
    EXPECT_EQ(errorsOf(checked("\n  #iUniform flot a = 1\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }")),
              "own.fs:2:13: “flot” is wrong here; write #iUniform float name = 0.5 in {0.0, 1.0}.\n");
}

TEST(ShadertoyReader, ReadsTheExportWithCommonBuffersCubesAndVolumes)
{
    const guest::CheckedShader read = checked(R"({"info": {"name": "Ours", "username": "us"}, "renderpass": [
 {"type": "image", "name": "Image", "code": "void mainImage(out vec4 c, in vec2 p)\n{\n c = shade(texture(iChannel0, p / iResolution.xy)) + texture(iChannel1, vec3(p, 1.0)) + texture(iChannel2, vec3(p, 0.5)); }",
  "inputs": [{"id": "b", "channel": 0, "ctype": "buffer", "src": "", "sampler": {"filter": "linear", "wrap": "repeat", "vflip": "true"}},
             {"id": "c", "channel": 1, "ctype": "cubemap"}, {"id": "v", "channel": 2, "ctype": "volume", "src": "v.bin"}]},
 {"type": "common", "name": "Common", "code": "vec4 shade(vec4 c) { return c * 0.5; }"},
 {"type": "buffer", "name": "Buffer A", "code": "void mainImage(out vec4 c, in vec2 p) { c = shade(texelFetch(iChannel0, ivec2(p), 0)) + float(iFrame); }",
  "inputs": [{"id": "b", "channel": 0, "ctype": "buffer"}], "outputs": [{"id": "b", "channel": 0}]},
 {"type": "cubemap", "name": "Cube A", "code": "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 1.0); }", "outputs": [{"id": "c"}]},
 {"type": "sound", "name": "Sound", "code": "vec2 mainSound(int s, float t) { return vec2(0.0); }"}]})");
    ASSERT_EQ(errorsOf(read), "");
    const guest::Shader& shader = *read.shader;
    EXPECT_EQ(shader.title, "Ours");
    ASSERT_EQ(shader.passes.size(), 3U);
    EXPECT_EQ(shader.passes[0].target, "Buffer A");
    EXPECT_TRUE(shader.passes[0].isPersistent && shader.passes[0].isFloat);
    EXPECT_EQ(shader.passes[1].target, "Cube A");
    EXPECT_EQ(shader.passes[2].channels[0].source, "Buffer A");
    EXPECT_TRUE(shader.passes[2].channels[0].flipped);
    EXPECT_EQ(shader.passes[2].channels[2].glslType, "sampler3D");
    ASSERT_EQ(shader.notes.size(), 1U);
    EXPECT_EQ(shader.notes[0].sentence.english(), "The sound pass is left out; pictures have no sound.");
}

TEST(ShadertoyReader, NamesThePassOfAnError)
{
    EXPECT_EQ(errorsOf(checked(R"({"renderpass": [{"type": "common", "code": "float two() { return 2.0; }"},
 {"type": "image", "name": "Image", "code": "void mainImage(out vec4 c, in vec2 p)\n{\n  c = vec4(gray());\n}"}]})")),
              "own.fs (Image):3:12: The GLSL compiler says: 'gray' : no matching overloaded function found.\n");
    EXPECT_EQ(errorsOf(checked("{\"a\": 1}")),
              "own.fs:1:1: This JSON has no list “renderpass”; export the shader from Shadertoy again.\n");
    EXPECT_EQ(errorsOf(checked("{\"a\":\n tru}")).substr(0, 10), "own.fs:2:5");
}

TEST(PlainReader, ReadsTheDialects)
{
    const guest::CheckedShader book =
        checked("#ifdef GL_ES\nprecision mediump float;\n#endif\nuniform float u_time;\nuniform vec2 u_resolution;\n"
                "uniform vec2 u_mouse;\nvarying vec2 v_texcoord;\nvoid main() {\n"
                "    gl_FragColor = vec4(gl_FragCoord.xy / u_resolution, sin(u_time) + u_mouse.x, v_texcoord.x);\n}\n");
    ASSERT_EQ(errorsOf(book), "");
    EXPECT_EQ(book.shader->inputs.size(), 0U);
    EXPECT_EQ(book.shader->builtIns.size(), 3U);
    const guest::CheckedShader sandbox = checked(
        "uniform float time; uniform vec2 mouse, resolution; uniform sampler2D backbuffer;\n"
        "void main() { gl_FragColor = texture2D(backbuffer, gl_FragCoord.xy / resolution) * mouse.x + time; }\n");
    ASSERT_EQ(errorsOf(sandbox), "");
    EXPECT_TRUE(sandbox.shader->passes[0].isPersistent);
    const guest::CheckedShader modern =
        checked("#version 330\n"
                "in vec2 uv; out vec4 color;\nuniform sampler2D u_tex0;\nuniform vec2 u_tex0Resolution;\n"
                "void main() { color = texture(u_tex0, uv + 1.0 / u_tex0Resolution); }\n");
    EXPECT_EQ(errorsOf(modern), "");
    const guest::CheckedShader viewer =
        checked("uniform sampler2D u_buffer0; uniform sampler2D u_doubleBuffer0; uniform vec2 u_resolution;\n"
                "void main() {\n#if defined(BUFFER_0)\n gl_FragColor = vec4(1.0);\n#elif defined(DOUBLE_BUFFER_0)\n"
                " gl_FragColor = texture2D(u_doubleBuffer0, gl_FragCoord.xy / u_resolution);\n#else\n"
                " gl_FragColor = texture2D(u_buffer0, gl_FragCoord.xy / u_resolution);\n#endif\n}\n");
    ASSERT_EQ(errorsOf(viewer), "");
    ASSERT_EQ(viewer.shader->passes.size(), 3U);
    EXPECT_EQ(viewer.shader->passes[0].target, "u_buffer0");
    EXPECT_TRUE(viewer.shader->passes[1].isPersistent);
}

TEST(PlainReader, MakesSlidersOfComments)
{
    const guest::CheckedShader read =
        checked("uniform float u_size; // 0.1 .. 2, default 0.5, exact 1, m, \"Size, outer\"\n"
                "uniform vec3 u_tint; // color\n"
                "uniform vec2 u_shift; // -1 .. 1, default 0.5 -0.5\n"
                "#define STEPS 64 // 8 .. 512, default 64, exact 512\n"
                "const float GAIN = 2.0; // 0 .. 4, default 3\n"
                "const float PLAIN = 3.0; // no range\n"
                "uniform vec4 u_glow; // color, default 1 0.5 0, \"Glow\"\n"
                "#define BIAS -1.5 // -2 .. 2, \"Bias\"\n"
                "void main() {\n"
                "    float sum = 0.0;\n"
                "    for (int i = 0; i < STEPS; ++i) sum += GAIN * PLAIN + BIAS;\n"
                "    gl_FragColor = u_glow + vec4(u_tint * u_size * sum, u_shift.x);\n}\n");
    ASSERT_EQ(errorsOf(read), "");
    const auto& inputs = read.shader->inputs;
    ASSERT_EQ(inputs.size(), 7U);
    EXPECT_EQ(inputs[0].label, "Size, outer");
    EXPECT_EQ(inputs[0].unit, "m");
    EXPECT_EQ(inputs[0].exact, 1.0);
    EXPECT_EQ(inputs[0].low, std::vector{0.1});
    EXPECT_EQ(inputs[1].type, InputType::color);
    EXPECT_EQ(inputs[2].initial, (std::vector{0.5, -0.5}));
    EXPECT_EQ(inputs[3].name, "STEPS");
    EXPECT_EQ(inputs[3].type, InputType::integer);
    EXPECT_EQ(inputs[4].name, "GAIN");
    EXPECT_EQ(inputs[4].initial, std::vector{3.0});
    EXPECT_EQ(inputs[5].type, InputType::color);
    EXPECT_EQ(inputs[5].initial, (std::vector{1.0, 0.5, 0.0, 1.0}));
    EXPECT_EQ(inputs[5].label, "Glow");
    EXPECT_EQ(inputs[6].initial, std::vector{-1.5}) << "the number that stands there";
    EXPECT_EQ(errorsOf(checked("uniform vec3 a; // color, pink\nvoid main() {}")), "");
    EXPECT_EQ(errorsOf(checked("uniform vec3 a; // color, dark red\nvoid main() {}")).substr(0, 12), "own.fs:1:27:");
    EXPECT_EQ(errorsOf(checked("uniform float a; // 0 .. 1, usually 0.5\nvoid main() {}")),
              "own.fs:1:29: “usually 0.5” is unknown here; after the range of “a” follow default, exact, a unit or a "
              "label in "
              "quotes.\n");
    EXPECT_EQ(errorsOf(checked("uniform float a; // 1 .. 0\nvoid main() {}")),
              "own.fs:1:21: The range of “a” is empty; write the lower number first.\n");
    EXPECT_EQ(
        errorsOf(checked("\nuniform mat4 m;\nvoid main() {}")),
        "own.fs:2:14: The uniform “m” has the type “mat4”, which no slider can set; use a number, a vector, bool or "
        "sampler2D.\n");
}

TEST(ShaderReader, RefusesWhatIsNoShader)
{
    EXPECT_EQ(errorsOf(checked("")), "own.fs:1:1: The file is empty; write a shader into it.\n");
    EXPECT_EQ(errorsOf(checked("hello")), "own.fs:1:1: This is not a shader: it has neither main() nor mainImage(), "
                                          "and no JSON in its first comment; write "
                                          "one of them.\n");
    EXPECT_EQ(errorsOf(checked(std::string("void main() {\n}\0", 16))),
              "own.fs:2:2: Here is a zero byte, which no text has; remove it.\n");
    EXPECT_EQ(errorsOf(checked("void main() {}" + std::string(1U << 20U, ' '))),
              "own.fs:1:1: The file has more than 1048576 bytes; shorten it.\n");
}

TEST(ShaderReader, IncludesFilesOfItsFolderOnly)
{
    const std::string text = "#include \"lib/tint.glsl\"\nvoid main() { gl_FragColor = tint(); }\n";
    EXPECT_EQ(errorsOf(checked(text, {{"lib/tint.glsl", "vec4 tint() { return vec4(1.0); }\n"}})), "");
    EXPECT_EQ(errorsOf(checked(text, {{"lib/tint.glsl", "\nvec4 tint() { return vec4(on); }\n"}})),
              "lib/tint.glsl:2:27: The GLSL compiler says: 'on' : undeclared identifier.\n");
    EXPECT_EQ(errorsOf(checked("#include \"own.glsl\"\nvoid main() {}", {{"own.glsl", "#include \"own.glsl\"\n"}})),
              "own.glsl:1:2: Files include each other more than 8 deep; remove the circle.\n");

    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in");
    test::writeBytes(folder / "secret.glsl", "vec4 tint() { return vec4(1.0); }\n");
    guest::ShaderCompiler compiler;
    for (const char* path : {"../secret.glsl", "/etc/passwd", "link.glsl"}) {
        std::filesystem::remove(folder / "in/link.glsl");
        std::filesystem::create_symlink(folder / "secret.glsl", folder / "in/link.glsl");
        test::writeBytes(folder / "in/a.frag",
                         "#include \"" + std::string(path) + "\"\nvoid main() { gl_FragColor = tint(); }\n");
        const guest::CheckedShader read = guest::checkShaderFile(folder / "in/a.frag", compiler);
        ASSERT_EQ(read.errors.size(), 1U) << path;
        EXPECT_EQ(read.errors[0].line, 1) << path;
        EXPECT_NE(read.errors[0].sentence.english().find(path), std::string::npos) << read.errors[0].sentence;
    }
    EXPECT_FALSE(guest::checkShaderFile(folder / "none.fs", compiler).fileRead);
}

TEST(SizeExpressions, GivePixels)
{
    const auto sizeOf = [](std::string_view text) {
        const auto value = [](std::string_view name) -> std::optional<double> {
            if (name == "m" || name == "parts") return 3.0;  // "m" is a unit elsewhere.
            return std::nullopt;
        };
        return guest::passSize(text, 640, 480, 640, value);
    };
    EXPECT_EQ(sizeOf("").pixels, 640);
    EXPECT_EQ(sizeOf("1").pixels, 1);
    EXPECT_EQ(sizeOf("floor($HEIGHT/7.0)").pixels, 68);
    EXPECT_EQ(sizeOf("$WIDTH / $m").pixels, 213);
    EXPECT_EQ(sizeOf("max(floor($WIDTH*0.02),1.0)").pixels, 12);
    EXPECT_EQ(sizeOf("0").pixels, 1);
    EXPECT_EQ(sizeOf("$none").problem.english(), "there is no input “none” with a number; declare it in INPUTS");
    EXPECT_EQ(sizeOf("$WIDTH * 100").problem.english(),
              "“$WIDTH * 100” gives more than 8192 pixels; choose a smaller size");
    EXPECT_FALSE(sizeOf("1 / 0").problem.empty());
    EXPECT_FALSE(sizeOf(std::string(100'000, '(')).problem.empty());
}

TEST(CheckOfAShader, FindsPicturesThatAreNotInItsFolder)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in");
    test::writeBytes(folder / "in/a.glsl",
                     "#iChannel0 \"file://../sand.png\"\nvoid mainImage(out vec4 c, in vec2 p) { c = "
                     "texture(iChannel0, p); }\n");
    guest::ShaderCompiler compiler;
    const guest::CheckedShader read = guest::checkShaderFile(folder / "in/a.glsl", compiler);
    ASSERT_EQ(read.errors.size(), 1U);
    EXPECT_EQ(read.errors[0].sentence.english(),
              "The picture “../sand.png” is not in the shader's folder; copy it there.");
}

TEST(KeysOfAShader, AreWrittenAsTheyArePressed)
{
    std::string keys = guest::withKey("", 65, true, 0.5);
    EXPECT_EQ(keys, "65@0.5");
    EXPECT_EQ(guest::withKey(keys, 65, true, 0.75), keys) << "it is held already";
    keys = guest::withKey(guest::withKey(keys, 32, true, 1), 65, false, 2.25);
    EXPECT_EQ(keys, "65@0.5-2.25 32@1");
    const guest::KeyPresses read = guest::readKeys(keys);
    ASSERT_EQ(read.presses.size(), 2U);
    EXPECT_TRUE(read.problem.empty());
    EXPECT_EQ(read.presses[0].to, 2.25);
    EXPECT_EQ(guest::readKeys("65@-2--1.5").presses[0].from, -2);
    for (const char* wrong : {"65", "65@", "256@1", "65@2-1", "6.5@1", "65@nan", "65@1-"})
        EXPECT_FALSE(guest::readKeys(wrong).problem.empty()) << wrong;
    std::string many;
    for (int i = 0; i < 300; ++i) many = guest::withKey(guest::withKey(many, 65, true, i), 65, false, i + 0.5);
    EXPECT_LE(guest::readKeys(many).presses.size(), guest::mostPresses);
    EXPECT_EQ(guest::readKeys(many).presses.size() % 2, 0U) << "what is switched on stays so";
}

TEST(GlslLexer, SkipsCommentsAndKeepsLines)
{
    const render::Tokens tokens("a /* b\n */ c // d\\\n e\n#define F \\\n 1.5e-3\nx.y");
    std::vector<std::string> words;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        words.push_back(std::string(tokens.text(i)) + '@' + std::to_string(tokens[i].line));
    EXPECT_EQ(words,
              (std::vector<std::string>{"a@1", "c@2", "#@4", "define@4", "F@4", "1.5e-3@5", "x@6", ".@6", "y@6"}));
    EXPECT_EQ(render::columnOf("a\n  sample s; es", 2, "s"), 10);
    EXPECT_EQ(render::columnOf("a\n  b", 9, "b"), 1);
}

}  // namespace
}  // namespace vitrine
