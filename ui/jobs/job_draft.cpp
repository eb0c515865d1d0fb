#include "ui/jobs/job_draft.h"

#include "ui/jobs/job_preview.h"

#include <utility>

namespace vitrine::ui {

JobDraft::JobDraft(const jobs::Job& job, Renderers& renderers, RenderThread& thread, JobPreview* preview,
                   QObject* parent)
    : QObject(parent), job_(job), runner_(renderers, thread, this), show_(this), preview_(preview),
      drawn_(job.parameters().initial()), whole_(drawn_)
{
    connect(&runner_, &JobRunner::finished, this, &JobDraft::show);
    connect(&runner_, &JobRunner::failed, this, &JobDraft::failed);
    connect(&show_, &ProgressJob::failed, this, &JobDraft::failed);
}

void JobDraft::start(jobs::JobOrder order, const ParameterValues& whole, const std::filesystem::path& out)
{
    if (!preview_) return;
    drawn_ = order.values;
    whole_ = whole;
    out_ = out;
    elapsed_.start();
    runner_.start(job_, std::move(order));
}

void JobDraft::show(const JobRunner::Run& run)
{
    const double seconds = 1e-9 * static_cast<double>(elapsed_.nsecsElapsed());
    show_.start([this, run, seconds, drawn = drawn_, whole = whole_, out = out_, &job = job_,
                 preview = preview_](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        const jobs::JobForecast forecast = job.forecast(whole, {drawn, *run, seconds}, out);
        return [this, run, forecast, show = preview->prepare(*run, whole, drawn)] {
            show();
            emit shown(run->report(), forecast);
        };
    });
}

void JobDraft::cancel()
{
    runner_.cancel();
    show_.stop();
}

void JobDraft::clear()
{
    cancel();
    if (preview_) preview_->clear();
}

}  // namespace vitrine::ui

#include "moc_job_draft.cpp"
