// Pictures of visitors' shaders against closed forms, to the 8-bit value: each dialect, inputs, passes, buffers that
// are kept, and files that fail.

#include "exhibits/your_shader/your_shader_table.h"
#include "render/failure.h"
#include "render/glsl/cpu.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/exhibits/your_shader/shader_shot.h"
#include "tests/exhibits/your_shader/shaders.h"
#include "tests/support/gallery.h"
#include "tests/support/made_image.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {
namespace {

using namespace test;

using Codes = std::array<int, 3>;

class YourShaderPictures : public GlTest {};

using LongYourShaderPictures = YourShaderPictures;

TEST_F(YourShaderPictures, OfAPlainShaderAreItsFormula)
{
    ShaderShot own;
    ASSERT_EQ(
        own.show("uniform float u_time; uniform vec2 u_resolution; uniform vec2 u_mouse;\n"
                 "uniform float gain; // 0 .. 10, default 2\n"
                 "void main() { vec2 p = floor(gl_FragCoord.xy);\n"
                 "gl_FragColor = vec4(p.x * gain, p.y + u_resolution.x, 100.0 * u_time + u_mouse.y, 255.0) / 255.0; }",
                 "own.frag"),
        "");
    own.set("moment", 0.5);
    own.set("mouseY", 0.25);
    const Picture picture = own.shot.take();
    for (const glm::ivec2 p : {glm::ivec2(0), glm::ivec2(7, 11), glm::ivec2(23, 15)})
        EXPECT_EQ(ShaderShot::code(picture, p.x, p.y), (Codes{2 * p.x, p.y + 24, 54})) << p.x << ',' << p.y;
    own.set("gain", 5.0);
    EXPECT_EQ(own.codeAt(23, 0), (Codes{115, 24, 54}));
}

TEST_F(YourShaderPictures, OfAnIsfShaderFollowEveryKindOfInput)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "line_width", "TYPE": "float", "MIN": 0, "MAX": 100, "DEFAULT": 30},
        {"NAME": "isOn", "TYPE": "bool", "DEFAULT": true},
        {"NAME": "mode", "TYPE": "long", "VALUES": [10, 20, 40], "LABELS": ["a", "b", "b"], "DEFAULT": 20},
        {"NAME": "tint", "TYPE": "color", "DEFAULT": [0.2, 0.4, 0.6, 0.8]},
        {"NAME": "center", "TYPE": "point2D", "MIN": [0, 0], "MAX": [50, 50], "DEFAULT": [3, 4]},
        {"NAME": "flash", "TYPE": "event"}])",
                           "vec3 a = vec3(line_width, isOn ? 7.0 : 0.0, float(mode)) / 255.0;\n"
                           "vec3 b = vec3(center, flash ? 99.0 : 1.0) / 255.0;\n"
                           "vec3 c = gl_FragCoord.x < 4.0 ? a : gl_FragCoord.x < 8.0 ? b : gl_FragCoord.x < 12.0 ? "
                           "tint.rgb : tint.aaa;\n"
                           "if (isf_FragNormCoord.x > 0.5 && gl_FragCoord.x > 20.0) c = vec3(RENDERSIZE, FRAMEINDEX) / "
                           "255.0;\n gl_FragColor = vec4(c, 1.0);")),
              "");
    own.set("moment", 2.0);
    Picture picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 0, 0), (Codes{30, 7, 20}));
    EXPECT_EQ(ShaderShot::code(picture, 4, 0), (Codes{3, 4, 1}));
    EXPECT_EQ(ShaderShot::code(picture, 8, 0), (Codes{51, 102, 153}));
    EXPECT_EQ(ShaderShot::code(picture, 12, 0), (Codes{204, 204, 204}));
    EXPECT_EQ(ShaderShot::code(picture, 22, 0), (Codes{24, 16, 120}));
    own.set("lineWidth", 80.0);
    own.set("isOn", 0.0);
    own.set("mode", 2.0);
    own.set("centerY", 44.0);
    own.set("flashAt", 2.0);
    picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 0, 0), (Codes{80, 0, 40}));
    EXPECT_EQ(ShaderShot::code(picture, 4, 0), (Codes{3, 44, 99}));
    const ParameterInfo& choice = own.shot.values().rows()[*own.shot.values().table().find("mode")];
    EXPECT_EQ(choice.choices, (std::vector<std::string_view>{"a", "b", "b 2"}));
}

TEST_F(YourShaderPictures, OfShadertoyCodeAreItsFormula)
{
    ShaderShot own;
    ASSERT_EQ(
        own.show("#iUniform int steps = 3 in {0, 9}\n"
                 "void mainImage(out vec4 c, in vec2 p) { c = vec4(floor(p) + iResolution.y, iFrame + steps, 0) / "
                 "255.0; if (iMouse.z > 0.0) c.rg = iMouse.xy / 255.0; }",
                 "own.glsl"),
        "");
    own.set("moment", 1.0);
    EXPECT_EQ(own.codeAt(5, 9), (Codes{21, 25, 63}));
    own.set("mouseDown", 1.0);
    EXPECT_EQ(own.codeAt(5, 9), (Codes{12, 8, 63}));
}

TEST_F(YourShaderPictures, KnowWhereTheMouseWasPressedAndThatItIsUp)
{
    ShaderShot own;
    ASSERT_EQ(own.show("void mainImage(out vec4 c, in vec2 p) { vec4 m = p.x < 8.0 ? iMouse : -iMouse; if (p.y > 8.0) "
                       "m.xy = m.zw; c = vec4(m.xy, 0, 255) / 255.0; }",
                       "own.glsl"),
              "");
    const auto seen = [&] {
        const Picture picture = own.shot.take();
        std::array<int, 4> mouse{};
        for (const int i : {0, 1}) {
            mouse[static_cast<std::size_t>(i)] = ShaderShot::code(picture, 2, 2)[static_cast<std::size_t>(i)];
            const int above = ShaderShot::code(picture, 2, 12)[static_cast<std::size_t>(i)];
            const int below = ShaderShot::code(picture, 12, 12)[static_cast<std::size_t>(i)];
            mouse[static_cast<std::size_t>(i + 2)] = above - below;
        }
        return mouse;
    };
    EXPECT_EQ(seen(), (std::array{0, 0, 0, 0})) << "never pressed";
    for (const auto& [name, value] : {std::pair("mouseX", 0.75), std::pair("mouseY", 0.5), std::pair("pressX", 0.25),
                                      std::pair("pressY", 0.125), std::pair("mouseDown", 1.0)})
        own.set(name, value);
    EXPECT_EQ(seen(), (std::array{18, 8, 6, -2})) << "held";
    own.set("mouseDown", 0.0);
    EXPECT_EQ(seen(), (std::array{18, 8, -6, -2})) << "let go";
}

TEST_F(YourShaderPictures, OfEachFeatureOfShadertoyAreItsFormula)
{
    struct Expected {
        const char* file;
        std::vector<std::pair<const char*, double>> settings;
        Codes at5And9;
    };
    // The pictures have 24 x 16 pixels, and 60 steps a second. The files say what each channel shows.
    const std::vector<Expected> all{
        {"image.glsl", {}, {5, 9, 40}},
        {"date.glsl", {{"moment", 7200}}, {26, 1, 14}},
        {"time_delta.glsl", {{"moment", 1}}, {100, 60, 10}},
        {"frame.glsl", {{"moment", 33 / 60.0}}, {33, 1, 0}},
        {"mouse.glsl", {{"mouseX", 0.25}, {"mouseY", 0.5}, {"mouseDown", 1}}, {6, 8, 1}},
        {"sliders.glsl", {{"count", 5}}, {7 + 5, 10 + 4 + 5, 1 + 2 + 3}},
        {"texture.glsl", {}, {2, 255, 255}},
        {"include.glsl", {}, {5, 9, 77}},
        {"es300.glsl", {}, {5 + 11 + 9, 84, 2 + 2 * 5}},
        {"feedback.json", {{"moment", 3 / 60.0}}, {1024 / 8, 0, 0}},
        {"buffers.json", {}, {7 * (5 + 3 * 2), 7 * (5 + 3 * 5), 2}},
        {"common.json", {}, {40 + 2 * 5, 40 + 2 * 9, 0}},
        {"earlier_buffer.json", {{"moment", 5 / 60.0}}, {2 * 4, 2 * 5, 0}},
        {"keyboard.json", {}, {0, 0, 9}},
        {"cube_buffer.json", {}, {94, 139, 250}},
    };
    for (const Expected& expected : all) {
        SCOPED_TRACE(expected.file);
        ShaderShot own;
        ASSERT_EQ(own.showOurs(expected.file), "");
        for (const auto& [name, value] : expected.settings) own.set(name, value);
        EXPECT_EQ(own.codeAt(5, 9), expected.at5And9);
    }
}

/// Shadertoy's JSON of one pass that reads a channel 0 of this type.
std::string reading(const std::string& type, const std::string& source, const std::string& body)
{
    return R"({"renderpass": [{"type": "image", "name": "Image", "inputs": [{"channel": 0, "ctype": ")" + type +
           R"(", "id": "x", "src": ")" + source + R"("}], "code": "void mainImage(out vec4 c, in vec2 p) { )" + body +
           "}\"}]}";
}

TEST_F(YourShaderPictures, OfABuiltInCubeMapShowSkySunAndTiles)
{
    ShaderShot own;
    ASSERT_EQ(own.show(reading("cubemap", "/media/a/1.jpg",
                               "vec3 way = p.x < 6.0 ? vec3(0, 1, 0) : p.x < 12.0 ? vec3(0.48, 0.6, 0.64) : p.x < 18.0 "
                               "? vec3(0.5, -1, 0.5) : vec3(-0.5, -1, 0.5); c = textureLod(iChannel0, way, 0.0); if "
                               "(p.y > 8.0) c = vec4(iChannelResolution[0], 255) / 512.0;"),
                       "own.json"),
              "");
    const Picture picture = own.shot.take();
    const Codes zenith = ShaderShot::code(picture, 2, 2);
    EXPECT_NEAR(zenith[0], 51, 2);
    EXPECT_NEAR(zenith[1], 102, 2);
    EXPECT_NEAR(zenith[2], 204, 2);
    EXPECT_EQ(ShaderShot::code(picture, 8, 2), (Codes{255, 247, 224}));
    EXPECT_EQ(ShaderShot::code(picture, 14, 2), (Codes{140, 128, 112}));
    const Codes dark = ShaderShot::code(picture, 20, 2);  // 0.3, 0.28, 0.26
    EXPECT_NEAR(dark[0], 76.5, 1);
    EXPECT_NEAR(dark[1], 71.4, 1);
    EXPECT_NEAR(dark[2], 66.3, 1);
    EXPECT_EQ(ShaderShot::code(picture, 2, 12), (Codes{128, 128, 0})) << "256 pixels";
    ASSERT_EQ(
        own.show("uniform samplerCube u_sky; void main() { gl_FragColor = textureCube(u_sky, vec3(0.5, -1, 0.5)); }",
                 "own.frag"),
        "");
    EXPECT_EQ(own.codeAt(2, 2), (Codes{140, 128, 112})) << "a uniform of a plain shader";
}

TEST_F(YourShaderPictures, OfABuiltInVolumeAreTheHashOfTheTexel)
{
    ShaderShot own;
    const glm::uvec4 bits = glsl::pcg4d(glm::uvec4(3, 5, 7, 42)) >> 24U;
    const auto show = [&](const char* source, const char* at) {
        ASSERT_EQ(own.show(reading("volume", source, "c = texture(iChannel0, " + std::string(at) + ");"), "own.json"),
                  "");
    };
    const Codes expected{static_cast<int>(bits.x), static_cast<int>(bits.y), static_cast<int>(bits.z)};
    show("/media/a/rgba.bin", "vec3(3.5, 5.5, 7.5) / 32.0");
    EXPECT_EQ(own.codeAt(2, 2), expected);
    show("/media/a/rgba.bin", "vec3(3.5, 5.5, 7.5) / 32.0 + vec3(1, -2, 3)");
    EXPECT_EQ(own.codeAt(2, 2), expected) << "it repeats";
    show("/media/a/27012b4eadd0c3ce12498b867058e4f717ce79e10a99568cca461682d84a4b04.bin", "vec3(3.5, 5.5, 7.5) / 32.0");
    EXPECT_EQ(own.codeAt(2, 2), (Codes{expected[0], 0, 0})) << "gray noise";
}

TEST_F(LongYourShaderPictures, OfCubeAAreTheDirectionsOfItsFaces)
{
    ShaderShot own;
    ASSERT_EQ(own.show(R"({"renderpass": [
      {"type": "cubemap", "name": "Cube A", "inputs": [{"channel": 0, "ctype": "cubemap", "id": "q"}], "outputs": [{"channel": 0, "id": "q"}],
       "code": "void mainCubemap(out vec4 c, in vec2 p, in vec3 from, in vec3 way) { float before = texture(iChannel0, way).a; c = vec4(way, before + 1.0); if (iResolution.x != 1024.0) c = vec4(0); }"},
      {"type": "image", "name": "Image", "inputs": [{"channel": 1, "ctype": "cubemap", "id": "q"}],
       "code": "void mainImage(out vec4 c, in vec2 p) { int f = int(p.x) / 4; float s = f % 2 == 0 ? 1.0 : -1.0; vec3 way = vec3(0.3, -0.6, 0.45); way[f / 2] = s; way = normalize(way); vec4 t = textureLod(iChannel1, way, 0.0); c = vec4(dot(t.xyz, way), 200.0 * distance(t.xyz, way), t.a / 255.0, 1.0); }"}]})",
                       "own.json"),
              "");
    own.set("moment", 4 / 60.0);
    const Picture picture = own.shot.take();
    for (int face = 0; face < 6; ++face) {
        const Codes code = ShaderShot::code(picture, 4 * face + 1, 3);
        EXPECT_GE(code[0], 254) << face;
        EXPECT_LE(code[1], 60) << face << ": more than a thousandth beside the direction";
        EXPECT_EQ(code[2], 5) << "five steps have counted";
    }
}

TEST_F(YourShaderPictures, FollowTheKeysThatAreNamedWithTheirTimes)
{
    ShaderShot own;
    ASSERT_EQ(own.showOurs("keyboard.json"), "");
    own.set("keys", std::string("32@1-2 65@0.5-0.6 65@3-3.5"));
    const auto codeAt = [&](double moment) {
        own.set("moment", moment);
        return own.codeAt(5, 9);
    };
    EXPECT_EQ(codeAt(0.25), (Codes{0, 0, 9}));
    EXPECT_EQ(codeAt(0.75), (Codes{0, 255, 9})) << "A was switched on";
    EXPECT_EQ(codeAt(1.5), (Codes{255, 255, 9})) << "the blank is held";
    EXPECT_EQ(codeAt(2.5), (Codes{0, 255, 9}));
    EXPECT_EQ(codeAt(3.75), (Codes{0, 0, 9})) << "A was switched off";
    own.set("keys", std::string("A"));
    const render::FramePlan plan = planned(gallery().museum, own.shot.sceneState, own.shot.request.frame);
    ASSERT_TRUE(plan.findSkipped("your_shader/keys"));
    EXPECT_EQ(plan.findSkipped("your_shader/keys")->reason,
              "“A” is not a key press; write code@from-to, such as 65@1-2.5.");
}

std::string littleEndian(std::uint32_t number, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xFFU);
    return text;
}

/// A WAV file of 8000 samples a second with 16 bits; `sample` gives a channel at an index.
std::string wav(int channels, int length, const std::function<int(int channel, int i)>& sample)
{
    std::string data;
    for (int i = 0; i < length; ++i)
        for (int c = 0; c < channels; ++c) data += littleEndian(static_cast<std::uint32_t>(sample(c, i)), 2);
    const auto count = static_cast<std::uint32_t>(channels), size = static_cast<std::uint32_t>(data.size());
    return "RIFF" + littleEndian(36 + size, 4) + "WAVEfmt " + littleEndian(16, 4) + littleEndian(1, 2) +
           littleEndian(count, 2) + littleEndian(8000, 4) + littleEndian(16000 * count, 4) +
           littleEndian(2 * count, 2) + littleEndian(16, 2) + "data" + littleEndian(size, 4) + data;
}

TEST_F(YourShaderPictures, ShowTheSamplesOfASoundBeforeATime)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "sound", "TYPE": "audio", "MAX": 8}])",
                           "gl_FragColor = gl_FragCoord.y < 2.0 ? vec4(IMG_SIZE(sound), 0, 255) / 255.0 : "
                           "IMG_PIXEL(sound, vec2(floor(gl_FragCoord.x) + 0.5, gl_FragCoord.y < 8.0 ? 0.5 : 1.5));")),
              "");
    Picture picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 3, 0), (Codes{8, 1, 0})) << "silence";
    EXPECT_EQ(ShaderShot::code(picture, 3, 4), (Codes{128, 128, 128}));
    // Channel 0 rises by one code of 8 bits a sample, channel 1 falls.
    writeBytes(own.folder / "ramp.wav", wav(2, 100, [](int channel, int i) { return (channel == 0 ? i : -i) * 256; }));
    own.set("sound", (own.folder / "ramp.wav").string());
    own.set("moment", 60 / 8000.0);
    picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 3, 0), (Codes{8, 2, 0}));
    for (const int x : {0, 3, 7}) {
        EXPECT_NEAR(ShaderShot::code(picture, x, 4)[0], 127.5 + 127.5 * (52 + x) / 128.0, 0.6) << x;
        EXPECT_NEAR(ShaderShot::code(picture, x, 12)[0], 127.5 - 127.5 * (52 + x) / 128.0, 0.6) << x;
    }
    own.set("moment", 104 / 8000.0);
    EXPECT_NEAR(own.codeAt(7, 4)[0], 127.5 + 127.5 * 3 / 128.0, 0.6) << "it repeats after 100 samples";
    own.set("sound", (own.folder / "none.wav").string());
    own.shot.request.frame.needsFiles = true;
    EXPECT_THROW((void)own.shot.take(), Failure);
}

TEST_F(YourShaderPictures, ShowTheFrequenciesOfASoundBeforeATime)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "tones", "TYPE": "audioFFT", "MAX": 16}])",
                           "gl_FragColor = IMG_PIXEL(tones, vec2(min(floor(gl_FragCoord.x), 15.0) + 0.5, 0.5));")),
              "");
    // 1375 Hz is the 176th of 1024 frequencies up to 8 kHz, in the band from 1250 to 1500 Hz; its amplitude is a half.
    writeBytes(own.folder / "tone.wav", wav(1, 8000, [](int, int i) {
                   return static_cast<int>(std::lround(16384 * std::sin(2 * std::numbers::pi * 1375 * i / 8000.0)));
               }));
    own.set("tones", (own.folder / "tone.wav").string());
    own.set("moment", 0.5);
    const Picture picture = own.shot.take();
    for (int x = 0; x < 16; ++x)
        EXPECT_NEAR(ShaderShot::code(picture, x, 4)[0], x == 5 ? 127.5 : 0, x == 5 ? 1.5 : 1) << x;
    own.set("moment", 0.0);
    EXPECT_EQ(own.codeAt(5, 4)[0], 0) << "nothing was heard yet";
}

TEST_F(YourShaderPictures, OfTheFirstShaderFollowItsInputsThoughNoFileWasChosen)
{
    ShaderShot own;
    ASSERT_EQ(own.read(), "");
    const Picture before = own.shot.take();
    own.set("uCells", 3.0);
    EXPECT_GT(largestDifference(before.image, own.shot.take().image), 0.1);
}

TEST_F(YourShaderPictures, ShowAFileWithItsLowerRowBelow)
{
    ShaderShot own;
    render::writePicture(own.folder / "four.png",
                         made(2, 2,
                              [](int x, int y, int c) {
                                  return c == 0 ? static_cast<float>(x) : c == 1 ? static_cast<float>(y) : 0;
                              }),
                         render::PictureFormat::png8);
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                           "gl_FragColor = IMG_PIXEL(inputImage, floor(isf_FragNormCoord * 2.0) + 0.5);"
                           "if (gl_FragCoord.x < 1.0) gl_FragColor.b = IMG_SIZE(inputImage).x / 255.0;")),
              "");
    own.set("inputImage", (own.folder / "four.png").string());
    Picture picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 0, 0), (Codes{0, 255, 2}));
    EXPECT_EQ(ShaderShot::code(picture, 23, 0), (Codes{255, 255, 0}));
    EXPECT_EQ(ShaderShot::code(picture, 23, 15), (Codes{255, 0, 0}));
    // Without a file there is a test picture, and a missing file is reported.
    own.set("inputImage", std::string());
    picture = own.shot.take();
    EXPECT_NE(ShaderShot::code(picture, 23, 0), ShaderShot::code(picture, 0, 15));
    own.set("inputImage", (own.folder / "none.png").string());
    own.shot.request.frame.needsFiles = true;
    EXPECT_THROW((void)own.shot.take(), Failure);
}

TEST_F(YourShaderPictures, OfATransitionAreMadeOfTwoFiles)
{
    ShaderShot own;
    const auto plain = [&](const char* name, int channel) {
        const std::string path = (own.folder / name).string();
        render::writePicture(path, made(2, 2, [=](int, int, int c) { return c == channel ? 1.0F : 0.0F; }),
                             render::PictureFormat::png8);
        return path;
    };
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "startImage", "TYPE": "image"}, {"NAME": "endImage", "TYPE": "image"},
                           {"NAME": "progress", "TYPE": "float"}])",
                           "gl_FragColor = mix(IMG_THIS_PIXEL(startImage), IMG_THIS_PIXEL(endImage), progress);")),
              "");
    own.set("startImage", plain("red.png", 0));
    own.set("endImage", plain("blue.png", 2));
    own.set("progress", 0.0);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{255, 0, 0}));
    own.set("progress", 0.2);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{204, 0, 51}));
    own.set("progress", 1.0);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{0, 0, 255}));
}

TEST_F(YourShaderPictures, OfVertexShadersInterpolateBetweenTheCornersOfThePicture)
{
    ShaderShot own;
    // At the corners, the clamped value is 0 or 1; between them it is linear.
    writeBytes(own.folder / "own.vs", "varying vec2 at;\nvoid main() { isf_vertShaderInit();\n"
                                      "at = clamp(isf_FragNormCoord, 0.0, 1.0); }\n");
    ASSERT_EQ(own.show("/*{}*/ varying vec2 at;\nvoid main() { gl_FragColor = vec4(at, 0.0, 1.0); }"), "");
    const Picture picture = own.shot.take();
    const auto at = [](int pixel, int pixels) { return static_cast<int>(std::lround(255 * (pixel + 0.5) / pixels)); };
    for (const glm::ivec2 p : {glm::ivec2(0), glm::ivec2(23, 0), glm::ivec2(5, 11), glm::ivec2(20, 15)})
        EXPECT_EQ(ShaderShot::code(picture, p.x, p.y), (Codes{at(p.x, 24), at(p.y, 16), 0})) << p.x << ',' << p.y;
}

TEST_F(YourShaderPictures, OfFilesAreNotBlurredWhereCoordinatesJump)
{
    ShaderShot own;
    render::writePicture(own.folder / "halves.png",
                         made(64, 64, [](int x, int, int) { return static_cast<float>(x >= 32); }),
                         render::PictureFormat::png8);
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                           "gl_FragColor = IMG_NORM_PIXEL(inputImage, vec2(fract(gl_FragCoord.x * 0.5), 0.5));")),
              "");
    own.set("inputImage", (own.folder / "halves.png").string());
    const Picture picture = own.shot.take();
    EXPECT_EQ(ShaderShot::code(picture, 6, 3), (Codes{0, 0, 0}));
    EXPECT_EQ(ShaderShot::code(picture, 7, 3), (Codes{255, 255, 255}));
}

TEST_F(YourShaderPictures, ComeFromPassesWithSizesByExpression)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(
                  R"j("INPUTS": [{"NAME": "m", "TYPE": "float", "MIN": 1, "MAX": 8, "DEFAULT": 2}],
        "PASSES": [{"TARGET": "small", "WIDTH": "floor($WIDTH / $m)", "HEIGHT": "5", "FLOAT": true
}, {}])j",
                  "if (PASSINDEX == 0) gl_FragColor = vec4(RENDERSIZE, 300.0, 1.0) / 255.0;\n"
                  "else gl_FragColor = vec4(IMG_THIS_PIXEL(small).rg, IMG_THIS_PIXEL(small).b - 200.0 / 255.0, 1.0);")),
              "");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{12, 5, 100}));
    own.set("m", 4.0);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{6, 5, 100}));
}

TEST_F(YourShaderPictures, InterpolateBetweenTheTexelsOfABuffer)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("PASSES": [{"TARGET": "two", "WIDTH": "2", "HEIGHT": "1"}, {}])",
                           "gl_FragColor = PASSINDEX == 0 ? vec4(floor(gl_FragCoord.x) * 200.0 / 255.0)\n"
                           ": IMG_NORM_PIXEL(two, vec2(0.5));")),
              "");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{100, 100, 100}));
}

/// Counts its steps in a buffer, and shows the number.
const std::string counter = isf(
    R"("INPUTS": [{"NAME": "by", "TYPE": "float", "MIN": 0, "MAX": 9, "DEFAULT": 1}],
       "PASSES": [{"TARGET": "count", "PERSISTENT": true, "FLOAT": true}, {}])",
    "gl_FragColor = PASSINDEX == 0 ? IMG_THIS_PIXEL(count) + vec4(by) : vec4(IMG_THIS_PIXEL(count).r, FRAMEINDEX, 0, "
    "255) "
    "/ 255.0;");

TEST_F(YourShaderPictures, OfAKeptBufferAreAFunctionOfTimeAlone)
{
    ShaderShot own;
    ASSERT_EQ(own.show(counter), "");
    const auto codeAt = [&](double moment) {
        own.set("moment", moment);
        return own.codeAt(3, 3);
    };
    // Step N has added N + 1 times: in any order of times, again, and at another size.
    EXPECT_EQ(codeAt(0), (Codes{1, 0, 0}));
    EXPECT_EQ(codeAt(0.5), (Codes{31, 30, 0}));
    EXPECT_EQ(codeAt(0.5), (Codes{31, 30, 0}));
    EXPECT_EQ(codeAt(31 / 60.0), (Codes{32, 31, 0}));
    EXPECT_EQ(codeAt(0.5), (Codes{31, 30, 0})) << "one step back";
    EXPECT_EQ(codeAt(2), (Codes{121, 120, 0}));
    EXPECT_EQ(codeAt(0.1), (Codes{7, 6, 0})) << "far back";
    own.shot.size(40, 20);
    EXPECT_EQ(codeAt(0.1), (Codes{7, 6, 0}));
    own.set("by", 3.0);
    EXPECT_EQ(codeAt(0.1), (Codes{21, 6, 0})) << "values of files count from the first step on";
    own.set("rate", 20.0);
    EXPECT_EQ(codeAt(0.1), (Codes{9, 2, 0}));
}

TEST_F(YourShaderPictures, OfSeveralPassesHaveStepsOnlyIfATargetIsPersistent)
{
    ShaderShot own;
    const auto passes = [&](const std::string& persistent) {
        EXPECT_EQ(own.show(isf(R"("PASSES": [{"TARGET": "raw")" + persistent + "}, {}]",
                               "gl_FragColor = PASSINDEX == 0 ? vec4(128.0 / 255.0) : IMG_THIS_PIXEL(raw);")),
                  "");
        own.set("moment", 1.0);
        EXPECT_EQ(own.codeAt(3, 3), (Codes{128, 128, 128}));
        const render::FramePlan plan = test::planned(gallery().museum, own.shot.sceneState, own.shot.request.frame);
        return std::count_if(plan.passes().begin(), plan.passes().end(),
                             [](const render::Pass& pass) { return pass.name.starts_with("your_shader/"); });
    };
    const auto still = passes("");
    EXPECT_LE(still, 4);  // One step, and the picture made of it.
    EXPECT_GT(passes(R"(, "PERSISTENT": true)"), 60);
}

TEST_F(YourShaderPictures, OfShadertoyKnowTheSizesOfTheirChannels)
{
    ShaderShot own;
    ASSERT_EQ(own.show(R"({"renderpass": [
      {"type": "buffer", "name": "Buffer A", "inputs": [], "outputs": [{"channel": 0, "id": "a"}],
       "code": "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }"},
      {"type": "image", "name": "Image", "inputs": [{"channel": 0, "type": "buffer", "id": "a"}],
       "code": "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p) * vec4(iChannelResolution[0].xy, 0, 255) / 255.0; }"}]})",
                       "own.json"),
              "");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{24, 16, 0}));
}

TEST_F(YourShaderPictures, OfAGliderMoveByACellInFourSteps)
{
    ShaderShot own;
    own.shot.size(12, 12);
    ASSERT_EQ(own.show(R"({"renderpass": [
      {"type": "buffer", "name": "Buffer A", "inputs": [{"channel": 0, "type": "buffer", "id": "a"}], "outputs": [{"channel": 0, "id": "a"}],
       "code": "void mainImage(out vec4 c, in vec2 p) { ivec2 q = ivec2(p); int n = 0; for (int y = -1; y <= 1; ++y) for (int x = -1; x <= 1; ++x) n += int(texelFetch(iChannel0, (q + ivec2(x, y) + 12) % 12, 0).r); bool was = texelFetch(iChannel0, q, 0).r > 0.5; bool lives = was ? n == 3 || n == 4 : n == 3; if (iFrame == 0) lives = q == ivec2(2, 4) || q == ivec2(3, 3) || (q.y == 2 && q.x >= 1 && q.x <= 3); c = vec4(lives); }"},
      {"type": "image", "name": "Image", "inputs": [{"channel": 0, "type": "buffer", "id": "a"}],
       "code": "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }"}]})",
                       "own.json"),
              "");
    const auto cells = [&](double moment) {
        own.set("moment", moment);
        const Picture picture = own.shot.take();
        std::vector<glm::ivec2> alive;
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                if (ShaderShot::code(picture, x, y)[0] > 128) alive.emplace_back(x, y);
        return alive;
    };
    std::vector<glm::ivec2> moved = cells(0);
    ASSERT_EQ(moved.size(), 5U);
    for (glm::ivec2& cell : moved) cell += glm::ivec2(1, -1);
    EXPECT_EQ(cells(4 / 60.0).size(), 5U);
    auto later = cells(4 / 60.0);
    for (glm::ivec2& cell : moved) cell = (cell + 12) % 12;
    const auto before = [](const glm::ivec2& a, const glm::ivec2& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
    std::sort(moved.begin(), moved.end(), before);
    EXPECT_EQ(later, moved);
}

TEST_F(YourShaderPictures, StayWhenTheFileFails)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(9.0, 8.0, 7.0, 255.0) / 255.0;")), "");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{9, 8, 7}));
    const std::string why = own.show(isf("", "gl_FragColor = vec4(nothing);"));
    EXPECT_EQ(why, "File of Your Shader: " + (own.folder / "own.fs").string() +
                       ":3:21: The GLSL compiler says: 'nothing' : undeclared identifier.");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{9, 8, 7}));
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(1.0, 2.0, 3.0, 255.0) / 255.0;")), "");
    EXPECT_EQ(own.codeAt(3, 3), (Codes{1, 2, 3}));
}

TEST_F(YourShaderPictures, AreStillWhereNothingReadsTheTime)
{
    ShaderShot own;
    own.set("animate", 1.0);
    const auto next = [&] {
        const Prepared prepared = gallery().museum.prepare(own.shot.sceneState, own.shot.request.frame);
        return gallery().museum.nextChange(prepared, own.shot.request.frame);
    };
    EXPECT_EQ(next(), 0) << "the first shader moves";
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(isf_FragNormCoord, 0.0, 1.0);")), "");
    EXPECT_EQ(next(), std::numeric_limits<double>::infinity());
    (void)own.shot.take();
    own.shot.request.frame.time = 5;
    const render::FramePlan plan = test::planned(gallery().museum, own.shot.sceneState, own.shot.request.frame,
                                                 gallery().renderer.persistentState());
    EXPECT_EQ(plan.errors(), std::vector<std::string>());
    const render::CulledPass* skipped = plan.findSkipped("your_shader/1 pass 1");
    ASSERT_TRUE(skipped);
    EXPECT_EQ(skipped->reason, "unchanged since it last ran");
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(fract(TIME));")), "");
    EXPECT_EQ(next(), 0);
    ASSERT_EQ(own.show(counter), "");
    EXPECT_EQ(next(), 0);
}

TEST_F(YourShaderPictures, CatchUpInTheWindowAndContinueWithOtherValues)
{
    ShaderShot own;
    ASSERT_EQ(own.show(counter), "");
    own.set("animate", 1.0);
    FrameRequest frame = own.shot.request.frame;
    frame.time = 1;
    const auto drawn = [&] {
        render::FramePlan plan =
            test::planned(gallery().museum, own.shot.sceneState, frame, gallery().renderer.persistentState());
        EXPECT_EQ(plan.errors(), std::vector<std::string>());
        (void)gallery().renderer.draw(plan);
        const render::Image image = gallery().renderer.read("frame");
        return static_cast<int>(std::lround(255 * render::srgbFromLinear(image.at(3, 3, 0))));
    };
    for (int shown = 8; shown <= 56; shown += 8) EXPECT_EQ(drawn(), shown);
    EXPECT_EQ(drawn(), 61);
    EXPECT_EQ(drawn(), 61);
    own.set("by", 5.0);
    frame.time = 62 / 60.0;
    EXPECT_EQ(drawn(), 71) << "the buffer continues from what it holds";
    own.set("afterChange", 1.0);
    EXPECT_EQ(drawn(), 40) << "the steps begin again";
    EXPECT_EQ(drawn(), 80);
    own.set("restarts", 1.0);
    EXPECT_EQ(drawn(), 40) << "the buffers were emptied";
}

TEST_F(YourShaderPictures, MarkWhatIsNoNumberInABufferUntilItIsEmptied)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "zero", "TYPE": "float"}],
        "PASSES": [{"TARGET": "sum", "PERSISTENT": true, "FLOAT": true}, {}])",
                           "if (PASSINDEX == 1) gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0);\n"
                           "else gl_FragColor = IMG_THIS_PIXEL(sum) + (gl_FragCoord.x < 8.0 ? zero / zero : "
                           "gl_FragCoord.x < 16.0 && FRAMEINDEX == 2 ? 1.0 / zero : 1.0);")),
              "");
    const auto codesAt = [&](double moment) {
        own.set("moment", moment);
        const Picture picture = own.shot.take();
        return std::vector{ShaderShot::code(picture, 3, 3), ShaderShot::code(picture, 12, 3),
                           ShaderShot::code(picture, 20, 3)};
    };
    const Codes shown{51, 102, 153}, magenta{255, 0, 255};
    EXPECT_EQ(codesAt(4 / 60.0), (std::vector{shown, shown, shown}));
    own.set("markInvalid", 1.0);
    EXPECT_EQ(codesAt(1 / 60.0), (std::vector{magenta, shown, shown}));
    EXPECT_EQ(codesAt(4 / 60.0), (std::vector{magenta, magenta, shown})) << "infinity stays in the buffer";
    own.set("zero", 1.0);
    EXPECT_EQ(codesAt(4 / 60.0), (std::vector{shown, shown, shown}));
}

TEST_F(YourShaderPictures, HaveTheShadersOwnColorsInTheHall)
{
    ShaderShot own;
    own.shot.inHall().size(48, 32);
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(200.0, 100.0, 50.0, 255.0) / 255.0;")), "");
    const Codes code = own.codeAt(24, 16);
    EXPECT_NEAR(code[0], 200, 1);
    EXPECT_NEAR(code[1], 100, 1);
    EXPECT_NEAR(code[2], 50, 1);
}

TEST_F(YourShaderPictures, EndLoopsAfterTheRoundsThatAreAllowed)
{
    ShaderShot own;
    ASSERT_EQ(
        own.show(isf("", "float n = 0.0; for (;;) { n += 1.0; if (n < 0.0) break; } gl_FragColor = vec4(n / 255.0);")),
        "");
    own.set("loopRounds", 100.0);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{100, 100, 100}));
    own.set("loopRounds", 200.0);
    EXPECT_EQ(own.codeAt(3, 3), (Codes{200, 200, 200}));
}

/// Limits the time of visitors' shaders while it lives, as the window does.
class LimitedTime {
public:
    explicit LimitedTime(double seconds) { gallery().renderer.stopUnboundedAfter(seconds); }
    ~LimitedTime() { gallery().renderer.stopUnboundedAfter(std::numeric_limits<double>::infinity()); }
    LimitedTime(const LimitedTime&) = delete;
    LimitedTime& operator=(const LimitedTime&) = delete;
};

TEST_F(YourShaderPictures, ThatTakeTooLongAreStoppedUntilSomethingChanges)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf("", "float n = 0.0; for (;;) { n += 1.0; if (n < 0.0) break; } gl_FragColor = vec4(1.0);")),
              "");
    const auto complaints = [](const render::FrameReport& report) {
        std::string all;
        for (const render::CulledPass& each : report.skipped)
            if (each.complaint) all += each.name + ": " + each.reason + '\n';
        return all;
    };
    {
        // Every time is over after the first band, which is one row.
        const LimitedTime limited(0);
        const Picture part = own.shot.take();
        EXPECT_EQ(ShaderShot::code(part, 3, 0), (Codes{255, 255, 255}));
        EXPECT_EQ(ShaderShot::code(part, 3, 8), (Codes{0, 0, 0}));
        EXPECT_EQ(part.report.stopped.substr(0, 12), "your_shader/");
        EXPECT_EQ(complaints(part.report), "");

        const Picture dark = own.shot.take();
        EXPECT_NE(ShaderShot::code(dark, 3, 0), (Codes{255, 255, 255}));
        EXPECT_EQ(dark.report.stopped, "");
        EXPECT_EQ(complaints(dark.report),
                  "your_shader/time: Your Shader: a frame of " + (own.folder / "own.fs").string() +
                      " takes too long here; lower its parameters or “Loop rounds”, or draw it smaller. The frame "
                      "stays empty.\n");
    }
    own.set("loopRounds", 100.0);
    const Picture changed = own.shot.take();
    EXPECT_EQ(ShaderShot::code(changed, 3, 8), (Codes{255, 255, 255}));
    EXPECT_EQ(complaints(changed.report), "");
}

TEST_F(YourShaderPictures, StoppedStepsOfFeedbackAreNotComplete)
{
    // Each step adds 10 of 255.
    const std::string counts = isf(R"("PASSES": [{"TARGET": "sum", "PERSISTENT": true}])",
                                   "gl_FragColor = IMG_THIS_PIXEL(sum) + 10.0 / 255.0;");
    ShaderShot own;
    ASSERT_EQ(own.show(counts), "");
    own.set("moment", 0.5);
    own.set("rate", 10.0);
    own.set("animate", 0.0);
    const Codes right = own.codeAt(3, 8);
    EXPECT_EQ(right, (Codes{60, 60, 60}));
    own.set("restarts", 1.0);
    {
        const LimitedTime limited(0);
        EXPECT_NE(own.shot.take().report.stopped, "");
    }
    own.set("restarts", 2.0);
    EXPECT_EQ(own.codeAt(3, 8), right);
}

TEST_F(YourShaderPictures, InBandsAreTheSamePictures)
{
    ShaderShot own;
    own.shot.size(160, 90);
    ASSERT_EQ(own.show(isf("", "gl_FragColor = vec4(fract(gl_FragCoord.xy / 7.0), isf_FragNormCoord.x, 1.0);")), "");
    const Picture whole = own.shot.take();
    own.set("loopRounds", 100.0);  // So that it is drawn again.
    const LimitedTime limited(1000);
    const Picture banded = own.shot.take();
    EXPECT_EQ(banded.report.stopped, "");
    EXPECT_EQ(largestDifference(whole.image, banded.image), 0);
}

}  // namespace
}  // namespace vitrine
