// Plans of a job's dialog while its inputs change.

#include "tests/kit/contact_job.h"
#include "tests/ui/ui_main.h"
#include "ui/jobs/job_planner.h"
#include "ui/jobs/job_setup.h"

#include <QSemaphore>
#include <QSignalSpy>

#include <atomic>

using namespace vitrine;

namespace {

/// A job whose inputs are read only when the test allows it. Each plan states the number of its reading.
class SlowlyRead final : public test::ContactJob {
public:
    struct Read final : jobs::JobInputs {
        int number = 0;
    };

    [[nodiscard]] std::shared_ptr<const jobs::JobInputs> read(const ParameterValues&) const override
    {
        auto inputs = std::make_shared<Read>();
        inputs->number = ++begun;
        mayEnd.acquire();
        return inputs;
    }
    [[nodiscard]] jobs::JobPlan plan(const ParameterValues&, const jobs::JobScene&, const jobs::JobInputs& inputs,
                                     const std::filesystem::path&) const override
    {
        return {.refusal = std::to_string(static_cast<const Read&>(inputs).number)};
    }

    mutable std::atomic<int> begun = 0;
    mutable QSemaphore mayEnd;
};

}  // namespace

class JobPlannerTest : public QObject {
    Q_OBJECT

private slots:
    void inputsThatChangeWhileTheyAreReadAreReadAgain()
    {
        const SlowlyRead job;
        ui::JobSetup setup(job, nullptr);
        ui::JobPlanner planner(
            job, [] { return jobs::JobScene(); }, setup, nullptr);
        const QSignalSpy planned(&planner, &ui::JobPlanner::planned);
        planner.follow();
        QTRY_COMPARE(job.begun.load(), 1);
        planner.refresh();
        job.mayEnd.release(2);
        QTRY_VERIFY(!planner.busy());
        QCOMPARE(planned.count(), 1);
        QCOMPARE(planner.plan()->refusal, std::string("2"));
    }
};

VITRINE_UI_TEST(JobPlannerTest)
#include "job_planner_test.moc"
