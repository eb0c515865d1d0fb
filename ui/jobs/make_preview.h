#pragma once

class QWidget;

namespace vitrine::jobs {
class Job;
}

namespace vitrine::ui {

class JobPreview;

/// Creates the preview of a job; null if the job has none.
[[nodiscard]] JobPreview* makePreview(const jobs::Job&, QWidget* parent);

}  // namespace vitrine::ui
