#pragma once

#include "exhibits/study/kept_study.h"
#include "exhibits/study/study_result.h"

#include "ui/study/log_chart.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::ui {

/// What one point of the chart says.
struct ChartPoint : ChartSpan {
    QString text;  ///< "64".
    bool dominated = false, onFront = false, knee = false, present = false;
};

/// Error over cost: the front drawn through, what it dominates grayed, knee and present setting marked.
class StudyChart final : public LogChart {
    Q_OBJECT

public:
    explicit StudyChart(QWidget* parent = nullptr);

    void setPoints(std::vector<ChartPoint>);
    [[nodiscard]] const std::vector<ChartPoint>& points() const { return points_; }
    /// Where a point is, in pixels of the chart as it was last laid out.
    [[nodiscard]] QPointF placeOf(std::size_t point) const;
    /// The point under the pointer, within a finger's width.
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF&) const;
    void emphasize(std::optional<std::size_t> point);

signals:
    void chosen(int point);   ///< By Enter, or a press of the left button on it.
    void hovered(int point);  ///< By the pointer, or the arrows. Stays until another one is, or until a press beside
                              ///< all of them: -1.

protected:
    void mouseMoveEvent(QMouseEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    void rebuild() override;
    void say();
    /// Those for which `holds` is true.
    [[nodiscard]] std::vector<const ChartPoint*> byCost(const std::function<bool(const ChartPoint&)>& holds) const;
    void addErrors(const QColor&, bool lined, double size, const std::function<bool(const ChartPoint&)>& holds);
    struct Label;
    void addMarks();
    [[nodiscard]] bool isMarked(std::size_t point) const;
    void addRings(std::size_t point);
    /// Adds the point's text to the label of one in the same place; false where there is none.
    bool sharesLabel(std::size_t point, std::vector<Label>&) const;
    /// None where it would write over another.
    void addLabel(std::size_t point, std::vector<Label>&);

    std::vector<ChartPoint> points_;
    std::optional<std::size_t> emphasized_;
    int hovered_ = -1;
};

/// The points of a study that are measured so far, as the chart shows them.
[[nodiscard]] std::vector<ChartPoint> chartPoints(Subjects, const StudyRequest&, const StudyResult&);
/// The same of a study that was kept.
[[nodiscard]] std::vector<ChartPoint> chartPoints(const KeptStudy&);
/// Title of the axis of costs: "field evaluations"; of a study that has none yet, "milliseconds".
[[nodiscard]] QString studyCostTitle(const std::string& costName);

}  // namespace vitrine::ui
