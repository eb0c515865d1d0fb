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
    [[nodiscard]] LedgerView& view() const { return *view_; }
    [[nodiscard]] QString reasonText() const;
    [[nodiscard]] QCheckBox& runEverything() const { return *everything_; }

signals:
    void runEverythingAsked(bool on);

private:
    void renew();

    std::function<QString()> askReason_;
    QString reasonText_;
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
