#pragma once

#include "ui/jobs/job_preview.h"

#include <QImage>

namespace vitrine::ui {

/// Preview of a picture, which keeps its aspect ratio. Transparent parts lie over a checkerboard.
class PicturePreview final : public JobPreview {
    Q_OBJECT

public:
    explicit PicturePreview(QWidget* parent);

    [[nodiscard]] std::function<void()> prepare(const jobs::JobRun&, const ParameterValues& all,
                                                const ParameterValues& drawn) override;
    void clear() override { setPicture({}); }
    [[nodiscard]] const QImage& picture() const { return picture_; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 320}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void setPicture(QImage);

    QImage picture_;
};

}  // namespace vitrine::ui
