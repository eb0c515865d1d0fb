// Comparison of studies: possible costs, and results at equal cost and equal error.

#include "exhibits/study/study_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::study {
namespace {

/// Returns a study whose points have these costs and errors. Costs are evaluations of one view of 10 x 10 pixels, with
/// a millisecond for each thousand.
KeptStudy studyOf(const std::vector<std::pair<double, double>>& costsAndErrors)
{
    KeptStudy study;
    study.exhibit = "known";
    study.parameters = {{"steps", "", ""}};
    study.size = {10, 10};
    study.views = {"front"};
    study.cost = "evaluations";
    study.clock = "GPU";
    study.clockTrusted = true;
    study.renderer = "llvmpipe";
    study.processors = 2;
    for (const auto& [cost, error] : costsAndErrors) {
        KeptPoint point;
        point.values = {cost};
        point.cost = cost;
        point.error = error;
        point.lowestError = error / 2;
        point.worstError = error * 2;
        point.counters = {{"evaluations", cost}, {"passes", 3.0}, {"fetches", 7.0}};
        point.time = KeptPoint::Time{cost / 1000, 0.1, {cost / 1100, cost / 900, 0.95}, 7};
        study.points.push_back(point);
    }
    return study;
}

TEST(StudyComparison, TimesAreComparedOnOneMachineAtOneSizeByOneClockOnly)
{
    const KeptStudy a = studyOf({{100, 0.1}, {200, 0.05}});
    EXPECT_EQ(timesDiffer({a, a}), TimesDiffer::no);
    const auto with = [&](const auto& change) {
        KeptStudy b = a;
        change(b);
        return timesDiffer({a, b});
    };
    EXPECT_EQ(with([](KeptStudy& s) { s.renderer = "a graphics card"; }), TimesDiffer::machine);
    EXPECT_EQ(with([](KeptStudy& s) { s.processors = 64; }), TimesDiffer::machine);
    EXPECT_EQ(with([](KeptStudy& s) { s.renderer.clear(); }), TimesDiffer::unknownMachine);
    EXPECT_EQ(with([](KeptStudy& s) { s.size = {20, 10}; }), TimesDiffer::size);
    EXPECT_EQ(with([](KeptStudy& s) { s.alone = true; }), TimesDiffer::surroundings);
    EXPECT_EQ(with([](KeptStudy& s) { s.clock = "CPU"; }), TimesDiffer::clock);
    EXPECT_EQ(with([](KeptStudy& s) { s.clockTrusted = false; }), TimesDiffer::clock);
    EXPECT_EQ(with([](KeptStudy& s) { s.points[1].time.reset(); }), TimesDiffer::notTaken);
}

TEST(StudyComparison, OffersCountedWorkEverywhereAndTimesWhereTheyMayBeCompared)
{
    const KeptStudy a = studyOf({{100, 0.1}, {200, 0.05}});
    // Neither the number of passes, nor a count that is equal for all settings.
    EXPECT_EQ(sharedCosts({a, a}), (std::vector<std::string>{"ms", "evaluations"}));
    KeptStudy b = a;
    b.clockTrusted = false;  // Times are then possible, but not preferred.
    EXPECT_EQ(sharedCosts({b, b}), (std::vector<std::string>{"evaluations", "ms"}));
    b.renderer = "a graphics card";
    EXPECT_EQ(sharedCosts({a, b}), std::vector<std::string>{"evaluations"});
    for (KeptPoint& point : b.points) point.counters.erase("evaluations");
    EXPECT_TRUE(sharedCosts({a, b}).empty());
}

TEST(StudyComparison, CountsArePerPixelSoThatSizesDoNotMatter)
{
    const KeptStudy a = studyOf({{1000, 0.1}, {2000, 0.05}});
    KeptStudy b = studyOf({{8000, 0.1}, {16000, 0.05}});
    b.size = {20, 20};
    b.views = {"front", "side"};
    const StudyComparison comparison = compareStudies({a, b}, {"A", "B"}, "evaluations");
    EXPECT_DOUBLE_EQ(comparison.curves[0].points[0].cost, 10);
    EXPECT_DOUBLE_EQ(comparison.curves[1].points[0].cost, 10);
    ASSERT_EQ(comparison.differences.size(), 2U);
    for (const StudyDifference& each : comparison.differences) {
        EXPECT_DOUBLE_EQ(*each.errorAtCost, each.error);
        EXPECT_DOUBLE_EQ(*each.costAtError, each.cost);
        EXPECT_EQ(each.costRatio->confidence, 1) << "work is counted";
    }
}

TEST(StudyComparison, BetweenTwoSettingsIsTheirPowerLawAndBeyondTheEndsNothing)
{
    // B has errors of 1 / cost from 100 to 10000.
    const KeptStudy b = studyOf({{100, 0.1}, {10000, 0.001}, {5000, 0.2}});
    const KeptStudy a = studyOf({{50, 0.3}, {1000, 0.05}, {20000, 0.0001}});
    const StudyComparison comparison = compareStudies({a, b}, {"A", "B"}, "evaluations");
    EXPECT_FALSE(comparison.curves[1].points[1].onFront) << "what is dearer and worse";
    ASSERT_EQ(comparison.differences.size(), 3U);
    const StudyDifference& cheap = comparison.differences[0];
    EXPECT_FALSE(cheap.errorAtCost) << "B measured nothing so cheap";
    EXPECT_DOUBLE_EQ(*cheap.costAtError, 1) << "its cheapest is good enough";
    const StudyDifference& middle = comparison.differences[1];
    EXPECT_NEAR(*middle.errorAtCost, 0.01, 1e-12);
    EXPECT_NEAR(*middle.costAtError, 2, 1e-9);
    const StudyDifference& dear = comparison.differences[2];
    EXPECT_DOUBLE_EQ(*dear.errorAtCost, 0.001) << "its most exact one is within that cost";
    EXPECT_FALSE(dear.costAtError) << "B measured nothing so exact";
}

TEST(StudyComparison, AnExactSettingHasNoLogarithm)
{
    const KeptStudy b = studyOf({{100, 0.1}, {1000, 0}});
    const KeptStudy a = studyOf({{400, 0.05}, {2000, 0}});
    const StudyComparison comparison = compareStudies({a, b}, {"A", "B"}, "evaluations");
    EXPECT_DOUBLE_EQ(*comparison.differences[0].errorAtCost, 0.1) << "the better one that is within the cost";
    EXPECT_DOUBLE_EQ(*comparison.differences[0].costAtError, 10) << "only the exact one is good enough";
    EXPECT_DOUBLE_EQ(*comparison.differences[1].errorAtCost, 0);
    EXPECT_DOUBLE_EQ(*comparison.differences[1].costAtError, 10);
}

TEST(StudyComparison, TimesSayHowSureTheyAre)
{
    const KeptStudy a = studyOf({{1000, 0.1}}), b = studyOf({{3000, 0.1}});
    const StudyComparison comparison = compareStudies({a, b}, {"A", "B"}, "ms");
    ASSERT_EQ(comparison.differences.size(), 1U);
    const render::Interval& ratio = *comparison.differences[0].costRatio;
    EXPECT_NEAR(ratio.confidence, 0.9, 1e-12) << "both hold together with at least 90 %";
    EXPECT_NEAR(ratio.low, 3000.0 / 1100 / (1000.0 / 900), 1e-9);
    EXPECT_NEAR(ratio.high, 3000.0 / 900 / (1000.0 / 1100), 1e-9);
    EXPECT_LT(ratio.low, 3);
    EXPECT_GT(ratio.high, 3);
}

TEST(StudyComparison, AnotherMetricIsLeftOutAndUncertainErrorsAreMarked)
{
    KeptStudy a = studyOf({{1000, 0.1}, {2000, 0.01}}), b = a, c = a;
    b.metric = render::Metric::flip;
    c.points[1].uncertain = true;
    const StudyComparison comparison = compareStudies({a, b, c}, {"A", "B", "C"}, "evaluations");
    EXPECT_TRUE(comparison.curves[1].leftOut);
    EXPECT_TRUE(comparison.curves[1].points.empty());
    ASSERT_EQ(comparison.differences.size(), 2U);
    EXPECT_EQ(comparison.differences[0].study, 2U);
    EXPECT_FALSE(comparison.differences[0].uncertain);
    EXPECT_TRUE(comparison.differences[1].uncertain);
    const render::Json json = comparisonJson({a, b, c}, comparison);
    EXPECT_TRUE(json["studies"][1]["leftOut"].get<bool>());
    EXPECT_NO_THROW((void)render::writeJson(json));
    EXPECT_NE(comparisonCsv(comparison).find("\nA,C,steps 1000,10,"), std::string::npos) << comparisonCsv(comparison);
}

TEST(StudyComparison, LabelsTellThemApart)
{
    KeptStudy a = studyOf({{1, 1}}), b = a, c = a;
    a.name = "Mine";
    b.measured = "2026-11-25T01:43:23";
    c.measured = "2026-11-26T01:43:23";
    EXPECT_EQ(labelsOf({a, b}), (std::vector<std::string>{"Mine", "known · steps"}));
    EXPECT_EQ(labelsOf({b, c}),
              (std::vector<std::string>{"known · steps · 2026-11-25 01:43:23", "known · steps · 2026-11-26 01:43:23"}));
    EXPECT_EQ(labelsOf({a, a}), (std::vector<std::string>{"Mine (1)", "Mine (2)"}));
}

}  // namespace
}  // namespace vitrine::study
