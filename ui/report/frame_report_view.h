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

/// Frame report of the last frame: passes that ran with their cost, and skipped ones with the reason and their last
/// cost.
class FrameReportView final : public QTreeWidget {
    Q_OBJECT

public:
    explicit FrameReportView(QWidget* parent = nullptr);
    [[nodiscard]] const render::StepCosts& costs() const { return costs_; }
    /// Sets the titles that replace the part of a pass's name before the slash: "Torus to Mug: cone" for
    /// "sdf_morph/cone".
    void setTitles(const QHash<QString, QString>&);
    /// Sets the report. Shown at most twice a second, and only while visible.
    void note(const render::FrameReport&);
    /// Sets the report of the settings B, with a column of its own, and the counters of both; nullopt: none.
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
    /// Adds the times of B's passes, passes that only B ran, and the counters of both.
    void addOther(std::vector<Line>&) const;
    [[nodiscard]] QString stepText(const QString& name) const;
    /// Returns the last times of the other variants of a pass.
    [[nodiscard]] std::vector<std::pair<std::string, double>> otherVariants(const render::StepReport& ran) const;

    QHash<QString, QString> titles_;
    render::FrameReport report_;
    std::optional<render::FrameReport> other_;
    render::StepCosts costs_;
    QTimer timer_;
};

}  // namespace vitrine::ui
