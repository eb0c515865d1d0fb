// Costs of a study on both axes, and the sentences on them.

#include "exhibits/study/study_costs.h"
#include "exhibits/study/study_text.h"
#include "tests/exhibits/study/known_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::study {
namespace {

using namespace test;

/// Study of "steps" of an exhibit with a known law, step by step.
class StudyOfSteps {
public:
    StudyOfSteps()
    {
        request_.sceneState = museum_.initialSceneState();
        request_.size = {8, 4};
        request_.runs = 7;
        const std::size_t row = *table_.find("steps");
        request_.axes = {*studyAxis(request_.sceneState, 1, row, 4)};
        study_ = std::make_unique<Study>(museum_, backend_, request_);
    }
    [[nodiscard]] Study& study() { return *study_; }
    [[nodiscard]] const StudyResult& result() const { return study_->result(); }
    [[nodiscard]] const StudyRequest& request() const { return request_; }
    [[nodiscard]] const Museum& museum() const { return museum_; }
    void finish()
    {
        while (study_->step()) {
        }
    }

private:
    static std::vector<std::unique_ptr<Exhibit>> exhibits()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<KnownExhibit>(test::sumOfParts()));
        return all;
    }

    KnownTable table_;
    Museum museum_{exhibits()};
    KnownBackend backend_;
    StudyRequest request_;
    std::unique_ptr<Study> study_;
};

TEST(StudyCosts, TimeIsTheAxisOfATrustedClockAlone)
{
    EXPECT_EQ(usualCostAxis(true), CostAxis::time);
    EXPECT_EQ(usualCostAxis(false), CostAxis::work);
}

TEST(StudyCosts, TheClockIsKnownBeforeTheFirstSettingIsDrawn)
{
    StudyOfSteps steps;
    const auto anyDrawn = [&] {
        return std::any_of(steps.result().points.begin(), steps.result().points.end(), [](const StudyPoint& point) {
            return std::any_of(point.shots.begin(), point.shots.end(),
                               [](const StudyShot& shot) { return !shot.picture.empty(); });
        });
    };
    while (steps.result().clock.empty() && steps.study().step()) ASSERT_FALSE(anyDrawn());
    EXPECT_EQ(steps.result().clock, "the law");
    EXPECT_TRUE(steps.result().clockTrusted);
}

TEST(StudyCosts, WorkHasOneNameFromThenOnThatAllSettingsAreDrawn)
{
    StudyOfSteps steps;
    std::vector<std::string> names;
    bool timed = false, someTimed = false;
    while (steps.study().step()) {
        const StudyResult& result = steps.result();
        const auto known = std::count_if(result.points.begin(), result.points.end(),
                                         [](const StudyPoint& point) { return point.time.has_value(); });
        someTimed = someTimed || (known > 0 && known < static_cast<std::ptrdiff_t>(result.points.size()));
        const bool all = std::all_of(result.points.begin(), result.points.end(), isDrawn);
        ASSERT_TRUE(all || result.workName.empty());
        if (names.empty() || names.back() != result.workName) names.push_back(result.workName);
        // No setting is on the time axis before it was timed, and none leaves it afterwards.
        const StudyCosts costs = costsAlong(CostAxis::time, steps.request(), result);
        EXPECT_EQ(costs.name, "ms");
        for (std::size_t i = 0; i < result.points.size(); ++i) {
            EXPECT_EQ(costs.settings[i].cost > 0, result.points[i].time.has_value());
            timed = timed || result.points[i].time;
        }
    }
    EXPECT_TRUE(timed);
    EXPECT_TRUE(someTimed) << "a setting has its time with its first run, not with the last of all";
    EXPECT_EQ(names, (std::vector<std::string>{"", "work"}));
}

TEST(StudyCosts, AreWhatTheLawSaysAlongBothAxes)
{
    StudyOfSteps steps;
    steps.finish();
    const StudyResult& result = steps.result();
    const StudyCosts time = costsAlong(CostAxis::time, steps.request(), result);
    const StudyCosts work = costsAlong(CostAxis::work, steps.request(), result);
    ASSERT_EQ(result.views.size(), 3U);
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        // A frame takes a millisecond per thousand of work. The cost of a setting is the mean over its views, its work
        // is their sum.
        EXPECT_NEAR(time.settings[i].cost, work.settings[i].cost / 3000, 1e-9);
        EXPECT_TRUE(time.settings[i].interval.holds(time.settings[i].cost));
        EXPECT_GT(time.settings[i].interval.confidence, 0.95);
        EXPECT_EQ(work.settings[i].interval.low, work.settings[i].interval.high);
    }
    // More steps have more cost and less error: all are on both fronts.
    EXPECT_EQ(time.front.size(), result.points.size());
    EXPECT_EQ(work.front, time.front);
    EXPECT_EQ(work.name, "work");
}

TEST(StudyCosts, AStudyThatWasKeptHasThoseOfTheOneThatWasMeasured)
{
    StudyOfSteps steps;
    steps.finish();
    const render::Json json = studyJson(steps.museum().subjects(), steps.request(), steps.result(),
                                        {{"renderer", "the painter"}, {"processors", 2}});
    const KeptStudy kept = parseStudy(render::parseJson(render::writeJson(json), "study.json", studyLimits));
    for (const CostAxis axis : {CostAxis::time, CostAxis::work}) {
        const StudyCosts measured = costsAlong(axis, steps.request(), steps.result());
        const StudyCosts read = costsAlong(axis, kept);
        EXPECT_EQ(read.name, measured.name);
        EXPECT_EQ(read.front, measured.front);
        EXPECT_EQ(read.knee, measured.knee);
        EXPECT_EQ(lawSentence(read), lawSentence(measured));
        for (std::size_t i = 0; i < measured.settings.size(); ++i)
            EXPECT_EQ(read.settings[i].cost, measured.settings[i].cost);
    }
    for (std::size_t i = 0; i < kept.points.size(); ++i) {
        ASSERT_TRUE(kept.points[i].modelError);
        EXPECT_EQ(*kept.points[i].modelError, *steps.result().points[i].modelError);
        const std::vector<SettingPart> parts = kept.settingParts(i);
        ASSERT_EQ(parts.size(), 1U);
        EXPECT_EQ(parts[0].label, "Steps");
    }
}

TEST(StudyCosts, WhatIsNotMeasuredAgainstEverythingExactHasNoSuchError)
{
    StudyOfSteps steps;
    bool before = false;
    while (steps.study().step()) {
        for (const StudyPoint& point : steps.result().points)
            for (const StudyShot& shot : point.shots) before = before || (!shot.picture.empty() && !shot.modelError);
        // Unknown values are not 0.
        for (const StudyPoint& point : steps.result().points) ASSERT_TRUE(!point.modelError || *point.modelError > 0);
    }
    EXPECT_TRUE(before);
    for (const StudyPoint& point : steps.result().points) EXPECT_TRUE(point.modelError);
}

TEST(StudyCosts, TheMostTellingCounterIsWorkAndNotHowAPictureIsCut)
{
    using Counters = std::map<std::string, double>;
    EXPECT_EQ(mostTellingCounter({}), "");
    EXPECT_EQ(mostTellingCounter({Counters{{"passes", 1}, {"draws", 1}}, Counters{{"passes", 9}, {"draws", 9}}}), "");
    EXPECT_EQ(mostTellingCounter(
                  {Counters{{"shells", 48}, {"evaluations", 100}}, Counters{{"shells", 768}, {"evaluations", 200}}}),
              "evaluations");
    // With sixteen times the layers there are only a few more visible samples. The layers measure the work.
    EXPECT_EQ(mostTellingCounter(
                  {Counters{{"shells", 48}, {"samples", 118'971}}, Counters{{"shells", 768}, {"samples", 139'137}}}),
              "shells");
}

TEST(StudyCosts, ALawWhoseIntervalSaysNothingIsNotTold)
{
    StudyCosts costs;
    costs.name = "evaluations";
    EXPECT_EQ(lawSentence(costs), "");
    // Numbers of a real report: a factor of 1.44, from 0.169 to 12.2.
    costs.law = render::PowerLaw{.slope = -0.526, .slopeInterval = {-3.61, 2.565, 0.95}, .points = 3};
    EXPECT_EQ(lawSentence(costs).find("1.44"), std::string::npos) << lawSentence(costs);
    EXPECT_NE(lawSentence(costs).find("measure more values"), std::string::npos) << lawSentence(costs);
    const double infinite = std::numeric_limits<double>::infinity();
    costs.law->slopeInterval = {-infinite, infinite, 0.95};
    EXPECT_EQ(lawSentence(costs).find("inf"), std::string::npos) << lawSentence(costs);
    // Intervals with a factor of 3.9 between their ends are reported, 4.1 are not.
    for (const auto& [factor, told] : {std::pair(3.9, true), std::pair(4.1, false)}) {
        costs.law->slopeInterval = {-0.5, -0.5 + std::log2(factor), 0.95};
        EXPECT_EQ(lawSentence(costs).find("times the field evaluations") != std::string::npos, told) << factor;
    }
}

}  // namespace
}  // namespace vitrine::study
