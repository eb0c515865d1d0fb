// Savings by skipped passes, as the frame report states them.

#include "render/plan/step_costs.h"

#include <gtest/gtest.h>

namespace vitrine::render {
namespace {

FrameReport reportOf(const std::vector<std::pair<std::string, double>>& ran, const std::vector<std::string>& skipped)
{
    FrameReport report;
    for (const auto& [name, milliseconds] : ran) report.ran.push_back({.name = name, .milliseconds = milliseconds});
    for (const std::string& name : skipped) report.skipped.push_back({.name = name, .reason = "out of view"});
    return report;
}

TEST(StepCosts, AreThoseOfTheLastFrameInWhichAStepRanAndWasTimed)
{
    StepCosts costs;
    EXPECT_LT(costs.of("fur/coat"), 0);
    costs.note(reportOf({{"fur/coat", 4}, {"tone", 1}}, {}));
    costs.note(reportOf({{"fur/coat", 3}, {"tone", -1}}, {}));
    costs.note(reportOf({}, {"fur/coat"}));
    EXPECT_EQ(costs.of("fur/coat"), 3);
    EXPECT_EQ(costs.of("tone"), 1);
}

TEST(StepCosts, OfAnExhibitAsAWholeAreThoseOfItsPictureInOneFrame)
{
    StepCosts costs;
    costs.note(reportOf({{"fur/shadow", 16}, {"fur/coat", 4}, {"fur/fins", 2}, {"furniture/chair", 32}}, {}));
    EXPECT_EQ(costs.of("fur"), 6) << "its shadow has a line of its own, and so has everybody else";
    // Fins that were switched off before the camera turned away are not saved by turning away.
    costs.note(reportOf({{"fur/coat", 4}}, {"fur/fins"}));
    EXPECT_EQ(costs.of("fur"), 4);
    costs.note(reportOf({{"fur/motion", 8}, {"fur/shadow", 16}}, {"fur"}));
    EXPECT_EQ(costs.of("fur"), 4) << "its motion goes on for the sake of its shadow";
}

TEST(StepCosts, OfAStepThatDrawsSeveralThingsInTurnAreKeptForEach)
{
    StepCosts costs;
    const auto draw = [&](const std::string& variant, double milliseconds) {
        FrameReport report;
        report.ran.push_back({.name = "cone/march", .milliseconds = milliseconds, .variant = variant});
        costs.note(report);
    };
    draw("bars", 2);
    draw("fog", 5);
    draw("bars", 3);
    draw("", 7);
    const std::vector<std::pair<std::string, double>> expected{{"bars", 3}, {"fog", 5}};
    EXPECT_EQ(costs.variantsOf("cone/march"), expected);
    EXPECT_EQ(costs.of("cone/march"), 7);
    EXPECT_TRUE(costs.variantsOf("fur/coat").empty());
    for (int i = 0; i < 1000; ++i) draw(std::to_string(i), 1);
    EXPECT_EQ(costs.variantsOf("cone/march").size(), 64U);
}

}  // namespace
}  // namespace vitrine::render
