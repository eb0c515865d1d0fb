// Studies of exhibits with known laws of error and cost.

#include "exhibits/exhibits.h"
#include "exhibits/study/study.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/measure/pareto.h"
#include "tests/exhibits/study/known_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vitrine::study {
namespace {

using namespace test;

struct SceneObject {
    explicit SceneObject(KnownLaw law) : museum(exhibits(std::move(law))) {}

    static std::vector<std::unique_ptr<Exhibit>> exhibits(KnownLaw law)
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<KnownExhibit>(std::move(law)));
        return all;
    }
    [[nodiscard]] StudyRequest request(const std::vector<std::string>& rows, int points = 8) const
    {
        StudyRequest r;
        r.sceneState = museum.initialSceneState();
        for (const std::string& row : rows) r.axes.push_back(*studyAxis(r.sceneState, 1, *table.find(row), points));
        r.size = {16, 9};
        r.alone = true;
        return r;
    }
    StudyResult run(const StudyRequest& r)
    {
        Study study(museum, backend, r);
        while (study.step()) {
            EXPECT_GE(study.progress(), 0);
            EXPECT_LE(study.progress(), 1);
        }
        EXPECT_EQ(study.progress(), 1);
        return study.result();
    }

    KnownTable table;
    Museum museum{allExhibits()};
    KnownBackend backend;
};

double valueOf(const StudyRequest& r, const StudyPoint& p, std::size_t axis = 0)
{
    return r.axes[axis].values[p.setting[axis]];
}

TEST(Study, MeasuresTheErrorAndTheWorkThatTheLawSays)
{
    SceneObject subject(sumOfParts());
    const StudyRequest request = subject.request({"steps"});
    const StudyResult result = subject.run(request);
    ASSERT_EQ(result.views.size(), 3U);
    EXPECT_EQ(result.costName, "work");
    ASSERT_EQ(result.points.size(), request.axes[0].values.size());
    // The views are the first, the middle and the last of five: difficulties 1, 2 and 1.75.
    const double difficulties = 1 + 2 + 1.75;
    const double rms = std::sqrt((1 + 4 + 1.75 * 1.75) / 3);
    for (const StudyPoint& point : result.points) {
        const double steps = valueOf(request, point);
        // Compared with the reference that was used, which may have been doubled.
        EXPECT_NEAR(point.error, rms * std::abs(0.2 / steps - 0.2 / result.exact[0]), 1e-6) << steps;
        EXPECT_NEAR(static_cast<double>(point.counters.at("work")),
                    1000 * difficulties * (1 + 0.1 * steps + 0.3 * 4) * 0.6, 3)
            << steps;
        ASSERT_TRUE(point.time);
        EXPECT_EQ(point.time->runs, 6U) << "their times differ";
        EXPECT_NEAR(point.time->median, difficulties / 3 * (1 + 0.1 * steps + 0.3 * 4) * 0.6, 0.01) << steps;
        EXPECT_EQ(point.counters.count("images"), 0U) << "what the renderer holds is no work";
    }
    EXPECT_EQ(result.clock, "the law");
}

TEST(Study, TimesASettingNoMoreOnceItsRankIsCertain)
{
    KnownLaw law = sumOfParts();
    law.cost = [](const KnownTable& t, const ParameterValues& v, double) { return 1.0 + std::min(v[t.steps], 8); };
    SceneObject subject(law);
    StudyRequest request = subject.request({"steps"});
    request.runs = 12;
    for (const double noise : {0.0, 0.01}) {
        subject.backend.timeNoise = noise;
        for (const StudyPoint& point : subject.run(request).points)
            EXPECT_EQ(point.time->runs, valueOf(request, point) < 8 ? 6U : 12U) << valueOf(request, point);
    }
    // Much noise hides every rank.
    subject.backend.timeNoise = 1.5;
    for (const StudyPoint& point : subject.run(request).points) EXPECT_EQ(point.time->runs, 12U);
}

TEST(Study, TellsNumericalErrorFromModelError)
{
    SceneObject subject(sumOfParts());
    const StudyRequest request = subject.request({"steps"});
    const StudyResult result = subject.run(request);
    const double rms = std::sqrt((1 + 4 + 1.75 * 1.75) / 3);
    for (const StudyPoint& point : result.points) {
        // Errors of the approximate method, few rays and the shortcut, which more steps do not reduce.
        const double others = 0.05 / 2 - 0.05 / 8 + 0.02 + 0.001;
        ASSERT_TRUE(point.modelError);
        EXPECT_NEAR(*point.modelError, rms * std::abs(others + 0.2 / valueOf(request, point) - 0.2 / result.exact[0]),
                    1e-6);
    }
}

TEST(Study, DoublesItsReferenceUntilItNoLongerMatters)
{
    SceneObject subject(sumOfParts());
    StudyRequest request = subject.request({"steps"});
    // Half as exact as 256 steps are 128, with an error of 0.2 / 256. The error of 200 steps is not four times as
    // large.
    request.axes[0].values = {4, 16, 64, 200};
    const StudyResult result = subject.run(request);
    EXPECT_GT(result.exact[0], 256);
    EXPECT_TRUE(result.converged) << result.convergence;
    double smallest = 1;
    for (const StudyPoint& p : result.points) smallest = std::min(smallest, p.error);
    EXPECT_LE(result.uncertainty, smallest / 4);
    EXPECT_NE(result.convergence.find("less than a quarter"), std::string::npos) << result.convergence;
}

TEST(Study, SaysWhichErrorsItsReferenceCannotTell)
{
    SceneObject subject(sumOfParts());
    StudyRequest request = subject.request({"steps"});
    // The legal limit is 1024, so no value is exact enough to measure the error of 1000.
    request.axes[0].values = {4, 1000};
    const StudyResult result = subject.run(request);
    EXPECT_FALSE(result.converged);
    EXPECT_FALSE(result.points[0].uncertain);
    EXPECT_TRUE(result.points[1].uncertain);
    EXPECT_NE(result.convergence.find("uncertain"), std::string::npos) << result.convergence;
}

TEST(Study, SaysThatAReferenceIsExactByMeaningOnlyWhereItsRowSaysSo)
{
    const auto convergence = [](const std::vector<std::string>& rows) {
        SceneObject subject(sumOfParts());
        return subject.run(subject.request(rows));
    };
    const StudyResult shortcut = convergence({"shortcut"});
    EXPECT_EQ(shortcut.convergence, "The reference is exact by the meaning of the parameter.");
    EXPECT_TRUE(shortcut.converged);
    // A choice counts as exact, because there is nothing to compare it with.
    const StudyResult method = convergence({"method"});
    EXPECT_EQ(method.convergence, "What counts as exact is not checked: Method at exact.");
    EXPECT_FALSE(method.converged);
    const StudyResult both = convergence({"method", "steps"});
    EXPECT_NE(both.convergence.find("twice as exact"), std::string::npos) << both.convergence;
    EXPECT_NE(both.convergence.find(" What counts as exact is not checked: Method at exact."), std::string::npos)
        << both.convergence;
    EXPECT_FALSE(both.converged);
    const StudyResult rays = convergence({"rays"});
    EXPECT_EQ(rays.convergence.rfind("With Rays at 32 the reference changes by ", 0), 0U) << rays.convergence;
}

/// Table with parameters whose initial value counts as exact, in the middle of the range and at its end.
struct AtTheirBest final : Parameters {
    Real step = real("step", 0.001, none, {1e-6, 1, logarithmic}, "Too small is as bad as too large.", quality(0.001));
    Count rate = count("rate", 240, {15, 240, logarithmic}, "More is exact.", quality(240));
    Count bounces = count("bounces", 4, {0, 8}, "More is exact.", quality(4));
    Real factor = real("factor", 1, none, {1, 2}, "1 is none.", exactAt(1));
};

TEST(Study, ChecksAReferenceThatIsTheInitialValueOnBothSides)
{
    const AtTheirBest table;
    using Values = std::vector<double>;
    for (const int doublings : {0, 2}) {
        EXPECT_EQ(exactness(table.rows()[table.step.row], doublings).exact, 0.001)
            << "which way is more exact, nobody knows";
        EXPECT_EQ(exactness(table.rows()[table.step.row], doublings).neighbors, (Values{0.0005, 0.002}));
        EXPECT_EQ(exactness(table.rows()[table.rate.row], doublings).neighbors, Values{120});
        EXPECT_EQ(exactness(table.rows()[table.bounces.row], doublings).neighbors, (Values{3, 5}));
    }
    const Exactness factor = exactness(table.rows()[table.factor.row]);
    EXPECT_TRUE(factor.byMeaning);
    EXPECT_TRUE(factor.neighbors.empty());
}

TEST(Study, HasSeveralViewsOfEveryExhibitAndOfTheHall)
{
    const Museum museum{allExhibits()};
    for (const vitrine::SceneObject* subject : museum.subjects()) {
        std::set<std::string> names;
        for (const StudyView& view : subject->studyViews(subject->parameters().initial())) names.insert(view.name);
        EXPECT_GE(names.size(), 3U) << subject->name();
    }
}

TEST(Study, FindsTheLawOfSampling)
{
    // Noise falls with the root of the samples, and work grows with them: cost = c error^-2.
    KnownLaw law;
    law.noisy = true;
    law.error = [](const KnownTable& t, const ParameterValues& v, double) { return 0.3 / std::sqrt(v[t.steps]); };
    law.cost = [](const KnownTable& t, const ParameterValues& v, double) { return static_cast<double>(v[t.steps]); };
    SceneObject subject(std::move(law));
    StudyRequest request = subject.request({"steps"});
    request.axes[0].values = {1, 2, 4, 8, 16};
    request.size = {64, 36};
    const StudyResult result = subject.run(request);
    ASSERT_TRUE(result.law);
    EXPECT_TRUE(result.law->slopeInterval.holds(-2))
        << result.law->slope << " in " << result.law->slopeInterval.low << " to " << result.law->slopeInterval.high;
    EXPECT_LT(result.law->slopeInterval.high - result.law->slopeInterval.low, 0.5);
    EXPECT_FALSE(result.law->slopeInterval.holds(-1)) << "the law of another method";
}

TEST(Study, MeasuresFinishedPicturesThatDoNotBuildOnEachOther)
{
    SceneObject subject(sumOfParts());
    (void)subject.run(subject.request({"steps"}));
    EXPECT_GT(subject.backend.drawn, 10);
    EXPECT_EQ(subject.backend.provisional, 0);
}

TEST(Study, DrawsAPictureOfASettingAndOfAReferenceOnce)
{
    // In each of three views, a picture and two timed frames for each setting, and nothing for the reference, which is
    // one of the settings. `shortcut` is exact by meaning.
    SceneObject switched(sumOfParts());
    StudyRequest request = switched.request({"shortcut"});
    request.runs = 1;
    request.modelError = false;
    const StudyResult result = switched.run(request);
    EXPECT_EQ(switched.backend.drawn, 3 * 2 * 3);
    EXPECT_EQ(result.references[1].pixels, result.points[0].shots[1].picture.pixels);
    EXPECT_EQ(result.points[0].error, 0);
    EXPECT_GT(result.points[1].error, 0);
    for (const StudyPoint& point : result.points) EXPECT_TRUE(isDrawn(point) && point.time);

    // The picture with which the reference of 64 rays is checked, 32 rays, is a setting, too.
    SceneObject counted(sumOfParts());
    request = counted.request({"rays"});
    request.axes[0].values = {1, 32, 64};
    request.runs = 1;
    request.modelError = false;
    const StudyResult rays = counted.run(request);
    EXPECT_EQ(counted.backend.drawn, 3 * 3 * 3);
    EXPECT_DOUBLE_EQ(rays.uncertainty, rays.points[1].error);
    EXPECT_EQ(rays.points[2].error, 0);
}

TEST(Study, OfTwoParametersIsEverySettingOfBoth)
{
    SceneObject subject(sumOfParts());
    const StudyRequest request = subject.request({"method", "shortcut"});
    const StudyResult result = subject.run(request);
    EXPECT_EQ(result.points.size(), 6U);
    ASSERT_TRUE(result.present);
    EXPECT_EQ(valueOf(request, result.points[*result.present], 0), 0);
    EXPECT_EQ(valueOf(request, result.points[*result.present], 1), 1);
    EXPECT_FALSE(result.law) << "two parameters have no one law";
}

TEST(Study, FindsTheLawAlongTheBestOfTwoParameters)
{
    KnownLaw law;
    law.error = [](const KnownTable& t, const ParameterValues& v, double d) {
        return d * 0.2 / (v[t.steps] * std::pow(2.0, v[t.method]));
    };
    law.cost = [](const KnownTable& t, const ParameterValues& v, double d) { return d * v[t.steps]; };
    SceneObject subject(std::move(law));
    const StudyResult result = subject.run(subject.request({"method", "steps"}));
    ASSERT_TRUE(result.law);
    // The reference has 256 steps, not infinitely many, so halving the difference needs a little less than twice the
    // work.
    EXPECT_NEAR(result.law->slope, -1, 0.05);
    EXPECT_EQ(lawSentence(result).rfind("With the best of the settings, halving the error costs ", 0), 0U)
        << lawSentence(result);
}

TEST(Study, SaysWhenNothingDependsOnWhatIsStudied)
{
    KnownLaw still;
    still.error = [](const KnownTable&, const ParameterValues&, double) { return 0.1; };
    still.cost = [](const KnownTable&, const ParameterValues&, double) { return 1.0; };
    SceneObject subject(std::move(still));
    EXPECT_EQ(subject.run(subject.request({"steps"})).convergence,
              "Nothing depends on steps at present: every setting gives the same picture. Switch on what it acts on, "
              "and study again.");
    EXPECT_EQ(subject.run(subject.request({"method", "rays"}))
                  .convergence.rfind("Nothing depends on method or rays at present", 0),
              0U);
    SceneObject other(sumOfParts());
    EXPECT_EQ(other.run(other.request({"steps"})).convergence.find("Nothing"), std::string::npos);
}

TEST(Study, MarksWhatIsDominated)
{
    KnownLaw law = sumOfParts();
    // The method "fair" is more expensive than "exact".
    law.cost = [](const KnownTable& t, const ParameterValues& v, double) {
        return v[t.method] == 1 ? 5.0 : 1.0 + v[t.method];
    };
    SceneObject subject(std::move(law));
    const StudyResult result = subject.run(subject.request({"method"}));
    EXPECT_FALSE(result.points[0].dominated);
    EXPECT_TRUE(result.points[1].dominated);
    EXPECT_FALSE(result.points[2].dominated);
    EXPECT_EQ(result.front, (std::vector<std::size_t>{0, 2}));
}

TEST(Study, GoesByTimeWhereNoCounterTells)
{
    KnownLaw law = sumOfParts();
    law.cost = [](const KnownTable&, const ParameterValues&, double) { return 2.0; };
    SceneObject subject(std::move(law));
    EXPECT_EQ(subject.run(subject.request({"steps"})).costName, "ms");
}

TEST(Study, LeavesTheLookAsItWasHoweverEarlyItStops)
{
    SceneObject subject(sumOfParts());
    const StudyRequest request = subject.request({"steps", "rays"});
    const SceneState before = request.sceneState;
    for (const int stopAfter : {0, 1, 7, 40}) {
        Study study(subject.museum, subject.backend, request);
        for (int i = 0; i < stopAfter; ++i) study.step();
        EXPECT_TRUE(study.request().sceneState == before);
        EXPECT_TRUE(request.sceneState == before);
    }
    EXPECT_TRUE(subject.museum.initialSceneState() == before);
}

/// All settings of these axes, measured.
struct Sweep {
    SceneObject subject;
    StudyRequest request;
    std::vector<Setting> settings;
    std::vector<render::CostAndError> worst;  // Cost, and error in the hardest view of five.

    Sweep() : subject(sumOfParts()), request(subject.request({"steps", "rays", "method", "shortcut"}, 5))
    {
        const KnownLaw law = sumOfParts();
        Setting s(4, 0);
        while (true) {
            ParameterValues v = request.sceneState.values[1];
            for (std::size_t a = 0; a < 4; ++a) v.setParameter(request.axes[a].row, request.axes[a].values[s[a]]);
            settings.push_back(s);
            worst.push_back({law.cost(subject.table, v, 1), law.error(subject.table, v, 2)});
            std::size_t a = 0;
            while (a < 4 && ++s[a] == request.axes[a].values.size()) s[a++] = 0;
            if (a == 4) break;
        }
    }
};

TEST(LongStudyChooser, TheCheapestWithinAnErrorIsTheOneThatAnExhaustiveSweepFinds)
{
    for (const double limit : {0.15, 0.06, 0.02, 0.006}) {
        Sweep sweep;
        sweep.request.maxError = limit;
        sweep.request.settings = 120;
        const StudyResult result = sweep.subject.run(sweep.request);
        ASSERT_TRUE(result.choice) << limit;
        EXPECT_TRUE(result.choice->holds);
        EXPECT_LE(result.choice->heldOutError, limit);
        EXPECT_LT(result.points.size(), sweep.settings.size() * 2 / 3) << "a sweep is what the search saves";
        double cheapest = 1e9;
        for (const auto& [cost, error] : sweep.worst)
            if (error <= limit) cheapest = std::min(cheapest, cost);
        const auto chosen =
            std::find(sweep.settings.begin(), sweep.settings.end(), result.points[result.choice->point].setting) -
            sweep.settings.begin();
        EXPECT_NEAR(sweep.worst[static_cast<std::size_t>(chosen)].cost, cheapest, 1e-9) << limit;
    }
}

TEST(StudyChooser, TheBestWithinATimeIsTheOneThatAnExhaustiveSweepFinds)
{
    for (const double limit : {2.0, 5.0, 12.0}) {
        Sweep sweep;
        sweep.request.maxMilliseconds = limit;
        sweep.request.settings = 120;
        const StudyResult result = sweep.subject.run(sweep.request);
        ASSERT_TRUE(result.choice) << limit;
        EXPECT_TRUE(result.choice->holds);
        // A frame costs its law times the mean difficulty of the three views; the held-out views are no harder.
        double best = 1e9;
        for (const auto& [cost, error] : sweep.worst)
            if (cost * (1 + 2 + 1.75) / 3 <= limit) best = std::min(best, error);
        const auto chosen =
            std::find(sweep.settings.begin(), sweep.settings.end(), result.points[result.choice->point].setting) -
            sweep.settings.begin();
        EXPECT_NEAR(sweep.worst[static_cast<std::size_t>(chosen)].error, best, 1e-9) << limit;
    }
}

TEST(LongStudyChooser, NoiseOfTheClockIsNotTakenForASaving)
{
    // Rays change neither error nor work here. Everything else takes 100 ms, compared with which the steps are little.
    KnownLaw law = sumOfParts();
    law.error = [](const KnownTable& t, const ParameterValues& v, double difficulty) {
        return difficulty * (0.2 / v[t.steps] - 0.2 / 256 + (v[t.method] == 0 ? 0.02 : 0.0));
    };
    law.cost = [](const KnownTable& t, const ParameterValues& v, double difficulty) {
        return 100 + difficulty * (0.1 * v[t.steps] + 2 * v[t.method]);
    };
    for (const unsigned seed : {1U, 2U, 3U}) {
        SceneObject subject(law);
        subject.backend.timeNoise = 0.06;
        subject.backend.seed(seed);
        StudyRequest request = subject.request({"steps", "rays", "method", "shortcut"}, 5);
        request.settings = 120;
        request.runs = 15;
        for (const double limit : {0.15, 0.08, 0.03}) {
            request.maxError = limit;
            const StudyResult result = subject.run(request);
            ASSERT_TRUE(result.choice);
            const StudyPoint& chosen = result.points[result.choice->point];
            EXPECT_LE(chosen.worstError, limit);
            EXPECT_EQ(valueOf(request, chosen, 1), request.sceneState.values[1][subject.table.rays])
                << "rays change nothing, so they stay";
            EXPECT_EQ(valueOf(request, chosen, 3), request.sceneState.values[1][subject.table.shortcut] ? 1 : 0);
            ASSERT_TRUE(result.present);
            const double dearer = static_cast<double>(chosen.counters.at("work")) /
                                  static_cast<double>(result.points[*result.present].counters.at("work"));
            if (result.points[*result.present].worstError <= limit) {
                EXPECT_LE(dearer, 1.02) << "the present setting would have done";
            }
            const std::string sentence = choiceSentence(subject.museum.subjects(), request, result);
            EXPECT_EQ(sentence.find("0.9"), std::string::npos) << sentence;
        }
    }
}

TEST(StudyChooser, ALimitThatOnlyTheExactKeepsIsKeptWhereOneParameterHangsOnAnother)
{
    // Steps have an effect only without the shortcut, like a count that level of detail limits.
    KnownLaw law = sumOfParts();
    law.error = [](const KnownTable& t, const ParameterValues& v, double d) {
        return d * (v[t.shortcut] ? 0.1 : 0.2 / v[t.steps] - 0.2 / 256);
    };
    SceneObject subject(std::move(law));
    StudyRequest request = subject.request({"steps", "rays", "shortcut"}, 17);
    request.maxError = 0.0005;
    const StudyResult result = subject.run(request);
    ASSERT_TRUE(result.choice);
    EXPECT_TRUE(result.choice->holds);
}

TEST(StudyChooser, TheSentenceSaysDearerWhereTheChoiceIsDearer)
{
    SceneObject subject(sumOfParts());
    StudyRequest request = subject.request({"steps"});
    request.sceneState.values[1].setParameter(request.axes[0].row, request.axes[0].values[1]);
    request.maxError = 0.1;
    const StudyResult dearer = subject.run(request);
    ASSERT_TRUE(dearer.choice && dearer.present);
    ASSERT_GT(dearer.points[*dearer.present].worstError, 0.1);
    EXPECT_NE(choiceSentence(subject.museum.subjects(), request, dearer).find("times the cost of the present setting"),
              std::string::npos);

    request.sceneState.values[1].setParameter(request.axes[0].row, request.axes[0].values.back());
    const StudyResult cheaper = subject.run(request);
    EXPECT_NE(choiceSentence(subject.museum.subjects(), request, cheaper).find("times cheaper than at present"),
              std::string::npos);
}

TEST(StudyChooser, AWinnerThatFailsInAHeldOutViewIsNotChosen)
{
    // The held-out views, of difficulties 1.5 and 1.25, are ten times as hard as stated.
    KnownLaw law = sumOfParts();
    const auto honest = law.error;
    law.error = [honest](const KnownTable& t, const ParameterValues& v, double d) {
        return honest(t, v, d == 1.5 || d == 1.25 ? 10 * d : d);
    };
    SceneObject subject(std::move(law));
    StudyRequest request = subject.request({"steps", "shortcut"});
    request.maxError = 0.1;
    const StudyResult result = subject.run(request);
    ASSERT_TRUE(result.choice);
    EXPECT_TRUE(result.choice->holds);
    EXPECT_LE(result.choice->heldOutError, 0.1);
    // By the studied views alone, a cheaper setting would have been sufficient.
    bool cheaper = false;
    for (const StudyPoint& p : result.points)
        cheaper = cheaper || (p.worstError <= 0.1 && p.cost < result.points[result.choice->point].cost);
    EXPECT_TRUE(cheaper);
}

TEST(StudyChooser, WhatCannotBeHadIsNotChosen)
{
    SceneObject subject(sumOfParts());
    StudyRequest request = subject.request({"steps"});
    request.maxMilliseconds = 0.01;
    EXPECT_FALSE(subject.run(request).choice);
}

TEST(Study, RefusesWhatItCannotMeasure)
{
    SceneObject subject(sumOfParts());
    EXPECT_FALSE(studyAxis(subject.museum.initialSceneState(), 1, *subject.table.find("hue"), 5));
    EXPECT_THROW(Study(subject.museum, subject.backend, subject.request({})), Failure);
    StudyRequest decibels = subject.request({"steps"});
    decibels.metric = render::Metric::psnr;
    EXPECT_THROW(Study(subject.museum, subject.backend, decibels), Failure);
}

TEST(Study, ResolutionAndSupersamplesAreParametersOfEveryPicture)
{
    SceneObject subject(sumOfParts());
    StudyRequest request = subject.request({});
    request.axes.push_back(
        *studyAxis(request.sceneState, 0, *subject.museum.hall().parameters().find(supersamplesParameter), 3));
    EXPECT_EQ(axisName(subject.museum.subjects(), request.sceneState, 1, request.axes[0]), "hall.supersamples");
    request.axes[0].values = {1, 4, 16};
    const StudyResult result = subject.run(request);
    EXPECT_EQ(result.costName, "pixels");
    EXPECT_EQ(result.points[1].counters.at("work"), 4 * result.points[0].counters.at("work"));
    EXPECT_NEAR(result.points[2].time->median, 16 * result.points[0].time->median, 1e-9);

    request.axes = {
        *studyAxis(request.sceneState, 0, *subject.museum.hall().parameters().find(resolutionScaleParameter), 3)};
    const StudyResult scaled = subject.run(request);
    for (const StudyPoint& p : scaled.points) {
        EXPECT_EQ(p.shots[0].picture.width, 16);
        EXPECT_EQ(p.shots[0].picture.height, 9);
    }
}

}  // namespace
}  // namespace vitrine::study
