#pragma once

#include "exhibits/study/study_costs.h"

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

/// A study as a chart shows it over one axis of costs.
struct ChartedStudy {
    QString costTitle, errorTitle;
    QString emptyText;  ///< Why there is no point, as long as there is none.
    std::vector<ChartPoint> points;
    std::size_t parameters = 1;  ///< Number of parameters that it varies.
    QString law;                 ///< What halving the error costs on this axis, as a sentence; empty: nothing to say.
};

/// Error over cost: the front drawn through, what it dominates grayed, knee and present setting marked.
class StudyChart final : public LogChart {
    Q_OBJECT

public:
    explicit StudyChart(QWidget* parent = nullptr);

    void showStudy(ChartedStudy);
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
    void build() override;
    void say();
    /// Those for which `holds` is true.
    [[nodiscard]] std::vector<const ChartPoint*> byCost(const std::function<bool(const ChartPoint&)>& holds) const;
    QCPGraph* addErrors(const QColor&, bool lined, double size, const std::function<bool(const ChartPoint&)>& holds);
    /// The second line: what is left against everything exact, where that is another error than the first line's.
    void addModelErrors(QCPGraph& front);
    [[nodiscard]] bool hasModelErrors() const;
    struct Label;
    void addMarks();
    [[nodiscard]] bool isMarked(std::size_t point) const;
    void addRings(std::size_t point);
    /// Adds the point's text to the label of one in the same place; false where there is none.
    bool sharesLabel(std::size_t point, std::vector<Label>&) const;
    /// Above or below the point, to its right or left, where it covers no other text and no point; else nowhere.
    void addLabel(std::size_t point, std::vector<Label>&);
    [[nodiscard]] bool isFree(const QRectF&, std::size_t point, const std::vector<Label>&) const;
    /// The lines of the fronts, in pixels.
    [[nodiscard]] std::vector<QLineF> curves() const;

    std::vector<ChartPoint> points_;
    std::size_t parameters_ = 1;
    std::optional<std::size_t> emphasized_;
    int hovered_ = -1;
};

/// A study as far as it is measured.
[[nodiscard]] ChartedStudy charted(Subjects, const StudyRequest&, const StudyResult&, CostAxis);
/// The same of a study that was kept.
[[nodiscard]] ChartedStudy charted(const KeptStudy&, CostAxis);
/// A setting in words: "Shell count 64", "as at present".
[[nodiscard]] QString settingWords(const std::vector<SettingPart>&);

}  // namespace vitrine::ui
