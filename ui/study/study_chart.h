#pragma once

#include "exhibits/study/study_result.h"

#include "ui/kit/spoken_plot.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::ui {

/// What one point of the chart says.
struct ChartPoint {
    double cost = 0, costLow = 0, costHigh = 0;
    double error = 0, errorLow = 0, errorHigh = 0;  ///< Over the views.
    QString text;                                   ///< "64".
    bool dominated = false, onFront = false, knee = false, present = false;
};

/// Error over cost, both logarithmic: the front drawn through, what it dominates grayed, knee and present setting
/// marked. An error of 0 stands on a line of its own at the foot, "exact".
class StudyChart final : public SpokenPlot {
    Q_OBJECT

public:
    explicit StudyChart(QWidget* parent = nullptr);

    void setTitles(const QString& cost, const QString& error);
    void setPoints(std::vector<ChartPoint>);
    [[nodiscard]] const std::vector<ChartPoint>& points() const { return points_; }
    /// Colors of the theme in use.
    void applyColors();
    /// Where a point is, in pixels of the chart as it was last laid out.
    [[nodiscard]] QPointF placeOf(std::size_t point) const;
    /// The point under the pointer, within a finger's width.
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF&) const;
    void emphasize(std::optional<std::size_t> point);

    [[nodiscard]] QImage picture(QSize size, double scale);
    [[nodiscard]] QByteArray svg(QSize size);

signals:
    void chosen(int point);   ///< By Enter, or a press of the left button on it.
    void hovered(int point);  ///< By the pointer, or the arrows. Stays until another one is, or until a press beside
                              ///< all of them: -1.

protected:
    void mouseMoveEvent(QMouseEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void leaveEvent(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void changeEvent(QEvent*) override;

private:
    void rebuild();
    void say();
    void layOutFor(QSize);
    void scaleAxes();
    /// Those for which `holds` is true.
    [[nodiscard]] std::vector<const ChartPoint*> byCost(const std::function<bool(const ChartPoint&)>& holds) const;
    QCPErrorBars* addBars(QCPGraph*, const QColor&);
    void addErrors(const QColor&, bool lined, double size, const std::function<bool(const ChartPoint&)>& holds);
    /// Bars of the cost, where it is a time.
    void addTimes();
    struct Label;
    void addMarks();
    [[nodiscard]] bool isMarked(std::size_t point) const;
    void addRings(std::size_t point);
    [[nodiscard]] QFont labelFont() const;
    /// Adds the point's text to the label of one in the same place; false where there is none.
    bool sharesLabel(std::size_t point, std::vector<Label>&) const;
    /// None where it would write over another.
    void addLabel(std::size_t point, std::vector<Label>&);
    void markExact();
    [[nodiscard]] double shownError(double error) const;

    std::vector<ChartPoint> points_;
    std::optional<std::size_t> emphasized_;
    double floor_ = 1e-6;  // Where an error of 0 stands.
    bool anyExact_ = false;
    int hovered_ = -1;
};

/// The points of a study that are measured so far, as the chart shows them.
[[nodiscard]] std::vector<ChartPoint> chartPoints(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine::ui
