#pragma once

#include "render/plan/step_costs.h"

#include <QHash>
#include <QTimer>
#include <QTreeWidget>

#include <optional>
#include <string>
#include <utility>
#include <vector>

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
    /// The frame of other settings that these are compared with, in a column of its own, with the counters of both;
    /// nothing: there is none.
    void noteOther(std::optional<render::FrameReport>);

protected:
    void showEvent(QShowEvent*) override;

private:
    struct Line {
        std::string name;
        QString work, time, other, saved, reason;
        bool ran = false;
    };
    void renew();
    [[nodiscard]] std::vector<Line> lines() const;
    /// What the other frame's steps took beside these, what only it ran, and the counters of both.
    void addOther(std::vector<Line>&) const;
    [[nodiscard]] QString stepText(const QString& name) const;
    /// What the step's other variants took when they were last drawn.
    [[nodiscard]] std::vector<std::pair<std::string, double>> otherVariants(const render::StepReport& ran) const;

    QHash<QString, QString> titles_;
    render::FrameReport report_;
    std::optional<render::FrameReport> other_;
    render::StepCosts costs_;
    QTimer timer_;
};

}  // namespace vitrine::ui
