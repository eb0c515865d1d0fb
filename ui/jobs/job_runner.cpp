#include "ui/jobs/job_runner.h"

#include "ui/kit/message_of.h"
#include "ui/kit/time_left.h"
#include "ui/viewport/renderers.h"

#include <utility>

namespace vitrine::ui {

using jobs::JobRun;

JobRunner::JobRunner(Renderers& renderers, RenderThread& thread, QObject* parent)
    : QObject(parent), renderers_(renderers), thread_(thread), work_(this)
{
    connect(&work_, &ProgressJob::progressed, this, [this](double part) { note(part); });
    connect(&work_, &ProgressJob::failed, this, &JobRunner::end);
}

JobRunner::~JobRunner()
{
    cancel();
}

void JobRunner::start(const jobs::Job& job, jobs::JobOrder order)
{
    cancel();
    publishes_ = !order.out.empty();
    order.largestTile = RenderThread::taskTile;
    const auto machine = std::make_shared<render::Json>();
    order.backend = [&renderers = renderers_, machine, times = job.needs().timesPasses] {
        *machine = renderers.machine();
        return renderers.makeBackend(times);
    };
    order.machine = [machine] { return *machine; };
    running_ = true;
    elapsed_.start();
    try {
        jobs::requireWritable(job, order);
        go(job.start(std::move(order)));
    } catch (const std::exception& failure) {
        end(messageOf(failure));
    }
}

void JobRunner::cancel()
{
    task_.cancel();
    work_.stop();
    drawn_.reset();
    running_ = publishing_ = false;
    ++turn_;
}

void JobRunner::go(Run run)
{
    switch (run->next()) {
    case JobRun::Next::draw: draw(std::move(run)); return;
    case JobRun::Next::work: compute(std::move(run)); return;
    case JobRun::Next::done: break;
    }
    if (std::exchange(publishes_, false)) {
        publishing_ = true;
        compute(std::move(run));
        return;
    }
    running_ = publishing_ = false;
    emit finished(run);
}

void JobRunner::draw(Run run)
{
    task_ = thread_.start(
        [this, run = std::move(run), told = QElapsedTimer()](const RenderThread::Notify& notify) mutable {
            run->step([](double) { return true; });
            if (run->next() != JobRun::Next::draw) {
                notify([this, run] { drawn_ = run; });
                return false;
            }
            if (!told.isValid() || told.elapsed() >= RenderThread::tellEvery) {
                told.start();
                notify([this, part = run->progress()] { note(part); });
            }
            return true;
        },
        [this](const QString& failure) {
            Run done = std::exchange(drawn_, nullptr);
            if (failure.isEmpty() && done)
                go(std::move(done));
            else
                end(failure);
        });
}

void JobRunner::compute(Run run)
{
    work_.start(
        [this, run = std::move(run), turn = turn_](const ProgressJob::Progress& progress) -> ProgressJob::Outcome {
            if (run->next() == JobRun::Next::done)
                run->publish();
            else
                run->step(progress);
            return [this, run, turn] {
                if (turn == turn_) go(run);
            };
        });
}

void JobRunner::note(double part)
{
    if (running_) emit progressed(part, secondsLeft(part, elapsed_));
}

void JobRunner::end(const QString& failure)
{
    if (!running_) return;
    cancel();
    emit failed(failure);
}

}  // namespace vitrine::ui

#include "moc_job_runner.cpp"
