#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/jobs/job_runner.h"
#include "ui/kit/progress_job.h"

#include <QElapsedTimer>
#include <QObject>

#include <filesystem>

namespace vitrine::ui {

class JobPreview;

/// Smaller run of a job: fills the preview, and judges by it what the whole run will make.
class JobDraft final : public QObject {
    Q_OBJECT

public:
    /// Everything must outlive it. Without a preview (null), nothing is run.
    JobDraft(const jobs::Job&, Renderers&, RenderThread&, JobPreview*, QObject* parent);

    /// Runs `order`. `whole`: values of the whole run. The extension of `out` decides the format.
    void start(jobs::JobOrder order, const ParameterValues& whole, const std::filesystem::path& out);
    void cancel();
    /// Cancels the run and clears the preview.
    void clear();
    [[nodiscard]] bool busy() const { return runner_.running() || show_.running(); }

signals:
    /// Emitted when the preview shows the run.
    void shown(const vitrine::jobs::JobReport& report, const vitrine::jobs::JobForecast& forecast);
    void failed(const QString& why);

private:
    void show(const JobRunner::Run&);

    const jobs::Job& job_;
    JobRunner runner_;
    ProgressJob show_;
    JobPreview* preview_;
    QElapsedTimer elapsed_;
    ParameterValues drawn_, whole_;
    std::filesystem::path out_;
};

}  // namespace vitrine::ui
