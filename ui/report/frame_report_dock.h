#pragma once

#include "render/plan/render_backend.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QCheckBox;
class QLabel;

namespace vitrine::ui {

class FrameReportView;

/// Dock with the frame report. Above the list are the reason of the last drawing, and the switch that runs every pass.
class FrameReportDock final : public QWidget {
    Q_OBJECT

public:
    /// `reason` is called half a second after the last frame.
    explicit FrameReportDock(std::function<QString()> reason, QWidget* parent = nullptr);

    void note(const render::FrameReport&);
    /// Sets the frame report of the settings B. Null while B is not drawn: `why` then gives the reason, empty if there
    /// is no B.
    void noteOther(const render::FrameReport*, const QString& why);
    [[nodiscard]] FrameReportView& view() const { return *view_; }
    [[nodiscard]] QString reasonText() const;
    /// Text with the number of passes and the milliseconds of the frame, and of B's.
    [[nodiscard]] QString sumsText() const { return sumsText_; }
    [[nodiscard]] QCheckBox& runEverything() const { return *everything_; }

signals:
    void runEverythingAsked(bool on);

private:
    void renew();

    std::function<QString()> askReason_;
    QString reasonText_, sumsText_;
    QString other_;  // Text on B; empty: there is no B.
    QLabel* reason_;
    QLabel* sums_;
    QCheckBox* everything_;
    FrameReportView* view_;
    QTimer timer_;
    double milliseconds_ = 0;
    std::size_t ran_ = 0;
    double saved_ = 0;
    QString clock_;
};

}  // namespace vitrine::ui
