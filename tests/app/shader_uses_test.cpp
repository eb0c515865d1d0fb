// A visitor's shader in everything that an exhibit can do on the command line: motions, prints, studies, settings from
// a picture, pictures of other exhibits. Recordings are tested in tests/exhibits/recording, comparisons and random
// variations in tests/ui/editor/shader_picture_test.cpp.

#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using test::Ended;

class OwnShader : public testing::Test {
protected:
    /// Writes a shader whose red is `gain` times the sum of 2^-i over its steps, and whose green is `gain`.
    OwnShader()
    {
        test::writeBytes(path(), "uniform float u_gain; // 0 .. 1, default 0.5, \"Gain\"\n"
                                 "#define STEPS 4       // 1 .. 16, exact 16, \"Steps\"\n"
                                 "void main()\n{\n    float sum = 0.0;\n"
                                 "    for (int i = 1; i <= STEPS; ++i) sum += exp2(-float(i));\n"
                                 "    gl_FragColor = vec4(u_gain * sum, u_gain, 0.0, 1.0);\n}\n");
    }
    [[nodiscard]] std::string path() const { return folder_ / "own.frag"; }
    [[nodiscard]] std::string file() const { return "file=" + path(); }
    /// Returns the display values of a pixel in the middle of a picture: red and green, 0 to 255.
    [[nodiscard]] std::array<int, 2> codes(const std::string& name) const
    {
        const render::Image image = render::readImage(folder_ / name);
        std::array<int, 2> found{};
        for (int c = 0; c < 2; ++c)
            found[static_cast<std::size_t>(c)] = static_cast<int>(
                std::lround(255 * render::srgbFromLinear(image.at(image.width / 2, image.height / 2, c))));
        return found;
    }
    void render(const std::string& out, const std::vector<std::string>& further) const
    {
        std::vector<std::string> arguments{"render", "your_shader", "--alone", "--size", "8x8", "--samples", "1"};
        arguments.insert(arguments.end(), further.begin(), further.end());
        arguments.insert(arguments.end(), {"--out", folder_ / out});
        const Ended ended = test::vitrine(arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
    }

    test::TemporaryFolder folder_;
};

using LongOwnShader = OwnShader;

TEST_F(OwnShader, MovesByMotions)
{
    // From 0 to 1 and back in 4 s.
    for (const auto& [time, gain] : {std::pair("1", 0.5), std::pair("2", 1.0), std::pair("3", 0.5)}) {
        render("moved.png", {"--set", file(), "--animate", "uGain=triangle:0:1:period=4", "--time", time});
        EXPECT_EQ(codes("moved.png")[1], std::lround(255 * gain)) << time;
    }
}

TEST_F(LongOwnShader, IsPrintedWithAnInputThatChangesFromViewToView)
{
    const Ended ended = test::vitrine({"print",
                                       "--exhibit",
                                       "your_shader",
                                       "--set",
                                       file(),
                                       "--sheet",
                                       "60-3d",
                                       "--sweep",
                                       "uGain=0..1",
                                       "--count",
                                       "3",
                                       "--view-size",
                                       "16x16",
                                       "--samples",
                                       "1",
                                       "--width-mm",
                                       "10",
                                       "--height-mm",
                                       "10",
                                       "--save-views",
                                       folder_ / "views",
                                       "--out",
                                       folder_ / "print.tif"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (int view = 0; view < 3; ++view) {
        const std::string name = "views/view_0" + std::to_string(view) + ".png";
        // The lamp above the frame adds up to 2 codes.
        EXPECT_NEAR(codes(name)[1], 127.5 * view, 2.5) << name;
        EXPECT_NEAR(codes(name)[0], 127.5 * view * 0.9375, 2.5) << name;
    }
    const render::Image print = render::readImage(folder_ / "print.tif");
    double low = 1, high = 0;
    for (int x = 0; x < print.width; ++x) {
        low = std::min<double>(low, print.at(x, print.height / 2, 1));
        high = std::max<double>(high, print.at(x, print.height / 2, 1));
    }
    EXPECT_LT(low, 0.05) << "strips of the first view";
    EXPECT_GT(high, 0.7) << "strips of the last view";
}

TEST_F(OwnShader, IsStudiedByItsAccuracyParameter)
{
    const Ended ended = test::vitrine({"study", "your_shader", "steps", "--alone", "--set", file(), "--values", "1,2,3",
                                       "--size", "16x16", "--runs", "1", "--views", "1", "--out", folder_ / "study"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const render::Json study = render::Json::parse(render::readFile(folder_ / "study/study.json", 1U << 24U));
    const auto linear = [](double sum) { return render::linearFromSrgb(0.5 * sum); };
    int found = 0;
    for (const auto& [row, sum] : {std::pair(0, 0.5), std::pair(1, 0.75), std::pair(2, 0.875)}) {
        const double error = study["points"][static_cast<std::size_t>(row)]["error"].get<double>();
        // Only red differs. Its values are rounded to 8 bits.
        EXPECT_NEAR(error, (linear(1) - linear(sum)) / std::sqrt(3.0), 0.003) << sum;
        ++found;
    }
    EXPECT_EQ(found, 3);
}

TEST_F(OwnShader, IsRestoredFromAPicture)
{
    render("first.png", {"--set", file(), "--set", "uGain=0.25"});
    EXPECT_EQ(codes("first.png"), (std::array<int, 2>{60, 64}));
    const Ended ended =
        test::vitrine({"render", "your_shader", "--preset", folder_ / "first.png", "--out", folder_ / "again.png"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(render::readImage(folder_ / "again.png").pixels, render::readImage(folder_ / "first.png").pixels);
}

TEST_F(LongOwnShader, ShowsAnotherExhibitAndRefusesUnknownOnes)
{
    const std::string shown = folder_ / "shown.fs";
    test::writeBytes(shown, "/*{\"INPUTS\": [{\"NAME\": \"inputImage\", \"TYPE\": \"image\"}]}*/\n"
                            "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }\n");
    render("shown.png", {"--set", "file=" + shown, "--set", "inputImageSource=Torus to Mug"});
    const Ended own = test::vitrine(
        {"render", "sdf_morph", "--alone", "--size", "8x8", "--samples", "1", "--out", folder_ / "own.png"});
    EXPECT_EQ(own.code, 0) << own.err;
    EXPECT_NEAR(codes("shown.png")[0], codes("own.png")[0], 1);
    EXPECT_NEAR(codes("shown.png")[1], codes("own.png")[1], 1);
    for (const char* source : {"nothing", "Your Shader", "sdf_morph"}) {
        const Ended refused = test::vitrine({"render", "your_shader", "--alone", "--set", "file=" + shown, "--set",
                                             std::string("inputImageSource=") + source, "--out", folder_ / "no.png"});
        EXPECT_EQ(refused.code, 2);
        test::expectOneSentence(refused, {"inputImageSource", source, "hall from here", "Torus to Mug"});
    }
}

TEST_F(OwnShader, IsExportedWithoutThePicturesOfTheMuseum)
{
    const std::string shown = folder_ / "shown.fs";
    test::writeBytes(shown, "/*{\"INPUTS\": [{\"NAME\": \"inputImage\", \"TYPE\": \"image\"}]}*/\n"
                            "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }\n");
    const Ended exported =
        test::vitrine({"shader", "export", shown, "--set", "inputImageSource=Noise", "--out", folder_ / "shown.html"});
    EXPECT_EQ(exported.code, 0);
    EXPECT_NE(exported.err.find("“inputImage” shows a picture that only the museum has; the exported shader begins "
                                "without it."),
              std::string::npos)
        << exported.err;
}

TEST_F(OwnShader, IsPressedInTheStepThatIsSet)
{
    const std::string counts = folder_ / "counts.fs";
    test::writeBytes(counts, "/*{\"INPUTS\": [{\"NAME\": \"flash\", \"TYPE\": \"event\"}], \"PASSES\": [{\"TARGET\": "
                             "\"sum\", \"PERSISTENT\": true, \"FLOAT\": true}, {}]}*/\n"
                             "void main() { gl_FragColor = IMG_THIS_PIXEL(sum) + (PASSINDEX == 0 && flash ? 0.2 : "
                             "0.0); }\n");
    for (const auto& [pressed, code] : {std::pair("-1", 0), std::pair("0.1", 51), std::pair("0.3", 0)}) {
        render("counts.png",
               {"--set", "file=" + counts, "--set", "moment=0.2", "--set", std::string("flashAt=") + pressed});
        EXPECT_EQ(codes("counts.png")[0], code) << pressed;
    }
}

}  // namespace
}  // namespace vitrine
