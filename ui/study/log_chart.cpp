#include "ui/study/log_chart.h"

#include "ui/kit/theme.h"

#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::ui {
namespace {

/// Ticks at 1, 2 and 5 of each decade, at 1 alone over many, and evenly spaced within less than one.
class DecadeTicker final : public QCPAxisTicker {
protected:
    int getSubTickCount(double) override { return 0; }
    QVector<double> createTickVector(double step, const QCPRange& range) override
    {
        const double decades = std::log10(range.upper / range.lower);
        if (!(decades > 0.8)) return QCPAxisTicker::createTickVector(step, range);
        QVector<double> ticks;
        for (double decade = std::pow(10, std::floor(std::log10(range.lower))); decade <= range.upper; decade *= 10)
            for (const double m : {1.0, 2.0, 5.0})
                if (m == 1 || decades < 4) ticks.append(m * decade);
        return ticks;
    }
};

}  // namespace

LogChart::LogChart(QWidget* parent) : SpokenPlot(parent)
{
    for (QCPAxis* axis : {xAxis, yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->setNumberFormat(QStringLiteral("gb"));
        axis->setNumberPrecision(6);
        axis->grid()->setSubGridVisible(false);
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new DecadeTicker));
    }
    setMinimumSize(320, 190);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LogChart::setTitles(const QString& cost, const QString& error)
{
    xAxis->setLabel(cost);
    yAxis->setLabel(error);
}

void LogChart::applyColors()
{
    const Theme& t = theme();
    setBackground(t.base);
    QColor faint = t.dim;
    faint.setAlphaF(0.25F);
    for (QCPAxis* axis : {xAxis, yAxis}) {
        for (const auto set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*set)(QPen(t.dim));
        axis->setTickLabelColor(t.text);
        axis->setLabelColor(t.text);
        axis->grid()->setPen(QPen(faint, 0));
    }
    rebuild();
}

void LogChart::scaleAxes(const std::vector<ChartSpan>& points)
{
    double lowX = std::numeric_limits<double>::infinity();
    double highX = 0;
    double lowY = lowX;
    double highY = 0;
    anyExact_ = false;
    for (const ChartSpan& p : points) {
        if (p.cost > 0) {
            lowX = std::min(lowX, p.costLow > 0 ? p.costLow : p.cost);
            highX = std::max({highX, p.cost, p.costHigh});
        }
        if (p.error > 0) {
            lowY = std::min({lowY, p.error, p.errorLow > 0 ? p.errorLow : p.error});
            highY = std::max({highY, p.error, p.errorHigh});
        } else {
            anyExact_ = true;
        }
    }
    if (!(highX > 0)) lowX = highX = 1;
    if (!(highY > 0)) lowY = highY = 1e-3;
    const double marginX = std::max(std::pow(highX / lowX, 0.09), 1.06);
    const double marginY = std::max(std::pow(highY / lowY, 0.14), 1.15);
    floor_ = lowY / (marginY * marginY);  // Room between it and the lowest error.
    xAxis->setRange(lowX / marginX, highX * marginX * std::pow(highX / lowX, 0.05));
    yAxis->setRange(anyExact_ ? floor_ / std::pow(marginY, 1.5) : lowY / marginY, highY * marginY);
}

bool LogChart::begin(const std::vector<ChartSpan>& points)
{
    clearPlottables();
    clearItems();
    scaleAxes(points);
    // Without a point there is no scale to show.
    const bool empty = std::none_of(points.begin(), points.end(), [](const ChartSpan& p) { return p.cost > 0; });
    for (QCPAxis* axis : {xAxis, yAxis}) axis->setVisible(!empty);
    if (!empty) return true;
    auto* nothing = new QCPItemText(this);
    nothing->setText(tr("No point is measured yet"));
    nothing->setColor(theme().dim);
    nothing->position->setType(QCPItemPosition::ptAxisRectRatio);
    nothing->position->setCoords(0.5, 0.5);
    replot(QCustomPlot::rpQueuedReplot);
    return false;
}

QCPErrorBars* LogChart::addBars(QCPGraph* graph, const QColor& color)
{
    auto* bars = new QCPErrorBars(xAxis, yAxis);
    bars->setDataPlottable(graph);
    bars->setPen(QPen(color, 1));
    bars->setWhiskerWidth(5);
    bars->removeFromLegend();
    return bars;
}

void LogChart::addErrorBar(QCPErrorBars* bars, const ChartSpan& p) const
{
    const bool exact = !(p.error > 0);
    bars->addData(exact ? 0 : p.error - std::max(p.errorLow, floor_), exact ? 0 : p.errorHigh - p.error);
}

void LogChart::addTimes(const std::vector<ChartSpan>& points, const QColor& color)
{
    QCPGraph* times = addGraph();
    times->removeFromLegend();
    times->setLineStyle(QCPGraph::lsNone);
    QCPErrorBars* bars = addBars(times, color);
    bars->setErrorType(QCPErrorBars::etKeyError);
    for (const ChartSpan& p : points) {
        if (!(p.costHigh > p.costLow)) continue;
        times->addData(p.cost, shownError(p.error));
        bars->addData(p.cost - p.costLow, p.costHigh - p.cost);
    }
}

QFont LogChart::labelFont() const
{
    return {font().family(), 8};
}

void LogChart::markExact()
{
    if (!anyExact_) return;
    const Theme& t = theme();
    auto* line = new QCPItemStraightLine(this);
    line->setPen(QPen(t.dim, 1, Qt::DotLine));
    line->point1->setCoords(xAxis->range().lower, floor_);
    line->point2->setCoords(xAxis->range().upper, floor_);
    auto* label = new QCPItemText(this);
    label->setText(tr("exact"));
    label->setColor(t.dim);
    label->setFont(labelFont());
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->position->setCoords(xAxis->range().lower, floor_);
    label->setPadding(QMargins(6, 3, 0, 0));
}

QImage LogChart::picture(QSize size, double scale)
{
    layOutFor(size);
    return toPixmap(size.width(), size.height(), scale).toImage();
}

QByteArray LogChart::svg(QSize size)
{
    layOutFor(size);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setTitle(yAxis->label());
    QCPPainter painter;
    painter.begin(&generator);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    toPainter(&painter, size.width(), size.height());
    painter.end();
    // A name that browsers know, too.
    return bytes.replace("font-family=\"Sans Serif\"", "font-family=\"sans-serif\"");
}

void LogChart::resizeEvent(QResizeEvent* event)
{
    SpokenPlot::resizeEvent(event);
    layOutFor(size());
}

/// Which labels have room is known once the axes are laid out for that size.
void LogChart::layOutFor(QSize size)
{
    setViewport(QRect(QPoint(0, 0), size));
    replot(QCustomPlot::rpImmediateRefresh);
    rebuild();
}

void LogChart::changeEvent(QEvent* event)
{
    SpokenPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) applyColors();
}

}  // namespace vitrine::ui

#include "moc_log_chart.cpp"
