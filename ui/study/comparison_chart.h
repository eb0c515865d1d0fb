#pragma once

#include "exhibits/study/study_comparison.h"
#include "ui/study/log_chart.h"

namespace vitrine::ui {

/// Chart with the Pareto fronts of several studies, each with its own mark, line and color, and a legend. Dominated
/// points are faint.
class ComparisonChart final : public LogChart {
    Q_OBJECT

public:
    explicit ComparisonChart(QWidget* parent = nullptr);

    /// Shows a comparison. Studies that are left out are listed in the legend.
    void setComparison(study::StudyComparison);
    [[nodiscard]] const study::StudyComparison& comparison() const { return comparison_; }

private:
    void build() override;
    void addCurve(std::size_t curve);

    study::StudyComparison comparison_;
};

/// Returns the title of the cost axis: "milliseconds of a picture", "field evaluations per pixel".
[[nodiscard]] QString comparedCostTitle(const std::string& cost);
/// Returns why times are not among the costs; empty if they are.
[[nodiscard]] QString timesDifferText(study::TimesDiffer);

}  // namespace vitrine::ui
