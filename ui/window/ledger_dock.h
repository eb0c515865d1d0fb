#pragma once

#include "render/plan/render_backend.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QCheckBox;
class QLabel;

namespace vitrine::ui {

class LedgerView;

/// The ledger with what it says above the list: why something is drawn, or why nothing is; and the switch that runs
/// everything regardless.
class LedgerDock final : public QWidget {
    Q_OBJECT

public:
    /// `reason` is asked half a second after the last frame.
    explicit LedgerDock(std::function<QString()> reason, QWidget* parent = nullptr);

    void note(const render::FrameReport&);
    /// The frame of the settings B; null while it is not drawn: `why` then says so, empty where there is no B.
    void noteOther(const render::FrameReport*, const QString& why);
    [[nodiscard]] LedgerView& view() const { return *view_; }
    [[nodiscard]] QString reasonText() const;
    /// Steps and milliseconds of the frame, and of B's.
    [[nodiscard]] QString sumsText() const { return sumsText_; }
    [[nodiscard]] QCheckBox& runEverything() const { return *everything_; }

signals:
    void runEverythingAsked(bool on);

private:
    void renew();

    std::function<QString()> askReason_;
    QString reasonText_, sumsText_;
    QString other_;  // What is said of B; empty: there is none.
    QLabel* reason_;
    QLabel* sums_;
    QCheckBox* everything_;
    LedgerView* view_;
    QTimer timer_;
    double milliseconds_ = 0;
    std::size_t ran_ = 0;
    double saved_ = 0;
    QString clock_;
};

}  // namespace vitrine::ui
