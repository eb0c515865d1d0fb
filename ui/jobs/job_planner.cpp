#include "ui/jobs/job_planner.h"

#include "exhibits/framework/table/acting.h"
#include "ui/jobs/job_setup.h"

#include <utility>

namespace vitrine::ui {
namespace {

constexpr int planAfter = 250;  // Milliseconds.

/// Returns the files of parameters that have an effect.
std::vector<std::string> filesOf(const ParameterValues& values)
{
    std::vector<std::string> files;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (values.rows()[i].kind == Kind::file)
            files.push_back(acts(values, i) ? std::get<std::string>(values.row(i)) : std::string());
    return files;
}

}  // namespace

/// Outcome of planning on another thread.
struct JobPlanner::Planned {
    ParameterValues values, draft;
    std::shared_ptr<const jobs::JobInputs> inputs;
    jobs::JobPlan plan;
    int refreshes;  ///< Value of `refreshes_` when it began.
};

JobPlanner::JobPlanner(const jobs::Job& job, SceneSource scene, JobSetup& setup, QObject* parent)
    : QObject(parent), job_(job), scene_(std::move(scene)), setup_(setup), work_(this)
{
    soon_.setSingleShot(true);
    soon_.setInterval(planAfter);
    connect(&soon_, &QTimer::timeout, this, &JobPlanner::start);
    connect(&work_, &ProgressJob::failed, this, [this](const QString& why) {
        inputs_.reset();
        planned_.reset();
        emit failed(why);
    });
}

void JobPlanner::follow()
{
    if (filesOf(setup_.values()) != files_) inputs_.reset();
    soon_.start();
}

void JobPlanner::refresh()
{
    inputs_.reset();
    ++refreshes_;
    follow();
}

void JobPlanner::start()
{
    const ParameterValues values = setup_.values();
    work_.start([this, values, inputs = inputs_, scene = scene_(), refreshes = refreshes_,
                 &job = job_](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        const ParameterValues whole = job.withScene(values, scene);
        const auto read = inputs ? inputs : job.read(whole);
        const Planned planned{values, job.draft(whole, *read), read, job.plan(values, scene, *read, {}), refreshes};
        return [this, planned] { take(planned); };
    });
}

void JobPlanner::take(const Planned& planned)
{
    // Another plan is on its way then. Inputs read before a refresh may be out of date.
    if (!(planned.values == setup_.values()) || planned.refreshes != refreshes_) return;
    inputs_ = planned.inputs;
    files_ = filesOf(planned.values);
    planned_ = planned.plan;
    drawn_ = planned.draft;
    emit this->planned();
}

bool JobPlanner::drawsAll(const jobs::JobForecast& forecast) const
{
    const jobs::JobScene scene = scene_();
    if (*drawn_ == job_.withScene(setup_.values(), scene)) return true;
    return forecast.facts.empty() && job_.plan(*drawn_, scene, *inputs_, {}).facts == planned_->facts;
}

jobs::JobPlan JobPlanner::planFor(const std::filesystem::path& out) const
{
    return job_.plan(setup_.values(), scene_(), *inputs_, out);
}

jobs::JobOrder JobPlanner::order(const ParameterValues& values) const
{
    const jobs::JobScene scene = scene_();
    return {job_.withScene(values, scene), job_.sceneFor(values, scene), inputs_, {}, {}};
}

}  // namespace vitrine::ui

#include "moc_job_planner.cpp"
