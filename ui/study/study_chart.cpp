#include "ui/study/study_chart.h"

#include "exhibits/study/study_text.h"
#include "ui/kit/language.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vitrine::ui {
namespace {

constexpr double fingerWidth = 18;  // Pixels around a point that count as on it.

}  // namespace

StudyChart::StudyChart(QWidget* parent) : LogChart(parent)
{
    setMouseTracking(true);
    setAccessibleName(tr("Error over cost"));
    applyColors();
}

void StudyChart::setPoints(std::vector<ChartPoint> points)
{
    points_ = std::move(points);
    if (emphasized_ && *emphasized_ >= points_.size()) emphasized_.reset();
    rebuild();
    say();
}

void StudyChart::rebuild()
{
    if (!begin({points_.begin(), points_.end()})) return;
    const Theme& t = theme();
    QColor gray = t.dim;
    gray.setAlphaF(0.55F);
    addErrors(gray, false, 6, [](const ChartPoint& p) { return !p.onFront; });
    addErrors(t.accent, true, 7, [](const ChartPoint& p) { return p.onFront; });
    addTimes({points_.begin(), points_.end()}, t.dim);
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
        addErrorBar(bars, *p);
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
    markExact();
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
    if (order.empty() || (step == 0 && !enter)) return LogChart::keyPressEvent(event);
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

void StudyChart::mouseMoveEvent(QMouseEvent* event)
{
    LogChart::mouseMoveEvent(event);
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
    LogChart::mousePressEvent(event);
    const auto point = pointAt(event->position());
    if (!point)
        emit hovered(-1);
    else if (event->button() == Qt::LeftButton)
        emit chosen(static_cast<int>(*point));
}

void StudyChart::leaveEvent(QEvent* event)
{
    LogChart::leaveEvent(event);
    hovered_ = -1;
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
        c.text = said(request.axes.size() > 2 ? std::string() : text);
        c.dominated = p.dominated;
        c.onFront = std::find(result.front.begin(), result.front.end(), i) != result.front.end();
        c.knee = result.knee == i;
        c.present = result.present == i;
        points.push_back(std::move(c));
    }
    return points;
}

std::vector<ChartPoint> chartPoints(const KeptStudy& study)
{
    std::vector<ChartPoint> points;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const KeptPoint& p = study.points[i];
        ChartPoint c;
        if (p.measured()) c.cost = c.costLow = c.costHigh = p.cost;
        if (p.measured() && study.cost == "ms" && p.time) {
            c.costLow = p.time->interval.low;
            c.costHigh = p.time->interval.high;
        }
        c.error = std::isfinite(p.error) ? p.error : 0;
        c.errorLow = std::min(p.lowestError, c.error);
        c.errorHigh = std::isfinite(p.worstError) ? std::max(p.worstError, c.error) : c.error;
        if (study.parameters.size() <= 2) c.text = said(study.pointText(i));
        c.onFront = std::find(study.front.begin(), study.front.end(), i) != study.front.end();
        c.dominated = !c.onFront;
        c.knee = study.knee == i;
        points.push_back(std::move(c));
    }
    return points;
}

QString studyCostTitle(const std::string& costName)
{
    return said(costTitle(costName.empty() ? "ms" : costName));
}

}  // namespace vitrine::ui

#include "moc_study_chart.cpp"
