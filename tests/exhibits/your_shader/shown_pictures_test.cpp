// Inputs of visitors' shaders that show the hall or another exhibit: the same picture as by itself, drawn only if an
// input asks for it and only when it changes.

#include "exhibits/sdf_morph/sdf_morph_table.h"
#include "exhibits/your_shader/your_shader.h"
#include "tests/exhibits/your_shader/shader_shot.h"
#include "tests/exhibits/your_shader/shaders.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace vitrine {
namespace {

using namespace test;

class ShownPictures : public GlTest {
protected:
    /// Shows the picture of an input as it is.
    static void showInput(ShaderShot& own, std::string_view source)
    {
        ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                               "gl_FragColor = IMG_THIS_PIXEL(inputImage);")),
                  "");
        choose(own, source);
    }
    static void choose(ShaderShot& own, std::string_view source)
    {
        own.set("inputImageSource", sourceNamed(own, source));
    }
    /// Returns the index of a source among the choices.
    static double sourceNamed(ShaderShot& own, std::string_view name)
    {
        const auto row = own.shot.values().table().find("inputImageSource");
        const auto& choices = own.shot.values().rows()[row.value()].choices;
        return static_cast<double>(std::find(choices.begin(), choices.end(), name) - choices.begin());
    }
    static constexpr std::string_view file = "file", hall = "hall", torus = "Torus to Mug";

    /// Returns the exhibit's or the hall's own picture, with the settings and the size of the shader's.
    static Picture ownPicture(const ShaderShot& of, const char* name)
    {
        Shot shot(name);
        shot.sceneState = of.shot.sceneState;
        FrameRequest& frame = shot.request.frame;
        frame = of.shot.request.frame;
        const bool isHall = shot.exhibit == hallIndex;
        frame.alone = isHall ? std::nullopt : std::optional(shot.exhibit);
        frame.camera = gallery().museum.subject(shot.exhibit).bestView(shot.values());
        return shot.take();
    }
    /// Returns the largest difference of display values, of 255.
    static int difference(const Picture& a, const Picture& b)
    {
        int most = 0;
        a.each([&](int x, int y) {
            const auto first = ShaderShot::code(a, x, y), second = ShaderShot::code(b, x, y);
            for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(first[c] - second[c]));
        });
        return most;
    }
    static render::FramePlan planOf(const ShaderShot& own)
    {
        render::FramePlan plan = test::planned(gallery().museum, own.shot.sceneState, own.shot.request.frame,
                                               gallery().renderer.persistentState());
        EXPECT_EQ(plan.errors(), std::vector<std::string>());
        return plan;
    }
    /// Counts the passes of the pictures that inputs show.
    static std::size_t shownPasses(const render::FramePlan& plan)
    {
        return static_cast<std::size_t>(
            std::count_if(plan.passes().begin(), plan.passes().end(),
                          [](const render::Pass& pass) { return pass.name.starts_with("your_shader/picture of "); }));
    }
    static double nextOf(const ShaderShot& own)
    {
        return test::nextChange(gallery().museum, own.shot.sceneState, own.shot.request.frame);
    }
};

using LongShownPictures = ShownPictures;

TEST_F(ShownPictures, OfAnotherExhibitAreItsOwnPictures)
{
    ShaderShot own;
    own.shot.size(60, 40);
    showInput(own, torus);
    const Picture first = own.shot.take();
    // The picture goes through 8 bits twice, by the driver's power function.
    EXPECT_LE(difference(first, ownPicture(own, "sdf_morph")), 1);
    // It follows the settings of the exhibit.
    const std::size_t index = gallery().museum.find("sdf_morph").value();
    ParameterValues& values = own.shot.sceneState.values[index];
    values.setParameter(values.table().find("morph").value(), 1.0);
    const Picture mug = own.shot.take();
    EXPECT_GT(difference(first, mug), 50);
    EXPECT_LE(difference(mug, ownPicture(own, "sdf_morph")), 1);
}

TEST_F(LongShownPictures, OfTheHallAreItsFirstView)
{
    ShaderShot own;
    own.shot.size(48, 32);
    showInput(own, hall);
    const Picture shown = own.shot.take();
    // The screen that shows the picture is dark in it.
    ShaderShot dark;
    dark.shot.size(48, 32);
    ASSERT_EQ(dark.show(isf("", "gl_FragColor = vec4(0.0);")), "");
    EXPECT_LE(difference(shown, ownPicture(dark, "hall")), 1);
    const Picture again = own.shot.take();
    EXPECT_EQ(largestDifference(shown.image, again.image), 0);
}

TEST_F(ShownPictures, OfTheHallFromHereAreDarkWhereTheScreenIs)
{
    ShaderShot own;
    own.shot.inHall().size(48, 32);
    showInput(own, "hall from here");
    own.set("screenWidth", 96.0);
    // Halos of the lamp above would reach into the dark.
    own.shot.hall().set(hallTable().glare, 0.0);
    const Picture straight = own.shot.take();
    EXPECT_EQ(ShaderShot::code(straight, 24, 16), (std::array<int, 3>{0, 0, 0})) << "the screen within the screen";
    const Picture again = own.shot.take();
    EXPECT_EQ(largestDifference(straight.image, again.image), 0);
    // From beside, the screen's own picture shows the wall around the dark screen within it.
    const glm::dvec3 eye = own.shot.request.frame.camera.eye, target = own.shot.request.frame.camera.target;
    own.shot.request.frame.camera.eye = target + 1.6 * (eye - target);
    const Picture far = own.shot.take();
    EXPECT_EQ(ShaderShot::code(far, 24, 16), (std::array<int, 3>{0, 0, 0}));
    std::set<std::array<int, 3>> onScreen;
    for (int x = 14; x < 34; ++x)
        for (int y = 8; y < 24; ++y) onScreen.insert(ShaderShot::code(far, x, y));
    EXPECT_GT(onScreen.size(), 4U);
}

TEST_F(LongShownPictures, OutOfTheScreenAreThoseOfACameraThere)
{
    ShaderShot own;
    own.shot.size(48, 32);
    showInput(own, "hall from the screen");
    const Picture alone = own.shot.take();
    Shot out("your_shader");
    out.sceneState = own.shot.sceneState;
    out.request.frame = own.shot.request.frame;
    out.inHall();
    // The screen hangs 2 cm before the wall.
    const glm::dmat4 world = gallery().museum.worldFromExhibit(out.exhibit);
    out.see(glm::dvec3(world * glm::dvec4(0, 0, 0.03, 1)), glm::dvec3(world * glm::dvec4(0, 0, 1.03, 1)));
    out.request.frame.camera.fovY = render::Camera().fovY;
    EXPECT_LE(difference(alone, out.take()), 1);
    std::set<std::array<int, 3>> seen;
    alone.each([&](int x, int y) { seen.insert(ShaderShot::code(alone, x, y)); });
    EXPECT_GT(seen.size(), 100U);
}

TEST_F(ShownPictures, AreDrawnOnlyIfAnInputAsksAndOnlyWhenTheyChange)
{
    ShaderShot own;
    showInput(own, file);
    (void)own.shot.take();
    EXPECT_EQ(shownPasses(planOf(own)), 0U) << "the input shows a file";
    choose(own, torus);
    EXPECT_GT(shownPasses(planOf(own)), 2U);
    (void)own.shot.take();
    const render::FramePlan held = planOf(own);
    EXPECT_EQ(shownPasses(held), 0U);
    const render::CulledPass* skipped = held.findSkipped("your_shader/picture of sdf_morph");
    ASSERT_TRUE(skipped);
    EXPECT_EQ(skipped->reason, "unchanged since it last ran");
    // Another exhibit changes, which the picture does not show.
    const std::size_t fur = gallery().museum.find("fur").value();
    ParameterValues& ofFur = own.shot.sceneState.values[fur];
    ofFur.setParameter(ofFur.table().find("sheen").value(), 1.0);
    EXPECT_EQ(shownPasses(planOf(own)), 0U);
    const std::size_t morph = gallery().museum.find("sdf_morph").value();
    ParameterValues& ofMorph = own.shot.sceneState.values[morph];
    ofMorph.setParameter(ofMorph.table().find("mugRadius").value(), 0.3);
    EXPECT_GT(shownPasses(planOf(own)), 2U);
    // A shader that declares the input and does not read it asks for nothing.
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])", "gl_FragColor = vec4(0.5);")), "");
    choose(own, torus);
    EXPECT_EQ(shownPasses(planOf(own)), 0U);
}

TEST_F(ShownPictures, HaveTheSideThatIsSet)
{
    ShaderShot own;
    ASSERT_EQ(own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                           "gl_FragColor = vec4(IMG_SIZE(inputImage) / 255.0, 0.0, 1.0);")),
              "");
    choose(own, torus);
    own.shot.size(60, 40);
    EXPECT_EQ(own.codeAt(3, 3), (std::array<int, 3>{60, 40, 0}));
    own.set("pictureSide", 30.0);
    EXPECT_EQ(own.codeAt(3, 3), (std::array<int, 3>{30, 20, 0}));
}

TEST_F(ShownPictures, MoveWithTheirExhibits)
{
    ShaderShot own;
    showInput(own, torus);
    const std::size_t morph = gallery().museum.find("sdf_morph").value();
    ParameterValues& values = own.shot.sceneState.values[morph];
    values.setParameter(values.table().find("animate").value(), 0.0);
    EXPECT_EQ(nextOf(own), std::numeric_limits<double>::infinity());
    values.setParameter(values.table().find("animate").value(), 1.0);
    EXPECT_EQ(nextOf(own), 0);
    own.shot.request.frame.time = 0;
    const Picture first = own.shot.take();
    own.shot.request.frame.time = 6;
    const Picture later = own.shot.take();
    EXPECT_GT(difference(first, later), 30);
    EXPECT_LE(difference(later, ownPicture(own, "sdf_morph")), 1);
}

TEST_F(ShownPictures, OfEverySourceHaveCompletePlansAtTinySizes)
{
    ShaderShot own;
    own.shot.size(1, 1);
    showInput(own, file);
    const auto row = own.shot.values().table().find("inputImageSource").value();
    const std::size_t sources = own.shot.values().rows()[row].choices.size();
    EXPECT_EQ(sources, 4 + gallery().museum.exhibits().size() - 1) << "file, three of the hall, and all but itself";
    for (std::size_t source = 1; source < sources; ++source) {
        own.set("inputImageSource", static_cast<double>(source));
        EXPECT_GT(shownPasses(planOf(own)), 0U) << own.shot.values().rows()[row].choices[source];
    }
}

TEST_F(ShownPictures, AreTheSameIfEverythingRuns)
{
    ShaderShot own;
    showInput(own, torus);
    const Picture pruned = own.shot.take();
    own.shot.request.frame.runEverything = true;
    const Picture all = own.shot.take();
    EXPECT_EQ(largestDifference(pruned.image, all.image), 0);
}

TEST_F(ShownPictures, AreSeenByAllStepsOfFeedback)
{
    ShaderShot own;
    own.shot.size(60, 40);
    ASSERT_EQ(
        own.show(isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}],
        "PASSES": [{"TARGET": "sum", "PERSISTENT": true, "FLOAT": true}, {}])",
                     "if (PASSINDEX == 0) gl_FragColor = IMG_THIS_PIXEL(sum) + IMG_THIS_PIXEL(inputImage) / 4.0;\n"
                     "else gl_FragColor = IMG_THIS_PIXEL(sum);")),
        "");
    choose(own, torus);
    own.set("moment", 3 / 60.0);  // Steps 0 to 3.
    EXPECT_LE(difference(own.shot.take(), ownPicture(own, "sdf_morph")), 1);
}

TEST(SourcesOfPictures, AreThoseOfTheMuseum)
{
    std::vector<std::unique_ptr<Exhibit>> exhibits;
    exhibits.push_back(std::make_unique<guest::YourShader>());
    const Museum museum(std::move(exhibits));
    TemporaryFolder folder;
    writeBytes(folder / "own.fs", isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])"));
    SceneState state = museum.initialSceneState();
    ParameterValues& values = state.values[1];
    values.setParameter(values.table().find("file").value(), (folder / "own.fs").string());
    state = museum.readTables(state).sceneState;
    const auto row = state.values[1].table().find("inputImageSource");
    ASSERT_TRUE(row);
    EXPECT_EQ(state.values[1].rows()[*row].choices,
              (std::vector<std::string_view>{"file", "hall", "hall from here", "hall from the screen"}));
}

}  // namespace
}  // namespace vitrine
