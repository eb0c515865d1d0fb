#pragma once

#include "ui/kit/spoken_plot.h"

#include <optional>
#include <vector>

namespace vitrine::ui {

/// Size of charts that are exported, pixels; pictures have twice as many.
inline constexpr QSize exportedChart(960, 600);

/// Where one setting is in a chart; 0 where a cost is not known.
struct ChartSpan {
    double cost = 0, costLow = 0, costHigh = 0;
    double error = 0, errorLow = 0, errorHigh = 0;  ///< Over the views.
    std::optional<double> modelError = {};          ///< Against everything exact, where it is shown as well.
};

/// Error over cost, both logarithmic. An error of 0 stands on a line of its own at the foot, "exact".
class LogChart : public SpokenPlot {
    Q_OBJECT

public:
    explicit LogChart(QWidget* parent = nullptr);

    /// Titles are shown as far as there is room.
    void setTitles(const QString& cost, const QString& error);
    /// The sentence in place of an empty chart; empty: that no point is measured yet.
    void setEmptyText(const QString& text) { emptyText_ = text; }
    [[nodiscard]] const QString& costTitle() const { return costTitle_; }
    [[nodiscard]] const QString& errorTitle() const { return errorTitle_; }
    [[nodiscard]] const QString& emptyText() const { return emptyText_; }
    /// Colors of the theme in use.
    void applyColors();

    [[nodiscard]] QImage picture(QSize size, double scale);
    [[nodiscard]] QByteArray svg(QSize size);

protected:
    void resizeEvent(QResizeEvent*) override;
    void changeEvent(QEvent*) override;

    /// Adds what is to be seen to the chart, after `begin`, under the colors and axes that there are by then.
    virtual void build() = 0;
    /// Draws it anew within the layout that there is.
    void rebuild();
    /// Draws it anew and lays it out: for other points or titles.
    void arrange();
    /// Clears the chart and scales its axes to these. Returns false where there is nothing to show, after saying so.
    bool begin(const std::vector<ChartSpan>&);
    [[nodiscard]] double shownError(double error) const { return error > 0 ? error : floor_; }
    /// The errors of the points over the views, as bars around the graph's points.
    void addErrorBar(QCPErrorBars*, const ChartSpan&) const;
    [[nodiscard]] QCPErrorBars* addBars(QCPGraph*, const QColor&);
    /// Bars of the costs, where they are times.
    void addTimes(const std::vector<ChartSpan>&, const QColor&);
    [[nodiscard]] QFont labelFont() const;
    /// Adds a graph to the legend, with as much of its name as there is room for.
    static void nameInLegend(QCPGraph&, const QString&);
    /// What the line of exact settings is called; empty: "exact".
    void setExactText(const QString& text) { exactText_ = text; }
    /// The line of those whose error is 0, where there are any. Returns where its name stands, in pixels.
    std::optional<QRectF> markExact();

private:
    void layOutFor(QSize);
    void scaleAxes(const std::vector<ChartSpan>&);
    void applyType();
    void fitTitles();
    void fitLegend();

    QString costTitle_, errorTitle_, emptyText_, exactText_;
    double floor_ = 1e-6;  // Where an error of 0 stands.
    bool anyExact_ = false;
};

}  // namespace vitrine::ui
