#pragma once

#include "render/plan/step_costs.h"

#include <QHash>
#include <QTimer>
#include <QTreeWidget>

namespace vitrine::ui {

/// The ledger of the last frame: what ran and what it cost, what was skipped, why, and what it cost when it last ran.
class LedgerView final : public QTreeWidget {
    Q_OBJECT

public:
    explicit LedgerView(QWidget* parent = nullptr);
    [[nodiscard]] const render::StepCosts& costs() const { return costs_; }
    /// What stands for the part of a step's name before the slash: "Torus to Mug: cone" for "sdf_morph/cone".
    void setTitles(const QHash<QString, QString>&);
    /// Shown twice a second at most, and only while visible.
    void note(const render::FrameReport&);

protected:
    void showEvent(QShowEvent*) override;

private:
    void renew();
    [[nodiscard]] QString stepText(const QString& name) const;
    /// What the step's other variants took when they were last drawn.
    [[nodiscard]] std::vector<std::pair<std::string, double>> otherVariants(const render::StepReport& ran) const;

    QHash<QString, QString> titles_;
    render::FrameReport report_;
    render::StepCosts costs_;
    QTimer timer_;
};

}  // namespace vitrine::ui
