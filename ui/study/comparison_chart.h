#pragma once

#include "exhibits/study/study_comparison.h"
#include "ui/study/log_chart.h"

namespace vitrine::ui {

/// The fronts of several studies over each other, each with a mark, a kind of line and a color of its own, and a
/// legend. What their fronts dominate is faint.
class ComparisonChart final : public LogChart {
    Q_OBJECT

public:
    explicit ComparisonChart(QWidget* parent = nullptr);

    /// Those left out are in the legend, which says so.
    void setComparison(StudyComparison);
    [[nodiscard]] const StudyComparison& comparison() const { return comparison_; }

private:
    void build() override;
    void addCurve(std::size_t curve);

    StudyComparison comparison_;
};

/// Title of the axis of costs: "milliseconds of a picture", "field evaluations per pixel".
[[nodiscard]] QString comparedCostTitle(const std::string& cost);
/// Why times are not among the costs; empty where they are.
[[nodiscard]] QString timesDifferText(TimesDiffer);

}  // namespace vitrine::ui
