#pragma once

#include "exhibits/jobs/kit/job.h"

#include <QWidget>

#include <functional>

namespace vitrine::ui {

/// Shows in a job's dialog what the job will make, by a smaller run of it.
class JobPreview : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Makes what is shown of a finished run of the values `drawn` (`Job::draft` of `all`). On any thread; what it
    /// returns is called on the window's thread.
    [[nodiscard]] virtual std::function<void()> prepare(const jobs::JobRun&, const ParameterValues& all,
                                                        const ParameterValues& drawn) = 0;
    /// Shows nothing.
    virtual void clear() = 0;
};

/// The preview of a job, by its name. Null: the dialog has none.
[[nodiscard]] JobPreview* makePreview(std::string_view job, QWidget* parent);

}  // namespace vitrine::ui
