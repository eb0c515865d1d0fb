#pragma once

#include "ui/jobs/job_preview.h"

class QPlainTextEdit;

namespace vitrine::ui {

/// Preview of a text: its first lines, which can be selected and copied.
class TextPreview final : public JobPreview {
    Q_OBJECT

public:
    explicit TextPreview(QWidget* parent);

    [[nodiscard]] std::function<void()> prepare(const jobs::JobRun&, const ParameterValues& all,
                                                const ParameterValues& drawn) override;
    void clear() override;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QSize sizeHint() const override { return {480, 320}; }

private:
    QPlainTextEdit* lines_;
};

}  // namespace vitrine::ui
