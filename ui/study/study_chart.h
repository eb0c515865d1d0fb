#pragma once

#include "exhibits/study/study_costs.h"

#include "ui/study/log_chart.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::ui {

/// Point of the chart: one setting.
struct ChartPoint : ChartSpan {
    QString text;  ///< Label, such as "64".
    bool dominated = false, onFront = false, knee = false, present = false;
};

/// Content of a chart: a study over one cost axis.
struct ChartedStudy {
    QString heading;  ///< Exhibit and parameters: "Fur: Shell count".
    QString details;  ///< Conditions of the measurement: views, size, clock.
    QString costTitle, errorTitle;
    QString emptyText;  ///< Reason why there is no point yet.
    std::vector<ChartPoint> points;
    std::size_t parameters = 1;  ///< Number of parameters that the study varies.
    QString law;                 ///< Sentence on the cost of halving the error on this axis; empty: none.
};

/// Chart of error over cost: a line through the Pareto front, faint dominated points, marks on the knee and the present
/// setting.
class StudyChart final : public LogChart {
    Q_OBJECT

public:
    explicit StudyChart(QWidget* parent = nullptr);

    void showStudy(ChartedStudy);
    void setPoints(std::vector<ChartPoint>);
    [[nodiscard]] const std::vector<ChartPoint>& points() const { return points_; }
    /// Returns the position of a point in pixels, in the last layout.
    [[nodiscard]] QPointF placeOf(std::size_t point) const;
    /// Returns the point under the pointer, within a tolerance.
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF&) const;
    void emphasize(std::optional<std::size_t> point);

signals:
    void chosen(int point);  ///< Emitted on Enter, or when a point is clicked with the left button.
    /// Emitted when the pointer or the arrow keys move to a point; -1 after a click beside all points. The point stays
    /// current until the next one.
    void hovered(int point);

protected:
    void mouseMoveEvent(QMouseEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    void build() override;
    void say();
    /// Returns the points for which `holds` is true, sorted by cost.
    [[nodiscard]] std::vector<const ChartPoint*> byCost(const std::function<bool(const ChartPoint&)>& holds) const;
    QCPGraph* addErrors(const QColor&, bool lined, double size, const std::function<bool(const ChartPoint&)>& holds);
    /// Adds the second line: errors against the exact reference, if they differ from those of the first line.
    void addModelErrors(QCPGraph& front);
    [[nodiscard]] bool hasModelErrors() const;
    struct Label;
    void addMarks();
    [[nodiscard]] bool isMarked(std::size_t point) const;
    void addRings(std::size_t point);
    /// Adds the point's text to the label of a point at the same position. Returns false if there is none.
    bool sharesLabel(std::size_t point, std::vector<Label>&) const;
    /// Adds a label above or below the point, to its right or left, where it covers no other label and no point. Adds
    /// none if there is no such position.
    void addLabel(std::size_t point, std::vector<Label>&);
    [[nodiscard]] bool isFree(const QRectF&, std::size_t point, const std::vector<Label>&) const;
    /// Returns the line segments of the fronts, in pixels.
    [[nodiscard]] std::vector<QLineF> curves() const;

    std::vector<ChartPoint> points_;
    std::size_t parameters_ = 1;
    std::optional<std::size_t> emphasized_;
    int hovered_ = -1;
};

/// Returns the chart of a study, as far as it is measured.
[[nodiscard]] ChartedStudy charted(Subjects, const study::StudyRequest&, const study::StudyResult&, study::CostAxis);
/// Returns the chart of a kept study, with its title as the heading.
[[nodiscard]] ChartedStudy charted(const study::KeptStudy&, const QString& title, study::CostAxis);
/// Returns the name of a setting: "Shell count 64", "as at present".
[[nodiscard]] QString settingWords(const std::vector<study::SettingPart>&);

}  // namespace vitrine::ui
