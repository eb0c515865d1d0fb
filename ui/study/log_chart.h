#pragma once

#include "ui/kit/accessible_plot.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::ui {

/// Size of exported charts in pixels. Bitmaps have twice as many.
inline constexpr QSize exportedChart(960, 600);

/// Position of one setting in a chart. A cost of 0 is unknown.
struct ChartSpan {
    double cost = 0, costLow = 0, costHigh = 0;
    double error = 0, errorLow = 0, errorHigh = 0;  ///< Mean and range of the error over the views.
    std::optional<double> modelError = {};          ///< Error against the exact reference, if it is shown as well.
};

/// Chart of error over cost, both logarithmic. Errors of 0 are on a line of their own at the bottom, "exact".
class LogChart : public AccessiblePlot {
    Q_OBJECT

public:
    explicit LogChart(QWidget* parent = nullptr);

    /// Sets the titles of the axes, which are shortened if there is no space.
    void setTitles(const QString& cost, const QString& error);
    /// Sets the sentence shown in place of an empty chart. Empty: the default, that no point is measured yet.
    void setEmptyText(const QString& text) { emptyText_ = text; }
    [[nodiscard]] const QString& costTitle() const { return costTitle_; }
    [[nodiscard]] const QString& errorTitle() const { return errorTitle_; }
    [[nodiscard]] const QString& emptyText() const { return emptyText_; }
    /// Applies the colors of the present theme.
    void applyColors();

    /// Sets the heading above the chart and the smaller line below it. They are left out of a chart of few lines'
    /// height.
    void setHeading(const QString& heading, const QString& details);

    /// Returns the chart in the colors of `paperTheme`, at a size in pixels. `scale`: pixels of the bitmap per pixel.
    [[nodiscard]] QImage picture(QSize size, double scale);
    [[nodiscard]] QByteArray svg(QSize size);
    /// Returns a file of one page that is as large as the chart, with fonts embedded.
    [[nodiscard]] QByteArray pdf(QSize size);

protected:
    void resizeEvent(QResizeEvent*) override;
    void changeEvent(QEvent*) override;

    /// Adds the content to the chart. Calls `begin` first, and uses the present colors and axes.
    virtual void build() = 0;
    /// Draws the content again in the present layout.
    void rebuild();
    /// Draws the content again and lays out the chart: for new points or titles.
    void arrange();
    /// Clears the chart and scales its axes to the points. Returns false if there is nothing to show; the chart then
    /// says so.
    bool begin(const std::vector<ChartSpan>&);
    [[nodiscard]] double shownError(double error) const { return error > 0 ? error : floor_; }
    /// Adds an error bar for the range of a point's error over the views.
    void addErrorBar(QCPErrorBars*, const ChartSpan&) const;
    [[nodiscard]] QCPErrorBars* addBars(QCPGraph*, const QColor&);
    /// Adds bars for the range of the costs, if they are times.
    void addTimes(const std::vector<ChartSpan>&, const QColor&);
    [[nodiscard]] QFont labelFont() const;
    /// Adds a graph to the legend; its name is shortened if there is no space.
    static void nameInLegend(QCPGraph&, const QString&);
    /// Sets the label of the line of exact settings; empty: "exact".
    void setExactText(const QString& text) { exactText_ = text; }
    /// Adds the line of settings with error 0, if there are any. Returns the rectangle of its label, in pixels.
    std::optional<QRectF> markExact();

private:
    void layOutFor(QSize);
    /// Calls `draw` while the chart has the layout for the size and the colors of `paperTheme`.
    void onPaper(QSize, const std::function<void()>& draw);
    void paintOn(QPaintDevice&, QSize);
    void fitHeading();
    void scaleAxes(const std::vector<ChartSpan>&);
    void applyType();
    void fitTitles();
    void fitLegend();

    QString costTitle_, errorTitle_, emptyText_, exactText_, heading_, details_;
    QCPTextElement* headingLine_;
    QCPTextElement* detailsLine_;
    double floor_ = 1e-6;  // Position of errors that are 0.
    bool anyExact_ = false;
};

}  // namespace vitrine::ui
