// Pictures in motion, averaged over frames: stability, and no smearing.

#include "exhibits/hall/hall_table.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using namespace test;

const hall::HallTable hallParameters;
constexpr int width = 160;
constexpr int height = 24;
constexpr int barWidth = 40;
constexpr int barSpeed = 8;  // Pixels per second.

struct BarTable final : Parameters {
    Real gray = real("gray", 0.2, none, {0, 1}, "Of what is behind the bar.");
};

/// Exhibit with a bright bar that moves to the right over gray waves, one pixel column for each of the picture.
class Bar final : public Exhibit {
public:
    inline static const BarTable table;

    [[nodiscard]] std::string_view name() const override { return "bar"; }
    [[nodiscard]] std::string_view title() const override { return "Bar"; }
    [[nodiscard]] std::string_view summary() const override { return "A bar."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const Parameters& parameters() const override { return table; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return 0; }
    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        render::Pass pass;
        pass.name = "bar/draw";
        pass.reason = "it is in view";
        pass.phase = render::PassPhase::opaque;
        pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = "bar.frag"};
        const std::string text =
            "#include \"lib/frame.glsl\"\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n"
            "    float x = framePixel(gl_FragCoord.xy).x;\n    float from = " +
            std::to_string(barSpeed) + ".0 * frame.time;\n    bool inBar = x > from && x < from + " +
            std::to_string(barWidth) +
            ".0;\n    color = vec4(vec3(inBar ? 4.0 : " + std::to_string(context.values[table.gray]) +
            " + 0.05 * sin(0.4 * x)), 1.0);\n}\n";
        pass.shader.sources =
            std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{{"bar.frag", text}});
        pass.colors = {render::Attachment::whole(radianceImage)};
        pass.draws = {render::Draw{}};
        plan.add(std::move(pass));
    }
};

double levelOf(float linear)
{
    const double x = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

class MovingPictures : public GlTest {
protected:
    MovingPictures()
    {
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<Bar>());
        museum_ = std::make_unique<Museum>(std::move(exhibits));
        sceneState_ = museum_->initialSceneState();
        request_.alone = *museum_->find("bar");
        request_.camera = museum_->bestView(*request_.alone, sceneState_.values[*request_.alone]);
        request_.raster.size = {width, height};
        request_.transparent = true;
        request_.finished = true;
    }
    render::FramePlan planOf(int movingFrame, double time, bool cut = false)
    {
        request_.movingFrame = movingFrame;
        request_.time = time;
        request_.resetHistory = cut;
        return planned(*museum_, sceneState_, request_, renderer_.persistentState());
    }
    render::Image frame(int movingFrame, double time, bool cut = false)
    {
        (void)renderer_.draw(planOf(movingFrame, time, cut));
        return renderer_.read("frame");
    }
    render::Image afterFrames(int count)
    {
        render::Image last;
        for (int i = 1; i <= count; ++i) last = frame(i, i);
        return last;
    }
    void switchOff() { sceneState_.hall().set(hallParameters.temporalAntialiasing, false); }

    render::gl::Renderer& renderer_ = gallery().renderer;
    std::unique_ptr<Museum> museum_;
    SceneState sceneState_;
    FrameRequest request_;
};

TEST_F(MovingPictures, DragNothingAlongBehindWhatMoves)
{
    constexpr int frames = 10;
    const render::Image shown = afterFrames(frames);
    const float share = 1.0F / static_cast<float>(sceneState_.hall()[hallParameters.historyFrames]);
    render::Image truth;
    render::Image mean;  // Mean of the same frames, without rejecting history.
    for (int i = 1; i <= frames; ++i) {
        truth = frame(0, i);
        if (i == 1) mean = truth;
        for (std::size_t p = 0; p < mean.pixels.size(); ++p)
            mean.pixels[p] += (truth.pixels[p] - mean.pixels[p]) * share;
    }
    double smear = 0;
    double smearOfMean = 0;
    const int from = barSpeed * frames;
    for (int x = from - 6 * barSpeed; x < from - 2; ++x) {
        smear = std::max(smear, std::abs(levelOf(shown.at(x, height / 2, 1)) - levelOf(truth.at(x, height / 2, 1))));
        smearOfMean =
            std::max(smearOfMean, std::abs(levelOf(mean.at(x, height / 2, 1)) - levelOf(truth.at(x, height / 2, 1))));
    }
    // Half of the difference at which history is rejected; samples of the waves differ by part of it.
    EXPECT_LE(smear, 8);
    EXPECT_GE(smearOfMean, 40) << "the control: a plain mean would smear";
    for (int x = from + 3; x < from + barWidth - 3; ++x)
        EXPECT_NEAR(levelOf(shown.at(x, height / 2, 1)), levelOf(truth.at(x, height / 2, 1)), 2) << x;
}

TEST_F(MovingPictures, ShowNoGhostAfterACutOrAChangedValue)
{
    constexpr double elsewhere = 2.5;
    (void)afterFrames(9);
    const render::Image kept = frame(10, elsewhere);
    (void)afterFrames(9);
    const render::Image cut = frame(1, elsewhere, true);
    const render::Image rests = frame(0, elsewhere);
    EXPECT_EQ(largestDifference(cut, rests), 0);
    EXPECT_GT(largestDifference(kept, rests), 0.01) << "the control: without the cut, something of before is left";

    (void)afterFrames(9);
    sceneState_.values[*request_.alone].set(Bar::table.gray, 0.5);
    const render::Image changed = frame(1, elsewhere);
    EXPECT_EQ(largestDifference(changed, frame(0, elsewhere)), 0);
}

TEST_F(MovingPictures, AreThoseOfBeforeToTheBitWhenSwitchedOffAndCostNothing)
{
    const render::Image averaged = afterFrames(6);
    switchOff();
    const render::Image off = afterFrames(6);
    const render::FramePlan inMotion = planOf(7, 7);
    const render::FramePlan atRest = planOf(0, 7);
    EXPECT_EQ(toString(inMotion), toString(atRest));
    EXPECT_FALSE(inMotion.find("antialias"));
    ASSERT_TRUE(inMotion.findSkipped("antialias"));
    EXPECT_EQ(inMotion.findSkipped("antialias")->reason, "frames are independent of each other");
    EXPECT_FALSE(inMotion.images().contains("frame history"));
    const render::Image rests = frame(0, 6);
    EXPECT_EQ(largestDifference(off, rests), 0);
    EXPECT_GT(largestDifference(averaged, rests), 0.01) << "the control: switched on, it is another picture";
}

TEST_F(MovingPictures, BeginWithThePictureAtRest)
{
    request_.finished = false;
    constexpr int samples = 4;
    request_.samples = samples;
    const double time = 3;
    render::Image rests;
    for (request_.sample = 0; request_.sample < samples; ++request_.sample) {
        const render::FramePlan plan = planOf(0, time);
        EXPECT_EQ(plan.find("antialias/begin") != nullptr, request_.sample + 1 == samples);
        EXPECT_FALSE(plan.find("antialias"));
        (void)renderer_.draw(plan);
        rests = renderer_.read("frame");
    }
    request_.sample = 0;
    request_.samples = 1;
    const render::Image begun = frame(1, time);
    const render::Image alone = frame(1, time, true);
    // In the mean of five frames, the first moving one has the weight 1/5. At the bar's edges, the rest is the static
    // picture.
    EXPECT_LT(largestDifference(begun, rests), 0.35 * largestDifference(alone, rests));
}

/// Returns a camera rotated to the right about its own vertical axis, by this many pixels in the middle of the picture.
render::Camera turned(const render::Camera& camera, double pixels, int rows)
{
    const double angle = std::atan(2 * std::tan(camera.fovY / 2) / rows) * pixels;
    const glm::dvec3 ahead = camera.target - camera.eye;
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
    render::Camera result = camera;
    result.target = camera.eye + std::cos(angle) * ahead + std::sin(angle) * glm::length(ahead) * right;
    return result;
}

class TurnedByAPixel : public GlTest {
protected:
    static constexpr double mostOfAnExhibit = 2;  ///< Percent of the pixels.

    /// Returns the percentage of pixels in the middle third that differ by more than 16 levels from the frame one pixel
    /// before, shifted back. `scene`: a scene of shapes that the exhibit shows in place of its initial one.
    double shareThatDiffers(const char* subject, bool antialiasing, const std::string& scene = {})
    {
        const Museum& museum = gallery().museum;
        SceneState sceneState = museum.initialSceneState();
        sceneState.hall().set(hallParameters.temporalAntialiasing, antialiasing);
        const std::size_t index = *museum.find(subject);
        if (!scene.empty()) {
            ParameterValues& values = sceneState.values[index];
            values.setParameter(*values.table().find("scene"), scene);
            sceneState = museum.readTables(sceneState).sceneState;
        }
        const render::Camera end = museum.bestView(index, sceneState.values[index]);
        const int frames = antialiasing ? 10 : 2;
        render::Image before;
        render::Image last;
        for (int i = 1; i <= frames; ++i) {
            FrameRequest request;
            request.raster = {.size = {640, 360}, .offset = {200, 0}, .tile = {240, 360}};
            request.camera = turned(end, i - frames, request.raster.size.y);
            request.movingFrame = i;
            request.resetHistory = i == 1;
            request.finished = true;
            (void)gallery().renderer.draw(planned(museum, sceneState, request, gallery().renderer.persistentState()));
            before = std::move(last);
            last = gallery().renderer.read("frame");
        }
        int differ = 0;
        int all = 0;
        for (int y = 0; y < last.height; ++y)
            for (int x = 24; x < last.width - 24; ++x, ++all) {
                double most = 0;
                for (int c = 0; c < 3; ++c)
                    most = std::max(most, std::abs(levelOf(before.at(x + 1, y, c)) - levelOf(last.at(x, y, c))));
                differ += most > 16 ? 1 : 0;
            }
        return 100.0 * differ / all;
    }
};

using LongTurnedByAPixel = TurnedByAPixel;

TEST_F(LongTurnedByAPixel, TheHallStandsStill)
{
    const double share = shareThatDiffers("hall", true);
    RecordProperty("hall", std::to_string(share));
    EXPECT_LE(share, 0.5);
    EXPECT_GT(shareThatDiffers("hall", false), 1.5 * share) << "the control: single frames";
}

TEST_F(TurnedByAPixel, TheFurStandsStill)
{
    EXPECT_LE(shareThatDiffers("fur", true), mostOfAnExhibit);
    EXPECT_GT(shareThatDiffers("fur", false), mostOfAnExhibit) << "the control: single frames";
}

TEST_F(TurnedByAPixel, BeadsAndTheirImagesInCurvedMirrorsStandStillInSingleFrames)
{
    EXPECT_LE(shareThatDiffers("sdf_scenes", false, "mercury.json"), mostOfAnExhibit);
}

/// Takes minutes. The file that --gtest_output=xml writes contains the shares as properties of the test. The fur, which
/// has the finest details, is also in the short suite.
class EveryExhibitTurnedByAPixel : public TurnedByAPixel {};

TEST_F(EveryExhibitTurnedByAPixel, StandsStill)
{
    for (const MuseumExhibit& each : gallery().museum.exhibits()) {
        const std::string subject(each.exhibit.name());
        const double share = shareThatDiffers(subject.c_str(), true);
        RecordProperty(subject, std::to_string(share));
        EXPECT_LE(share, mostOfAnExhibit) << subject;
    }
}

}  // namespace
}  // namespace vitrine
