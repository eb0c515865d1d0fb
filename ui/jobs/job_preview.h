#pragma once

#include "exhibits/jobs/kit/job.h"
#include "render/image/image.h"

#include <QImage>
#include <QWidget>

#include <functional>

namespace vitrine::ui {

/// Preview in a job's dialog: shows the result of a smaller run of the job.
class JobPreview : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Prepares the display of a finished run with the values `drawn` (`Job::draft` of `all`). Any thread; the returned
    /// function is called on the window's thread.
    [[nodiscard]] virtual std::function<void()> prepare(const jobs::JobRun&, const ParameterValues& all,
                                                        const ParameterValues& drawn) = 0;
    /// Clears the preview.
    virtual void clear() = 0;
};

/// Converts linear RGBA, or RGB, to display codes with straight alpha. Fully transparent pixels have no color.
[[nodiscard]] QImage imageWithOpacity(const render::Image&);

}  // namespace vitrine::ui
