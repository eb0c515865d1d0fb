#pragma once

#include "ui/kit/spoken_plot.h"

#include <vector>

namespace vitrine::ui {

/// Size of charts that are exported, pixels; pictures have twice as many.
inline constexpr QSize exportedChart(960, 600);

/// Where one setting is in a chart; 0 where a cost is not known.
struct ChartSpan {
    double cost = 0, costLow = 0, costHigh = 0;
    double error = 0, errorLow = 0, errorHigh = 0;  ///< Over the views.
};

/// Error over cost, both logarithmic. An error of 0 stands on a line of its own at the foot, "exact".
class LogChart : public SpokenPlot {
    Q_OBJECT

public:
    explicit LogChart(QWidget* parent = nullptr);

    void setTitles(const QString& cost, const QString& error);
    /// Colors of the theme in use.
    void applyColors();

    [[nodiscard]] QImage picture(QSize size, double scale);
    [[nodiscard]] QByteArray svg(QSize size);

protected:
    void resizeEvent(QResizeEvent*) override;
    void changeEvent(QEvent*) override;

    /// Draws what is to be seen anew, under the colors and axes that there are by then.
    virtual void rebuild() = 0;
    /// Clears the chart and scales its axes to these. Returns false where there is nothing to show, after saying so.
    bool begin(const std::vector<ChartSpan>&);
    [[nodiscard]] double shownError(double error) const { return error > 0 ? error : floor_; }
    /// The errors of the points over the views, as bars around the graph's points.
    void addErrorBar(QCPErrorBars*, const ChartSpan&) const;
    [[nodiscard]] QCPErrorBars* addBars(QCPGraph*, const QColor&);
    /// Bars of the costs, where they are times.
    void addTimes(const std::vector<ChartSpan>&, const QColor&);
    [[nodiscard]] QFont labelFont() const;
    /// The line of those whose error is 0, where there are any.
    void markExact();

private:
    void layOutFor(QSize);
    void scaleAxes(const std::vector<ChartSpan>&);

    double floor_ = 1e-6;  // Where an error of 0 stands.
    bool anyExact_ = false;
};

}  // namespace vitrine::ui
