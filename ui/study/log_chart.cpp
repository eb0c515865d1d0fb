#include "ui/study/log_chart.h"

#include "ui/kit/roomy_ticker.h"
#include "ui/kit/theme.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::ui {
namespace {

constexpr double smallType = 0.85;  // Size of labels within the chart, relative to its font.

/// Breaks the text into lines no wider than `width` pixels, between words.
QString inLines(const QString& text, const QFontMetrics& metrics, int width)
{
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        lines << QString();
        for (const QString& word : paragraph.split(QLatin1Char(' '))) {
            const QString longer = lines.back().isEmpty() ? word : lines.back() + QLatin1Char(' ') + word;
            if (lines.back().isEmpty() || metrics.horizontalAdvance(longer) <= width)
                lines.back() = longer;
            else
                lines << word;
        }
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

LogChart::LogChart(QWidget* parent)
    : AccessiblePlot(parent), headingLine_(new QCPTextElement(this)), detailsLine_(new QCPTextElement(this))
{
    for (QCPAxis* axis : {xAxis, yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->grid()->setSubGridVisible(false);
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new RoomyTicker(*axis)));
    }
    setAutoAddPlottableToLegend(false);
    // The legend is above the axes, so that it covers no curve.
    auto* top = new QCPLayoutGrid;
    plotLayout()->insertRow(0);
    plotLayout()->addElement(0, 0, top);
    plotLayout()->setRowStretchFactor(0, 0.001);
    top->addElement(0, 0, legend);
    // This element takes the space that the legend leaves. An empty legend would leave the axes no space.
    top->addElement(0, 1, new QCPLayoutElement);
    top->setColumnStretchFactor(0, 0.001);
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    for (QCPTextElement* line : {detailsLine_, headingLine_}) {
        plotLayout()->insertRow(0);
        plotLayout()->addElement(0, 0, line);
        plotLayout()->setRowStretchFactor(0, 0.001);
        line->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    }
    setMinimumSize(320, 190);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LogChart::setTitles(const QString& cost, const QString& error)
{
    costTitle_ = cost;
    errorTitle_ = error;
    xAxis->setLabel(cost);
    yAxis->setLabel(error);
}

void LogChart::setHeading(const QString& heading, const QString& details)
{
    heading_ = heading;
    details_ = details;
}

/// Shortens heading and details to the width of the chart. Empty lines take no space.
void LogChart::fitHeading()
{
    const bool isHigh = viewport().height() >= 12 * QFontMetrics(font()).height();
    const auto fit = [&](QCPTextElement& line, const QString& text) {
        const bool isShown = isHigh && !text.isEmpty();
        line.setText(isShown ? QFontMetrics(line.font()).elidedText(text, Qt::ElideRight, viewport().width() - 16)
                             : QString());
        line.setVisible(isShown);
        line.setMaximumSize(QWIDGETSIZE_MAX, isShown ? QWIDGETSIZE_MAX : 0);
        line.setMargins(isShown ? QMargins(6, 3, 6, 0) : QMargins());
    };
    fit(*headingLine_, heading_);
    fit(*detailsLine_, details_);
}

void LogChart::applyType()
{
    QFont heavy = font();
    heavy.setBold(true);
    headingLine_->setFont(heavy);
    detailsLine_->setFont(labelFont());
    for (QCPAxis* axis : {xAxis, yAxis}) {
        axis->setLabelFont(font());
        axis->setTickLabelFont(labelFont());
    }
    legend->setFont(labelFont());
}

/// Shortens titles to the length of the chart, with an ellipsis.
void LogChart::fitTitles()
{
    const QRect inner = axisRect()->rect();
    const QRect all = viewport();
    const QFontMetrics metrics(xAxis->labelFont());
    const auto fit = [&](QCPAxis& axis, const QString& title, int middle, int low, int high) {
        axis.setLabel(metrics.elidedText(title, Qt::ElideRight, 2 * std::min(middle - low, high - middle) - 4));
    };
    fit(*xAxis, costTitle_, inner.center().x(), all.left(), all.right());
    fit(*yAxis, errorTitle_, inner.center().y(), all.top(), all.bottom());
}

void LogChart::fitLegend()
{
    if (legend->itemCount() == 0) return;
    const int width = viewport().width();
    const QFontMetrics metrics(legend->font());
    // A chart of a few lines' height has no space for a legend.
    legend->setVisible(viewport().height() >= 12 * metrics.height());
    const int beside = legend->iconSize().width() + 24;
    int widest = 1;
    for (int i = 0; i < legend->itemCount(); ++i) {
        auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(i));
        if (item == nullptr) continue;
        const QString name = item->plottable()->property("fullName").toString();
        item->plottable()->setName(metrics.elidedText(name, Qt::ElideRight, (width - beside) * 9 / 10));
        widest = std::max(widest, metrics.horizontalAdvance(name) + beside);
    }
    legend->setWrap(std::clamp(width / widest, 1, std::max(legend->itemCount(), 1)));
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void LogChart::nameInLegend(QCPGraph& graph, const QString& name)
{
    graph.setProperty("fullName", name);
    graph.setName(name);
    graph.addToLegend();
}

void LogChart::applyColors()
{
    applyTheme();
    legend->setIconSize(36, 14);
    headingLine_->setTextColor(theme().text);
    detailsLine_->setTextColor(theme().dim);
    applyType();
    arrange();
}

void LogChart::scaleAxes(const std::vector<ChartSpan>& points)
{
    double lowX = std::numeric_limits<double>::infinity();
    double highX = 0;
    double lowY = lowX;
    double highY = 0;
    anyExact_ = false;
    for (const ChartSpan& p : points) {
        if (!(p.cost > 0)) continue;
        lowX = std::min(lowX, p.costLow > 0 ? p.costLow : p.cost);
        highX = std::max({highX, p.cost, p.costHigh});
        if (p.error > 0) {
            lowY = std::min({lowY, p.error, p.errorLow > 0 ? p.errorLow : p.error});
            highY = std::max({highY, p.error, p.errorHigh});
        } else {
            anyExact_ = true;
        }
        if (!p.modelError) continue;
        if (*p.modelError > 0) {
            lowY = std::min(lowY, *p.modelError);
            highY = std::max(highY, *p.modelError);
        } else {
            anyExact_ = true;
        }
    }
    if (!(highX > 0)) lowX = highX = 1;
    if (!(highY > 0)) lowY = highY = 1e-3;
    const double marginX = std::max(std::pow(highX / lowX, 0.09), 1.06);
    const double marginY = std::max(std::pow(highY / lowY, 0.14), 1.15);
    floor_ = lowY / (marginY * marginY);  // Leaves space between the line of exact settings and the lowest error.
    xAxis->setRange(lowX / marginX, highX * marginX * std::pow(highX / lowX, 0.05));
    yAxis->setRange(anyExact_ ? floor_ / std::pow(marginY, 1.5) : lowY / marginY, highY * marginY);
}

bool LogChart::begin(const std::vector<ChartSpan>& points)
{
    legend->clearItems();
    clearPlottables();
    clearItems();
    scaleAxes(points);
    // Without points there are no axes.
    const bool empty = std::none_of(points.begin(), points.end(), [](const ChartSpan& p) { return p.cost > 0; });
    for (QCPAxis* axis : {xAxis, yAxis}) axis->setVisible(!empty);
    legend->setVisible(false);
    if (!empty) return true;
    auto* nothing = new QCPItemText(this);
    nothing->setText(inLines(emptyText_.isEmpty() ? tr("No point is measured yet") : emptyText_,
                             QFontMetrics(labelFont()), viewport().width() - 24));
    nothing->setColor(theme().dim);
    nothing->setFont(labelFont());
    nothing->setTextAlignment(Qt::AlignCenter);
    nothing->position->setType(QCPItemPosition::ptAxisRectRatio);
    nothing->position->setCoords(0.5, 0.5);
    return false;
}

QCPErrorBars* LogChart::addBars(QCPGraph* graph, const QColor& color)
{
    auto* bars = new QCPErrorBars(xAxis, yAxis);
    bars->setDataPlottable(graph);
    bars->setPen(QPen(color, 1));
    bars->setWhiskerWidth(5);
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
    times->setLineStyle(QCPGraph::lsNone);
    QCPErrorBars* bars = addBars(times, color);
    bars->setErrorType(QCPErrorBars::etKeyError);
    // A graph sorts its points by cost, and error bars belong to points by index.
    std::vector<ChartSpan> sorted = points;
    std::sort(sorted.begin(), sorted.end(), [](const ChartSpan& a, const ChartSpan& b) { return a.cost < b.cost; });
    for (const ChartSpan& p : sorted) {
        if (!(p.cost > 0) || !(p.costHigh > p.costLow)) continue;
        times->addData(p.cost, shownError(p.error));
        bars->addData(p.cost - p.costLow, p.costHigh - p.cost);
    }
}

QFont LogChart::labelFont() const
{
    QFont small = font();
    if (small.pointSizeF() > 0) small.setPointSizeF(smallType * small.pointSizeF());
    return small;
}

std::optional<QRectF> LogChart::markExact()
{
    if (!anyExact_) return std::nullopt;
    const Theme& t = theme();
    auto* line = new QCPItemStraightLine(this);
    line->setPen(QPen(t.dim, 1, Qt::DotLine));
    line->point1->setCoords(xAxis->range().lower, floor_);
    line->point2->setCoords(xAxis->range().upper, floor_);
    auto* label = new QCPItemText(this);
    const QPointF at(xAxis->coordToPixel(xAxis->range().lower), yAxis->coordToPixel(floor_));
    const QFontMetricsF metrics(labelFont());
    const bool isWhole =
        !exactText_.isEmpty() && metrics.horizontalAdvance(exactText_) + 24 < axisRect()->rect().right() - at.x();
    label->setText(isWhole ? exactText_ : tr("exact"));
    label->setColor(t.dim);
    label->setFont(labelFont());
    label->position->setCoords(xAxis->range().lower, floor_);
    const QSizeF size(metrics.horizontalAdvance(label->text()) + 12, metrics.height() + 3);
    // Below the line, or above it if there is no space.
    const bool below = at.y() + size.height() < axisRect()->rect().bottom();
    label->setPositionAlignment(Qt::AlignLeft | (below ? Qt::AlignTop : Qt::AlignBottom));
    label->setPadding(below ? QMargins(6, 3, 6, 0) : QMargins(6, 0, 6, 3));
    return QRectF(below ? at : at - QPointF(0, size.height()), size);
}

void LogChart::onPaper(QSize size, const std::function<void()>& draw)
{
    {
        const ThemeScope paper(paperTheme());
        setViewport(QRect(QPoint(0, 0), size));
        applyColors();
        draw();
    }
    // Restores colors and layout of the screen.
    if (parentWidget() != nullptr) setViewport(QRect(QPoint(0, 0), this->size()));
    applyColors();
}

QImage LogChart::picture(QSize size, double scale)
{
    QImage image;
    onPaper(size, [&] { image = toPixmap(size.width(), size.height(), scale).toImage(); });
    return image;
}

void LogChart::paintOn(QPaintDevice& device, QSize size)
{
    QCPPainter painter;
    painter.begin(&device);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    toPainter(&painter, size.width(), size.height());
    painter.end();
}

QByteArray LogChart::pdf(QSize size)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QBuffer::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setCreator(QStringLiteral("Vitrine"));
    writer.setTitle(heading_.isEmpty() ? errorTitle_ : heading_);
    writer.setResolution(logicalDpiX());  // Text gets the size for which it was laid out.
    writer.setPageSize(QPageSize(QSizeF(size) * 72 / logicalDpiX(), QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    onPaper(size, [&] { paintOn(writer, size); });
    return bytes;
}

QByteArray LogChart::svg(QSize size)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setTitle(heading_.isEmpty() ? errorTitle_ : heading_);
    generator.setResolution(logicalDpiX());
    onPaper(size, [&] { paintOn(generator, size); });
    // Replaces Qt's font family by one that browsers know.
    return bytes.replace("font-family=\"Sans Serif\"", "font-family=\"sans-serif\"");
}

void LogChart::resizeEvent(QResizeEvent* event)
{
    AccessiblePlot::resizeEvent(event);
    layOutFor(size());
}

/// Lays out the chart for a size. Which labels fit is known only after the axes are laid out.
void LogChart::layOutFor(QSize size)
{
    setViewport(QRect(QPoint(0, 0), size));
    arrange();
}

void LogChart::rebuild()
{
    build();
    fitLegend();
    replot(QCustomPlot::rpQueuedReplot);
}

void LogChart::arrange()
{
    fitHeading();
    build();
    fitLegend();
    // Margins depend on tick labels, and ticks on the axis length that the margins leave. Two passes settle both.
    for (int i = 0; i < 2; ++i) {
        replot(QCustomPlot::rpQueuedRefresh);
        fitTitles();
    }
    rebuild();
}

void LogChart::changeEvent(QEvent* event)
{
    AccessiblePlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) applyColors();
    if (event->type() == QEvent::FontChange) {
        applyType();
        arrange();
    }
}

}  // namespace vitrine::ui

#include "moc_log_chart.cpp"
