// The job "study" over an exhibit with a known law, without graphics.

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/jobs/kit/command_line.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/study/study_job.h"
#include "exhibits/study/study_table.h"
#include "exhibits/study/study_text.h"
#include "tests/exhibits/study/known_law.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace vitrine {
namespace {

using namespace jobs;

class StudyJobTest : public testing::Test {
protected:
    static std::vector<std::unique_ptr<Exhibit>> knownOne()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<test::KnownExhibit>(test::sumOfParts()));
        return all;
    }
    StudyJobTest()
    {
        const study::StudyTable& t = study::studyTable();
        values_.set(t.varied, std::string("steps"));
        values_.set(t.width, 16);
        values_.set(t.height, 9);
        values_.set(t.runs, 2);
    }
    [[nodiscard]] JobOrder order(const std::filesystem::path& out = {}) const
    {
        JobOrder all{values_, {&museum_, museum_.initialSceneState(), 1, {}}};
        all.out = out;
        all.inputs = job_.read(values_);
        all.backend = [] { return std::make_unique<test::KnownBackend>(); };
        all.machine = [] { return render::Json{{"processors", 2}}; };
        return all;
    }
    [[nodiscard]] JobPlan planned(const ParameterValues& values) const
    {
        const JobOrder all = order();
        return job_.plan(values, all.scene, *all.inputs, "out");
    }
    static void runAll(JobRun& run)
    {
        while (run.next() != JobRun::Next::done) run.step([](double) { return true; });
    }

    Museum museum_{knownOne()};
    StudyJob job_;
    ParameterValues values_{study::studyTable()};
};

using LongStudyJobTest = StudyJobTest;

TEST_F(LongStudyJobTest, MeasuresAsAStudyOfTheSameRequestDoes)
{
    const std::unique_ptr<JobRun> run = job_.start(order());
    runAll(*run);
    test::KnownBackend backend;
    study::Study study(museum_, backend, study::studyRequest(values_, museum_, museum_.initialSceneState(), 1));
    while (study.step()) {
    }
    EXPECT_EQ(run->answer(),
              study::studyJson(museum_.subjects(), study.request(), study.result(), {{"processors", 2}}));
    EXPECT_EQ(run->report().facts.front(), (Fact{"Settings", static_cast<double>(study.result().points.size())}));
    EXPECT_EQ(run->progress(), 1);
}

TEST_F(StudyJobTest, WritesItsFolderAndADocumentThatKeepsWhatWasSet)
{
    const test::TemporaryFolder folder;
    JobOrder all = order(folder / "out");
    const auto row = museum_.subject(1).parameters().find("rays").value();
    all.scene.state.values[1].setParameter(row, 9.0);
    int written = 0;
    all.writeFolder = [&written](const JobRun& run) {
        ++written;
        EXPECT_EQ(static_cast<const StudyRun&>(run).costs(), study::CostAxis::time);
    };
    const std::unique_ptr<JobRun> run = job_.start(all);
    runAll(*run);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "before it is published";
    run->publish();
    EXPECT_EQ(written, 1);
    const JobDocument read = readDocument(folder / "out", job_, &museum_);
    EXPECT_EQ(read.values, values_);
    EXPECT_EQ(read.chosen, "known");
    EXPECT_EQ(read.scene.values, all.scene.state.values);
    EXPECT_EQ(read.out, folder / "out");
    const std::vector<std::string> words = commandOf(job_, all);
    EXPECT_EQ(words.at(1), "known");
    EXPECT_NE(std::find(words.begin(), words.end(), "--set=known.rays=9"), words.end());
}

TEST_F(StudyJobTest, PlansRandomValuesAndRefusesInOneSentence)
{
    RandomNumbers random(6);
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
        ParameterValues values = randomValues(study::studyTable(), random, 0.7);
        const char* varied[] = {"", "steps", "steps\nrays", "soup", "hue", "hall.supersamples"};
        const char* tried[] = {"", "", "1,8", "1,soup"};
        values.set(study::studyTable().varied, std::string(varied[random.index(6)]));
        values.set(study::studyTable().values, std::string(tried[random.index(4)]));
        const JobPlan plan = planned(values);
        EXPECT_NE(plan.refusal.empty(), plan.facts.empty());
        if (plan.refusal.empty()) continue;
        ++refused;
        EXPECT_EQ(plan.refusal.back(), '.') << plan.refusal;
    }
    EXPECT_GT(refused, 40);
    EXPECT_LT(refused, 180);
}

TEST_F(StudyJobTest, CountsTheSettingsOfItsPlan)
{
    const study::StudyTable& t = study::studyTable();
    values_.set(t.values, std::string("1,8,64"));
    EXPECT_EQ(planned(values_).facts.front(), (Fact{"Settings", 3.0}));
    values_.set(t.values, std::string());
    values_.set(t.varied, std::string("method\nshortcut"));
    EXPECT_EQ(planned(values_).facts.front(), (Fact{"Settings", 6.0}));
    values_.set(t.varied, std::string());
    values_.set(t.settings, 50);
    EXPECT_EQ(planned(values_).facts.front(), (Fact{"Settings at most", 50.0}));
}

TEST_F(LongStudyJobTest, ChoosesOnlyWhereALimitIsSet)
{
    const study::StudyTable& t = study::studyTable();
    const auto preset = [&] {
        const std::unique_ptr<JobRun> run = job_.start(order());
        runAll(*run);
        return static_cast<const StudyRun&>(*run).chosenPreset();
    };
    EXPECT_EQ(preset(), "");
    values_.set(t.choosing, study::StudyFind::cheapest);
    values_.set(t.maxError, 0.2);
    EXPECT_NE(preset().find("\"steps\""), std::string::npos);
    values_.set(t.maxError, 0.0);
    values_.set(t.values, std::string("1,8"));
    EXPECT_EQ(preset(), "");
}

TEST(StudyMetrics, AreAllThatFallToNothing)
{
    EXPECT_EQ(study::studyMetrics(), (std::vector<std::string>{"rmse", "max", "beyond", "mape", "relmse", "dssim",
                                                               "flip", "normal", "depth"}));
}

}  // namespace
}  // namespace vitrine
