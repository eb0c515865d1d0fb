#include "ui/study/study_chart.h"

#include "exhibits/study/study_text.h"
#include "ui/kit/theme.h"

#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vitrine::ui {
namespace {

constexpr double fingerWidth = 18;  // Pixels around a point that count as on it.

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

StudyChart::StudyChart(QWidget* parent) : SpokenPlot(parent)
{
    setMouseTracking(true);
    setAccessibleName(tr("Error over cost"));
    for (QCPAxis* axis : {xAxis, yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->setNumberFormat(QStringLiteral("gb"));
        axis->setNumberPrecision(6);
        axis->grid()->setSubGridVisible(false);
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new DecadeTicker));
    }
    setMinimumSize(320, 190);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    applyColors();
}

void StudyChart::setTitles(const QString& cost, const QString& error)
{
    xAxis->setLabel(cost);
    yAxis->setLabel(error);
}

void StudyChart::setPoints(std::vector<ChartPoint> points)
{
    points_ = std::move(points);
    if (emphasized_ && *emphasized_ >= points_.size()) emphasized_.reset();
    rebuild();
    say();
}

void StudyChart::applyColors()
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

double StudyChart::shownError(double error) const
{
    return error > 0 ? error : floor_;
}

void StudyChart::scaleAxes()
{
    double lowX = std::numeric_limits<double>::infinity();
    double highX = 0;
    double lowY = lowX;
    double highY = 0;
    anyExact_ = false;
    for (const ChartPoint& p : points_) {
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

void StudyChart::rebuild()
{
    clearPlottables();
    clearItems();
    scaleAxes();
    const Theme& t = theme();
    // Without a point there is no scale to show.
    const bool empty = std::none_of(points_.begin(), points_.end(), [](const ChartPoint& p) { return p.cost > 0; });
    for (QCPAxis* axis : {xAxis, yAxis}) axis->setVisible(!empty);
    if (empty) {
        auto* nothing = new QCPItemText(this);
        nothing->setText(tr("No point is measured yet"));
        nothing->setColor(t.dim);
        nothing->position->setType(QCPItemPosition::ptAxisRectRatio);
        nothing->position->setCoords(0.5, 0.5);
        replot(QCustomPlot::rpQueuedReplot);
        return;
    }
    QColor gray = t.dim;
    gray.setAlphaF(0.55F);
    addErrors(gray, false, 6, [](const ChartPoint& p) { return !p.onFront; });
    addErrors(t.accent, true, 7, [](const ChartPoint& p) { return p.onFront; });
    addTimes();
    addMarks();
    replot(QCustomPlot::rpQueuedReplot);
}

std::vector<const ChartPoint*> StudyChart::byCost(const std::function<bool(const ChartPoint&)>& holds) const
{
    std::vector<const ChartPoint*> shown;
    for (const ChartPoint& p : points_)
        if (holds(p)) shown.push_back(&p);
    std::sort(shown.begin(), shown.end(), [](const ChartPoint* a, const ChartPoint* b) { return a->cost < b->cost; });
    return shown;
}

QCPErrorBars* StudyChart::addBars(QCPGraph* graph, const QColor& color)
{
    auto* bars = new QCPErrorBars(xAxis, yAxis);
    bars->setDataPlottable(graph);
    bars->setPen(QPen(color, 1));
    bars->setWhiskerWidth(5);
    return bars;
}

void StudyChart::addErrors(const QColor& color, bool lined, double size,
                           const std::function<bool(const ChartPoint&)>& holds)
{
    QCPGraph* graph = addGraph();
    QCPErrorBars* bars = addBars(graph, color);
    graph->setLineStyle(lined ? QCPGraph::lsLine : QCPGraph::lsNone);
    graph->setPen(QPen(color, lined ? 2 : 1.2));
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(color), QBrush(color), size));
    for (const ChartPoint* p : byCost(holds)) {
        graph->addData(p->cost, shownError(p->error));
        const bool exact = !(p->error > 0);
        bars->addData(exact ? 0 : p->error - std::max(p->errorLow, floor_), exact ? 0 : p->errorHigh - p->error);
    }
}

void StudyChart::addTimes()
{
    QCPGraph* times = addGraph();
    times->setLineStyle(QCPGraph::lsNone);
    QCPErrorBars* bars = addBars(times, theme().dim);
    bars->setErrorType(QCPErrorBars::etKeyError);
    for (const ChartPoint* p : byCost([](const ChartPoint& point) { return point.costHigh > point.costLow; })) {
        times->addData(p->cost, shownError(p->error));
        bars->addData(p->cost - p->costLow, p->costHigh - p->cost);
    }
}

/// A text beside a point, and the pixels that it takes.
struct StudyChart::Label {
    std::size_t point;
    QCPItemText* item;
    QRectF place;
};

void StudyChart::addMarks()
{
    const bool crowded = points_.size() > 24;
    std::vector<Label> labels;
    // Marked points first: where two would write over each other, the later one is silent.
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return isMarked(i); });
    for (const std::size_t i : order) {
        if (!(points_[i].cost > 0)) continue;
        addRings(i);
        if ((!isMarked(i) && crowded) || sharesLabel(i, labels)) continue;
        addLabel(i, labels);
    }
    if (anyExact_) markExact();
}

bool StudyChart::isMarked(std::size_t i) const
{
    return points_[i].knee || points_[i].present || emphasized_ == i;
}

void StudyChart::addRings(std::size_t i)
{
    const ChartPoint& p = points_[i];
    const auto ring = [&](const QColor& color, double size, QCPScatterStyle::ScatterShape shape) {
        QCPGraph* graph = addGraph();
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(shape, QPen(color, 2), Qt::NoBrush, size));
        graph->addData(p.cost, shownError(p.error));
    };
    const Theme& t = theme();
    if (p.present) ring(t.text, 15, QCPScatterStyle::ssDiamond);
    if (p.knee) ring(t.good, 15, QCPScatterStyle::ssCircle);
    if (emphasized_ == i) ring(t.accent, 20, QCPScatterStyle::ssCircle);
}

QFont StudyChart::labelFont() const
{
    return {font().family(), 8};
}

bool StudyChart::sharesLabel(std::size_t i, std::vector<Label>& labels) const
{
    const auto isAt = [&](std::size_t j) {
        if (!(points_[j].cost > 0)) return false;
        const double dx =
            std::log(points_[i].cost / points_[j].cost) / std::log(xAxis->range().upper / xAxis->range().lower);
        const double dy = std::log(shownError(points_[i].error) / shownError(points_[j].error)) /
                          std::log(yAxis->range().upper / yAxis->range().lower);
        return std::abs(dx) < 0.03 && std::abs(dy) < 0.02;
    };
    const auto same = std::find_if(labels.begin(), labels.end(), [&](const Label& other) {
        return !isMarked(i) && !isMarked(other.point) && isAt(other.point);
    });
    if (same == labels.end()) return false;
    same->item->setText(same->item->text() + QStringLiteral(", ") + points_[i].text);
    same->place.setWidth(QFontMetricsF(labelFont()).horizontalAdvance(same->item->text()) + 14);
    return true;
}

void StudyChart::addLabel(std::size_t i, std::vector<Label>& labels)
{
    const ChartPoint& p = points_[i];
    QString text = p.text;
    if (p.knee) text += tr(" · knee");
    if (p.present) text += tr(" · present");
    const bool atRightEdge =
        std::log(p.cost / xAxis->range().lower) > 0.8 * std::log(xAxis->range().upper / xAxis->range().lower);
    const QFontMetricsF metrics(labelFont());
    const QSizeF size(metrics.horizontalAdvance(text) + 14, metrics.height() + 5);
    const QPointF at = placeOf(i);
    const QRectF place(QPointF(atRightEdge ? at.x() - size.width() : at.x(), at.y() - size.height()), size);
    if (std::any_of(labels.begin(), labels.end(), [&](const Label& other) { return other.place.intersects(place); }))
        return;
    auto* label = new QCPItemText(this);
    label->setText(text);
    label->setColor(p.onFront ? theme().text : theme().dim);
    label->setFont(labelFont());
    label->setPositionAlignment((atRightEdge ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
    label->position->setType(QCPItemPosition::ptPlotCoords);
    label->position->setCoords(p.cost, shownError(p.error));
    label->setPadding(QMargins(7, 0, 7, 5));
    label->setSelectable(false);
    labels.push_back({i, label, place});
}

void StudyChart::markExact()
{
    const Theme& t = theme();
    auto* line = new QCPItemStraightLine(this);
    line->setPen(QPen(t.dim, 1, Qt::DotLine));
    line->point1->setCoords(xAxis->range().lower, floor_);
    line->point2->setCoords(xAxis->range().upper, floor_);
    auto* label = new QCPItemText(this);
    label->setText(tr("exact"));
    label->setColor(t.dim);
    label->setFont(QFont(font().family(), 8));
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->position->setCoords(xAxis->range().lower, floor_);
    label->setPadding(QMargins(6, 3, 0, 0));
}

QPointF StudyChart::placeOf(std::size_t point) const
{
    const ChartPoint& p = points_.at(point);
    return {xAxis->coordToPixel(p.cost), yAxis->coordToPixel(shownError(p.error))};
}

std::optional<std::size_t> StudyChart::pointAt(const QPointF& at) const
{
    std::optional<std::size_t> nearest;
    double closest = fingerWidth;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!(points_[i].cost > 0)) continue;
        const QPointF d = placeOf(i) - at;
        if (std::hypot(d.x(), d.y()) < closest) {
            closest = std::hypot(d.x(), d.y());
            nearest = i;
        }
    }
    return nearest;
}

void StudyChart::emphasize(std::optional<std::size_t> point)
{
    if (point == emphasized_) return;
    emphasized_ = point;
    rebuild();
    say();
}

void StudyChart::say()
{
    const auto measured = byCost([](const ChartPoint& p) { return p.cost > 0; });
    if (measured.empty()) return setSentences(tr("No point is measured yet"));
    const auto number = [](double value) { return QString::number(value, 'g', 3); };
    QStringList all{tr("%1 over %2, both logarithmic: %n points.", nullptr, static_cast<int>(measured.size()))
                        .arg(yAxis->label(), xAxis->label())};
    const auto add = [&](const ChartPoint& p, const QString& sentence) {
        all << sentence.arg(p.text, number(p.error), number(p.cost));
    };
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const ChartPoint& p = points_[i];
        if (emphasized_ == i) add(p, tr("Chosen: %1, error %2, cost %3."));
        if (p.present) add(p, tr("Present: %1, error %2, cost %3."));
        if (p.knee) add(p, tr("The knee: %1, error %2, cost %3."));
    }
    all << tr("Arrows go from point to point, Enter applies one.");
    setSentences(all.join(QLatin1Char(' ')));
}

void StudyChart::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up    ? 1
                     : event->key() == Qt::Key_Left || event->key() == Qt::Key_Down ? -1
                                                                                    : 0;
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const auto order = byCost([](const ChartPoint& p) { return p.cost > 0; });
    if (order.empty() || (step == 0 && !enter)) return SpokenPlot::keyPressEvent(event);
    if (enter) {
        if (emphasized_) emit chosen(static_cast<int>(*emphasized_));
        return;
    }
    const auto at = emphasized_ ? std::find(order.begin(), order.end(), &points_[*emphasized_]) : order.end();
    auto next = at - order.begin();
    if (at == order.end())
        next = step > 0 ? 0 : static_cast<std::ptrdiff_t>(order.size()) - 1;
    else
        next = std::clamp<std::ptrdiff_t>(next + step, 0, static_cast<std::ptrdiff_t>(order.size()) - 1);
    emit hovered(static_cast<int>(order[static_cast<std::size_t>(next)] - points_.data()));
}

QImage StudyChart::picture(QSize size, double scale)
{
    layOutFor(size);
    return toPixmap(size.width(), size.height(), scale).toImage();
}

QByteArray StudyChart::svg(QSize size)
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

void StudyChart::mouseMoveEvent(QMouseEvent* event)
{
    SpokenPlot::mouseMoveEvent(event);
    const auto point = pointAt(event->position());
    const int now = point ? static_cast<int>(*point) : -1;
    if (now == hovered_) return;
    hovered_ = now;
    setCursor(now >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    // The last one stays on show beside the chart, so that the pointer can go there; only another one takes its place.
    if (now >= 0) emit hovered(now);
}

void StudyChart::mousePressEvent(QMouseEvent* event)
{
    SpokenPlot::mousePressEvent(event);
    const auto point = pointAt(event->position());
    if (!point)
        emit hovered(-1);
    else if (event->button() == Qt::LeftButton)
        emit chosen(static_cast<int>(*point));
}

void StudyChart::resizeEvent(QResizeEvent* event)
{
    SpokenPlot::resizeEvent(event);
    layOutFor(size());
}

/// Which labels have room is known once the axes are laid out for that size.
void StudyChart::layOutFor(QSize size)
{
    setViewport(QRect(QPoint(0, 0), size));
    replot(QCustomPlot::rpImmediateRefresh);
    rebuild();
}

void StudyChart::leaveEvent(QEvent* event)
{
    SpokenPlot::leaveEvent(event);
    hovered_ = -1;
}

void StudyChart::changeEvent(QEvent* event)
{
    SpokenPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) applyColors();
}

std::vector<ChartPoint> chartPoints(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    std::vector<ChartPoint> points;
    const bool timed = result.costName == "ms";
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const StudyPoint& p = result.points[i];
        ChartPoint c;
        const bool measured =
            std::all_of(p.shots.begin(), p.shots.end(), [](const StudyShot& shot) { return !shot.picture.empty(); });
        if (measured) c.cost = c.costLow = c.costHigh = p.cost;
        if (measured && timed && p.time) {
            c.costLow = p.time->interval.low;
            c.costHigh = p.time->interval.high;
        }
        c.error = p.error;
        c.errorLow = p.lowestError;
        c.errorHigh = p.worstError;
        const std::string text = request.axes.size() == 1 ? axisValueText(request.sceneState, request.axes[0],
                                                                          request.axes[0].values[p.setting[0]])
                                                          : pointText(subjects, request, p);
        c.text = QString::fromStdString(request.axes.size() > 2 ? std::string() : text);
        c.dominated = p.dominated;
        c.onFront = std::find(result.front.begin(), result.front.end(), i) != result.front.end();
        c.knee = result.knee == i;
        c.present = result.present == i;
        points.push_back(std::move(c));
    }
    return points;
}

}  // namespace vitrine::ui

#include "moc_study_chart.cpp"
