#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/kit/progress_job.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <memory>

namespace vitrine::ui {

class Renderers;

/// Runs the steps of a job: drawing steps on the render thread, between its other tasks, and computing steps on a
/// thread of its own. Runs are passed between threads only here.
class JobRunner final : public QObject {
    Q_OBJECT

public:
    using Run = std::shared_ptr<jobs::JobRun>;

    /// Both must outlive it.
    JobRunner(Renderers&, RenderThread&, QObject* parent);
    ~JobRunner() override;

    /// Starts a job in place of the one that is running. Publishes it at the end if `order` has an output.
    void start(const jobs::Job&, jobs::JobOrder order);
    /// Cancels the run: no further signal is emitted, and all of its files are removed, unless they are being
    /// published.
    void cancel();
    [[nodiscard]] bool running() const { return running_; }
    [[nodiscard]] bool publishing() const { return running_ && publishing_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    /// Emitted when the run is done, and published if it has an output.
    void finished(const vitrine::ui::JobRunner::Run& run);
    void failed(const QString& why);

private:
    // The run is passed by value, because a drawing run must be destroyed on the render thread together with its
    // renderer.
    void go(Run);
    void draw(Run);
    void compute(Run);
    void note(double part);
    void end(const QString& failure);

    Renderers& renderers_;
    RenderThread& thread_;
    RenderThread::Task task_;
    ProgressJob work_;
    QElapsedTimer elapsed_;
    Run drawn_;
    bool publishes_ = false, publishing_ = false;
    bool running_ = false;
    int turn_ = 0;  ///< Incremented by each start and cancel; results of an earlier number are dropped.
};

}  // namespace vitrine::ui
