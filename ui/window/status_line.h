#pragma once

#include "render/plan/render_backend.h"

#include <QSize>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace vitrine::ui {

class FrameGraph;

/// Status line, left to right: the reason of the last drawing, times of the last frames, time of the last one. The
/// tooltip of the time has its clock, the resolution, and the number of passes. Updated at most twice a second, and
/// only after a drawing.
class StatusLine final : public QWidget {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// Sets the data of one picture. `reason`: DrawSchedule::reason after it was drawn.
    void note(const render::FrameReport&, const QSize& pixels, const QString& reason);
    /// Shows help on the object under the pointer in place of the reason; empty: the reason again.
    void showHelp(const QString&);
    [[nodiscard]] QString text() const;

private:
    void renew();

    QLabel *words_, *time_;
    FrameGraph* graph_;
    void showWords();

    QString help_;
    QString reason_, shownReason_;
    QTimer timer_;
    QSize pixels_;
    double milliseconds_ = 0;
    QString clock_;
    std::size_t ran_ = 0, skipped_ = 0;
};

}  // namespace vitrine::ui
