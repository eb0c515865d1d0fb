// Parameters added by files, on the command line: `--set`, presets and studies.

#include "app/kit/picture_options.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/study/study.h"
#include "exhibits/study/study_table.h"
#include "render/failure.h"
#include "tests/exhibits/study/known_law.h"
#include "tests/support/balls.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using test::parameterOf;

/// Exhibit with known errors and costs: the more rings a red ball has, the smaller the error of its picture, and the
/// higher the cost.
class KnownBalls final : public test::BallsExhibit {
public:
    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        const auto& table = static_cast<const test::BallTable&>(context.values.table());
        const double rings = context.values[table.rings.at(0)];
        const double numbers[2] = {0.1 / rings, 0};
        render::Pass pass;
        pass.name = "known";
        const std::span<const std::byte> bytes = std::as_bytes(std::span(numbers));
        pass.blocks[0] = render::Bytes(bytes.begin(), bytes.end());
        pass.counts["work"] = std::llround(1000 * rings);
        pass.colors = {{radianceImage, render::Load::keep, {}, -1, 0}};
        plan.add(std::move(pass));
    }
};

class MadeParameters : public testing::Test {
protected:
    MadeParameters() : museum_(exhibits()) { test::writeBalls(folder_ / "two.json", {{"red", 0.5}, {"blue", 2}}); }

    static std::vector<std::unique_ptr<Exhibit>> exhibits()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<KnownBalls>());
        return all;
    }
    [[nodiscard]] std::string file() const { return (folder_ / "two.json").string(); }
    [[nodiscard]] ParameterValues with(const std::vector<std::string>& sets, const std::string& preset = {}) const
    {
        app::PictureOptions options;
        options.subject = "balls";
        options.sets = sets;
        options.preset = preset;
        return app::requestedPicture(museum_, options).sceneState.values[1];
    }

    /// Returns a study of one parameter of the balls of the file.
    [[nodiscard]] study::StudyRequest studyOf(const std::string& parameter) const
    {
        const study::StudyTable& t = study::studyTable();
        ParameterValues values(t);
        values.set(t.varied, parameter);
        values.set(t.width, 16);
        values.set(t.height, 9);
        values.set(t.alone, true);
        values.set(t.modelError, false);
        SceneState state = museum_.initialSceneState();
        std::vector<std::string> notes;
        applySets(museum_, state, 1, {"scene=" + file()}, notes);
        return study::studyRequest(values, museum_, std::move(state), 1);
    }

    test::TemporaryFolder folder_;
    Museum museum_;
};

TEST_F(MadeParameters, AreSetAsAnyOtherWhateverTheOrder)
{
    for (const std::vector<std::string>& sets :
         {std::vector<std::string>{"scene=" + file(), "redRadius=3", "balls.blueRings=16"},
          std::vector<std::string>{"balls.blueRings=16", "redRadius=3", "scene=" + file()}}) {
        const ParameterValues values = with(sets);
        EXPECT_EQ(parameterOf(values, "redRadius"), Value(3.0));
        EXPECT_EQ(parameterOf(values, "blueRings"), Value(16.0));
        EXPECT_EQ(parameterOf(values, "redRings"), Value(8.0));
    }
}

TEST_F(MadeParameters, AreUnknownWithoutTheirFile)
{
    EXPECT_THROW(static_cast<void>(with({"redRadius=3"})), Failure);
    try {
        static_cast<void>(with({"scene=" + (folder_ / "gone.json").string(), "redRadius=3"}));
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("gone.json"), std::string::npos) << failure.what();
    }
}

TEST_F(MadeParameters, ComeFromPresetsToo)
{
    const ParameterValues values = with({"scene=" + file(), "redRadius=3"});
    const std::string preset = (folder_ / "large.json").string();
    std::ofstream(preset) << presetText({"balls", "Large", values, std::nullopt});
    EXPECT_EQ(with({}, preset), values);
    EXPECT_EQ(parameterOf(with({"blueRadius=4"}, preset), "blueRadius"), Value(4.0));
}

TEST_F(MadeParameters, AreStudied)
{
    const study::StudyRequest request = studyOf("redRings");
    EXPECT_EQ(parameterOf(request.sceneState, request.axes.at(0)).name, "redRings");
    test::KnownBackend backend;
    study::Study study(museum_, backend, request);
    while (study.step()) {
    }
    const std::vector<study::StudyPoint>& points = study.result().points;
    ASSERT_GE(points.size(), 4U);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT(points[i].error, points[i - 1].error);
        EXPECT_GT(points[i].cost, points[i - 1].cost);
    }
    EXPECT_EQ(test::parameterOf(study.sceneStateOf(points.front()).values[1], "redRings"),
              Value(request.axes[0].values.front()));
}

TEST_F(MadeParameters, AreNamedWhereAStudyOfAnotherIsAskedFor)
{
    try {
        static_cast<void>(studyOf("redRadius"));
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("give one of redRings, blueRings"), std::string::npos)
            << failure.what();
    }
}

}  // namespace
}  // namespace vitrine
