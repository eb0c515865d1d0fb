// Comparison of two settings: the differing parameters, the passes and costs of each, and pictures of known difference.

#include "exhibits/compare/comparison.h"
#include "tests/exhibits/study/known_law.h"
#include "tests/support/balls.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::compare {
namespace {

using namespace test;

struct OneOfEach final : Parameters {
    Group group1 = group("All");
    Real angle = real("angle", degrees(30), degree, {0, degrees(90)}, "An angle.");
    Count count = this->Parameters::count("count", 4, {1, 64, logarithmic}, "A number.");
    Toggle lit = toggle("lit", true, "Light.");
    Real glow = real("glow", 0.5, none, {0, 1}, "Of the light.", when(lit));
    Choice<int> method = choice("method", 0, {"rough", "fair"}, "How.");
    Color color = this->Parameters::color("color", {1, 0.5, 0.25}, "What color.");
    File file = this->Parameters::file("file", "A file.");
};

SceneState stateOf(const Parameters& table)
{
    return {{table.initial()}, {}};
}

std::vector<std::string> namesOf(const std::vector<DifferingParameter>& rows)
{
    std::vector<std::string> names;
    for (const DifferingParameter& row : rows) names.push_back(row.name);
    return names;
}

TEST(DifferingParameters, AreThoseWithAnotherValueAndNoOthers)
{
    const OneOfEach table;
    const SceneState a = stateOf(table);
    EXPECT_TRUE(differingParameters(a, a).empty());
    SceneState b = a;
    b.values[0].set(table.angle, 1.0);
    b.values[0].set(table.lit, false);
    b.values[0].set(table.glow, 0.25);
    const std::vector<DifferingParameter> rows = differingParameters(a, b);
    ASSERT_EQ(namesOf(rows), (std::vector<std::string>{"angle", "lit", "glow"}));
    EXPECT_EQ(rows[0].b, Value(1.0));
    EXPECT_TRUE(rows[2].actsInA);
    EXPECT_FALSE(rows[2].actsInB) << "without light there is no glow";
}

TEST(DifferingParameters, OfTablesThatFilesMadeAreToldByName)
{
    const BallTable two({{"red", 0.5}, {"blue", 2}}), other({{"blue", 2}, {"green", 3}});
    const std::vector<DifferingParameter> rows = differingParameters(stateOf(two), stateOf(other));
    ASSERT_EQ(namesOf(rows), (std::vector<std::string>{"redRadius", "redRings", "greenRadius", "greenRings"}));
    EXPECT_FALSE(rows[0].b) << "B has no red ball";
    EXPECT_FALSE(rows[2].a) << "A has no green one";
    EXPECT_EQ(rows[2].b, Value(3.0));
}

TEST(DifferingParameters, CopiedOneByOneAreAllGone)
{
    const OneOfEach table;
    SceneState a = stateOf(table), b = a;
    b.values[0].set(table.count, 32);
    b.values[0].set(table.method, 1);
    b.values[0].set(table.color, ColorValue{{0, 1, 0}});
    b.values[0].set(table.file, std::string("a.glb"));
    std::size_t left = differingParameters(a, b).size();
    ASSERT_EQ(left, 4U);
    for (const DifferingParameter& row : differingParameters(a, b)) {
        EXPECT_TRUE(copyParameter(b, a, row.subject, row.name)) << row.name;
        EXPECT_EQ(differingParameters(a, b).size(), --left) << row.name << " alone was to be copied";
    }
    EXPECT_EQ(a, b);
    const BallTable balls({{"red", 0.5}});
    SceneState unlike = stateOf(balls);
    EXPECT_FALSE(copyParameter(a, unlike, 0, "angle")) << "there is no such row";
    EXPECT_EQ(unlike, stateOf(balls));
}

TEST(DifferingParameters, AreShownWithTheirUnits)
{
    const OneOfEach table;
    const ParameterValues values = table.initial();
    const auto shown = [&](std::size_t row) { return valueWithUnit(values.rows()[row], values.row(row)); };
    EXPECT_EQ(shown(table.angle.row), "30°");
    EXPECT_EQ(shown(table.count.row), "4");
    EXPECT_EQ(shown(table.lit.row), "on");
    EXPECT_EQ(shown(table.method.row), "rough");
    EXPECT_EQ(shown(table.file.row), "none");
}

render::FrameReport frameReportOf(std::vector<std::pair<std::string, double>> ran, std::vector<std::string> skipped)
{
    render::FrameReport report;
    for (auto& [name, ms] : ran) report.ran.push_back({name, "in view", render::Work::raster, ms});
    for (std::string& name : skipped) report.skipped.push_back({name, "out of view"});
    return report;
}

TEST(PassCosts, StandSideBySideInTheOrderInWhichTheyRan)
{
    const render::FrameReport a = frameReportOf({{"walls", 2}, {"march", 5}, {"tone", 1}}, {"fur", "rain"});
    const render::FrameReport b =
        frameReportOf({{"walls", 3}, {"fur", 7}, {"glow", 4}, {"tone", 1}}, {"march", "rain"});
    const std::vector<PassCost> costs = passCosts(a, b);
    std::vector<std::string> names;
    for (const PassCost& cost : costs) names.push_back(cost.name);
    EXPECT_EQ(names, (std::vector<std::string>{"walls", "march", "tone", "fur", "glow", "rain"}));
    EXPECT_EQ(costs[0].a.milliseconds, 2);
    EXPECT_EQ(costs[0].b.milliseconds, 3);
    EXPECT_FALSE(costs[0].ranInOnlyOne());
    EXPECT_EQ(costs[1].b.state, PassSide::State::skipped);
    EXPECT_EQ(costs[1].b.why, "out of view");
    EXPECT_TRUE(costs[1].ranInOnlyOne());
    EXPECT_EQ(costs[3].a.state, PassSide::State::skipped);
    EXPECT_EQ(costs[3].b.milliseconds, 7);
    EXPECT_EQ(costs[4].a.state, PassSide::State::absent);
    EXPECT_FALSE(costs[5].ranInOnlyOne()) << "neither ran it";
}

TEST(PassCosts, OfOneNameBelongTogetherOneByOne)
{
    const std::vector<PassCost> costs = passCosts(frameReportOf({{"blur", 1}, {"blur", 2}}, {}),
                                                  frameReportOf({{"blur", 3}, {"blur", 4}, {"blur", 5}}, {}));
    ASSERT_EQ(costs.size(), 3U);
    EXPECT_EQ(costs[1].a.milliseconds, 2);
    EXPECT_EQ(costs[1].b.milliseconds, 4);
    EXPECT_EQ(costs[2].a.state, PassSide::State::absent);
}

TEST(PassCosts, CountersOfTheProgramsStateAreLeftOut)
{
    render::FrameReport a, b;
    a.counters = {{"draws", 3}, {"programs", 40}};
    b.counters = {{"draws", 5}, {"fetches", 9}, {"programs", 41}};
    const std::vector<CounterCost> costs = counterCosts(a, b);
    ASSERT_EQ(costs.size(), 2U);
    EXPECT_EQ(costs[0].name, "draws");
    EXPECT_EQ(costs[0].b, 5);
    EXPECT_FALSE(costs[1].a);
}

/// The exhibit with the known law, approximate in A and exact in B.
struct KnownPair {
    KnownPair()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<KnownExhibit>(sumOfParts()));
        museum = std::make_unique<Museum>(std::move(all));
        const SceneState start = museum->initialSceneState();
        request.settings = {start, start};
        ParameterValues& exact = request.settings[1].values[1];
        exact.set(table.steps, 256);
        exact.set(table.rays, 64);
        exact.set(table.method, 2);
        exact.set(table.shortcut, false);
        request.frame.raster.size = {16, 8};
        request.frame.alone = 1;
        request.frame.time = 1;  // The time sets the difficulty.
        request.samples = {2, 2};
        request.runs = 3;
    }
    ComparisonResult run()
    {
        Comparison comparison(*museum, backend, request);
        double last = 0;
        while (comparison.step()) {
            EXPECT_GE(comparison.progress(), last);
            last = comparison.progress();
        }
        EXPECT_TRUE(comparison.finished());
        EXPECT_EQ(comparison.progress(), 1);
        return comparison.result();
    }
    [[nodiscard]] double lawOf(double (*which)(const KnownLaw&, const KnownTable&, const ParameterValues&),
                               std::size_t side) const
    {
        return which(sumOfParts(), table, request.settings[side].values[1]);
    }

    KnownTable table;
    std::unique_ptr<Museum> museum;
    KnownBackend backend;
    ComparisonRequest request;
};

TEST(Comparison, ShowsTheErrorAndTheWorkThatTheLawSays)
{
    KnownPair pair;
    const ComparisonResult result = pair.run();
    const auto error = [](const KnownLaw& law, const KnownTable& t, const ParameterValues& v) {
        return law.error(t, v, 1);
    };
    const auto cost = [](const KnownLaw& law, const KnownTable& t, const ParameterValues& v) {
        return law.cost(t, v, 1);
    };
    const double distance = std::abs(pair.lawOf(error, 0) - pair.lawOf(error, 1));
    EXPECT_GT(distance, 0.01);
    EXPECT_NEAR(result.errors.at(render::Metric::rmse), distance, 1e-6);
    ASSERT_EQ(result.counters.size(), 2U);  // "passes" and "work".
    EXPECT_EQ(result.counters[1].name, "work");
    EXPECT_EQ(result.counters[1].a, std::llround(1000 * pair.lawOf(cost, 0)));
    EXPECT_EQ(result.counters[1].b, std::llround(1000 * pair.lawOf(cost, 1)));
    ASSERT_TRUE(result.sides[1].time);
    EXPECT_EQ(result.sides[1].time->runs, 3U);
    EXPECT_NEAR(result.sides[1].time->median, pair.lawOf(cost, 1), 1e-3);
    EXPECT_EQ(namesOf(result.rows), (std::vector<std::string>{"steps", "rays", "method", "shortcut"}));
    EXPECT_EQ(result.sides[0].picture.channels, 4);
}

TEST(Comparison, OfEqualSettingsFindsNothing)
{
    KnownPair pair;
    pair.request.settings[1] = pair.request.settings[0];
    const ComparisonResult result = pair.run();
    EXPECT_TRUE(result.rows.empty());
    EXPECT_EQ(result.errors.at(render::Metric::flip), 0);
    EXPECT_EQ(result.errors.at(render::Metric::max), 0);
    EXPECT_EQ(result.sides[0].picture.pixels, result.sides[1].picture.pixels);
}

TEST(Comparison, DrawsWhatItWasAskedForAndNoMore)
{
    KnownPair pair;
    (void)pair.run();
    EXPECT_EQ(pair.backend.drawn, 2 * 2 + 2 * (1 + 3))
        << "samples of both, then a first and three timed frames of both";
    EXPECT_EQ(pair.backend.provisional, 0);
    KnownPair untimed;
    untimed.request.runs = 0;
    EXPECT_FALSE(untimed.run().sides[0].time);
    EXPECT_EQ(untimed.backend.drawn, 2 * 2);
}

TEST(Comparison, TimesAllTilesOfAFrame)
{
    KnownPair pair;  // Each draw costs what the law says, whatever its size, so two tiles cost twice as much.
    pair.request.largestTile = 8;
    const ComparisonResult result = pair.run();
    const double cost = sumOfParts().cost(pair.table, pair.request.settings[1].values[1], 1);
    ASSERT_TRUE(result.sides[1].time);
    EXPECT_NEAR(result.sides[1].time->median, 2 * cost, 2e-3);
    EXPECT_EQ(result.counters[1].b, 2 * std::llround(1000 * cost));
}

}  // namespace
}  // namespace vitrine::compare
