#pragma once

#include "render/plan/painter.h"

#include <QTimer>
#include <QTreeWidget>

namespace vitrine::ui {

/// The ledger of the last frame: what ran and what it cost, what was skipped and why.
class LedgerView final : public QTreeWidget {
    Q_OBJECT

public:
    explicit LedgerView(QWidget* parent = nullptr);
    /// Shown twice a second at most, and only while visible.
    void note(const render::FrameReport&);

protected:
    void showEvent(QShowEvent*) override;

private:
    void renew();

    render::FrameReport report_;
    QTimer timer_;
};

}  // namespace vitrine::ui
