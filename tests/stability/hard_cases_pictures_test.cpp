// Stability cases that need a picture: histories, accumulators, very wide windows, invalid models of visitors.

#include "exhibits/hall/hall_model.h"
#include "shaders/lib/bindings.glsl"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using namespace test;

class HardCases : public test::GlTest {};

/// Draws sample `i` of `n` of a shot, like the window: "frame" is the mean of the samples so far.
render::Image sample(const Shot& shot, int i, int n)
{
    FrameRequest frame = shot.request.frame;
    frame.sample = i;
    frame.samples = n;
    (void)gallery().renderer.draw(
        test::planned(gallery().museum, shot.sceneState, frame, gallery().renderer.persistentState()));
    return gallery().renderer.read("frame");
}

/// Returns a plan of the museum whose last pass sets all of "frame" to NaN.
render::FramePlan spoiled(const Shot& shot, int i, int n)
{
    FrameRequest frame = shot.request.frame;
    frame.sample = i;
    frame.samples = n;
    render::FramePlan plan =
        test::planned(gallery().museum, shot.sceneState, frame, gallery().renderer.persistentState());
    render::Pass spoil;
    spoil.name = "spoil";
    spoil.phase = render::PassPhase::present;
    spoil.shader = {"kit/depth.vert", "kit/depth.frag", "", {}};
    spoil.colors = {{"frame", render::Load::clear, glm::vec4(std::numeric_limits<float>::quiet_NaN()), -1, 0}};
    plan.add(std::move(spoil));
    return plan;
}

using LongHardCases = HardCases;

TEST_F(HardCases, ASampleThatIsNaNIsGoneWithTheNextPicture)
{
    Shot shot;
    const render::Image clean = sample(shot, 0, 4);
    (void)gallery().renderer.draw(spoiled(shot, 1, 4));
    // A mean that goes on keeps NaN.
    EXPECT_NE(test::notFinite(sample(shot, 2, 4), 4), "");
    EXPECT_NE(test::notFinite(sample(shot, 3, 4), 4), "");
    EXPECT_EQ(test::largestDifference(sample(shot, 0, 4), clean), 0);
}

TEST_F(HardCases, AfterACutNothingOfTheOldViewRemains)
{
    Shot before;
    before.request.frame.transparent = false;
    Shot after = before;
    after.see({-1.2, 0.3, -0.9}, {0, 0, 0});
    const render::Image fresh = sample(after, 0, 8);
    for (int i = 0; i < 4; ++i) (void)sample(before, i, 8);
    // A mean that goes on shows a ghost of the old view.
    EXPECT_GT(test::largestDifference(sample(after, 4, 8), fresh), 0.05);
    for (int i = 0; i < 4; ++i) (void)sample(before, i, 8);
    EXPECT_EQ(test::largestDifference(sample(after, 0, 8), fresh), 0);
}

TEST_F(HardCases, APictureWiderThanAnyTextureIsDrawnInTiles)
{
    Shot shot;
    shot.values().set(sdfTable().conePrepass, false);
    shot.size(20000, 2);
    ASSERT_GT(20000, gallery().renderer.largestSide());  // Too wide to be drawn in one piece.
    const Picture wide = shot.take();
    EXPECT_EQ(wide.width(), 20000);
    EXPECT_EQ(test::notFinite(wide.image, 4), "");
    shot.request.largestTile = 1000;
    EXPECT_EQ(test::largestDifference(shot.take().image, wide.image), 0);
    EXPECT_GT(wide.hits(), 0);
}

TEST_F(HardCases, FourThousandSamplesOfOneAverageToOne)
{
    constexpr int samples = 4096;
    render::FramePlan plan;
    plan.view = render::makeView({}, {.size = {1, 1}});
    plan.image({.name = "one", .format = render::Format::rgba16f});
    plan.image({.name = "sum", .format = render::Format::r16f});
    plan.image({.name = "mean", .format = render::Format::rgba32f});
    const auto pass = [](std::string name, const char* target) {
        render::Pass p;
        p.name = std::move(name);
        p.shader = {"lib/fullscreen.vert", "lib/copy.frag", "", {}};
        p.colors = {{target, render::Load::keep, {}, -1, 0}};
        p.inputs = {{UNIT_SOURCE, std::string("one")}};
        p.draws = {render::Draw{}};
        return p;
    };
    for (const auto& [image, value] : {std::pair("one", 1.0F), std::pair("sum", 0.0F), std::pair("mean", 0.0F)}) {
        render::Pass clear = pass(std::string("clear ") + image, image);
        clear.shader = {"kit/depth.vert", "kit/depth.frag", "", {}};
        clear.colors[0] = {image, render::Load::clear, glm::vec4(value), -1, 0};
        clear.inputs.clear();
        clear.draws.clear();
        plan.add(std::move(clear));
    }
    for (int i = 0; i < samples; ++i) {
        render::Pass add = pass("add " + std::to_string(i), "sum");
        add.state.blend = render::Blend::add;
        plan.add(std::move(add));
        render::Pass average = pass("average " + std::to_string(i), "mean");
        average.state.blend = render::Blend::mean;
        average.state.meanWeight = 1.0F / static_cast<float>(i + 1);
        plan.add(std::move(average));
    }
    (void)gallery().renderer.draw(plan);
    EXPECT_EQ(gallery().renderer.read("sum").at(0, 0, 0), 2048);  // One more would be lost in rounding.
    EXPECT_NEAR(gallery().renderer.read("mean").at(0, 0, 0), 1, 1e-6);

    // The museum's mean is of this kind, in display and linear light.
    for (const AverageIn in : {AverageIn::display, AverageIn::radiance}) {
        Shot shot;
        shot.request.frame.averageIn = in;
        shot.request.frame.samples = samples;
        shot.request.frame.sample = 1;
        EXPECT_EQ(test::planned(gallery().museum, shot.sceneState, shot.request.frame).images().at("frame").format,
                  render::Format::rgba32f);
    }
}

/// Draws the visitor's plinth with this file on it, from the front.
Picture visitorsModel(const std::string& glb, AverageIn in = AverageIn::radiance)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "model.glb", glb);
    Shot shot;
    shot.inHall();
    shot.request.frame.subject.reset();
    shot.request.frame.averageIn = in;
    shot.hall().set(hallTable().objects.front().model, (folder / "model.glb").string());
    const hall::HallModel building;
    const glm::dmat4 place = building.place(hall::freePlinthPlace)->worldFromPlace;
    shot.see(glm::dvec3(place * glm::dvec4(0.3, 0.7, 2, 1)), glm::dvec3(place * glm::dvec4(0, 0.3, 0, 1)));
    shot.size(64, 48);
    Picture picture = shot.take();
    // Drawn once more without the file, so that no other test finds it in the hall's cache.
    shot.hall().set(hallTable().objects.front().model, std::string());
    (void)shot.take();
    return picture;
}

/// Returns a quad of 1 m that faces +z, with this normal at every corner.
test::GltfBuilder quad(float nx, float ny, float nz)
{
    test::GltfBuilder builder;
    const int positions = builder.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const int normals = builder.floats({nx, ny, nz, nx, ny, nz, nx, ny, nz, nx, ny, nz}, "VEC3");
    const int corners = builder.indices({0, 1, 2, 0, 2, 3});
    builder.json["meshes"].push_back(
        {{"primitives", render::Json::array({{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                              {"indices", corners},
                                              {"material", 0}}})}});
    builder.json["materials"] = render::Json::parse(
        R"([{"name": "chalk", "doubleSided": true, "pbrMetallicRoughness": {"metallicFactor": 0}}])");
    return builder;
}

int whitePixels(const Picture& p)
{
    int count = 0;
    p.each([&](int x, int y) { count += p.luminance(x, y) > 0.95; });
    return count;
}

TEST_F(LongHardCases, NormalsWithoutLengthInAVisitorsFileLeaveNumbersInThePicture)
{
    // Normalizing these normals would give NaN.
    const auto lit = [](float x, float y, float z) {
        test::GltfBuilder builder = quad(x, y, z);
        builder.node({{"name", "quad"}, {"mesh", 0}});
        return visitorsModel(builder.glb());
    };
    const Picture good = lit(0, 0, 1);
    for (const Picture& p : {lit(0, 0, 0), lit(1e-30F, 0, 0), lit(3e38F, 3e38F, 0)}) {
        EXPECT_EQ(test::notFinite(p.image, 4), "");
        p.each([&](int x, int y) {
            EXPECT_EQ(p.depth(x, y), good.depth(x, y)) << "it is not where it was";
            if (!p.hit(x, y)) return;
            EXPECT_NEAR(glm::length(p.normal(x, y)), 1, 1e-3) << x << ',' << y;  // Fails for NaN.
        });
    }
}

TEST_F(LongHardCases, AModelScaledToAPlaneOrALineIsDrawnWithoutNaN)
{
    for (const char* scale : {"[1, 1, 0]", "[1, 0, 1]", "[0, 0, 0]", "[1e-30, 1e-30, 1e-30]", "[1, 1, 1e-40]"}) {
        test::GltfBuilder builder = quad(0, 0, 1);
        builder.node({{"name", "quad"}, {"mesh", 0}});
        builder.node({{"name", "flat"},
                      {"mesh", 0},
                      {"scale", render::Json::parse(scale)},
                      {"translation", render::Json::parse("[0.2, 0.2, 0.3]")}});
        EXPECT_EQ(test::notFinite(visitorsModel(builder.glb()).image, 4), "") << scale;
    }
}

TEST_F(HardCases, LightBeyondHalfFloatsIsWhiteAndNotNaN)
{
    test::GltfBuilder builder = quad(0, 0, 1);
    builder.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
    builder.json["materials"][0]["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 1e6}}}};
    builder.json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    builder.node({{"name", "lamp"}, {"mesh", 0}});
    const Picture p = visitorsModel(builder.glb(), AverageIn::display);
    EXPECT_EQ(test::notFinite(p.image, 4), "");
    EXPECT_GT(whitePixels(p), 100);
}

}  // namespace
}  // namespace vitrine
