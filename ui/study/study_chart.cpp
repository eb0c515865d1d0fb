#include "ui/study/study_chart.h"

#include "exhibits/study/study_text.h"
#include "ui/kit/language.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr double fingerWidth = 18;  // Pixels around a point within which the pointer hits it.
constexpr double pointRadius = 4;   // Pixels of a point that no label may cover.
constexpr int besideLabel = 7;      // Pixels between a label and the center of its point, horizontally.
constexpr int aboveLabel = 5;       // The same vertically.
constexpr double sameError = 1e-9;  // Relative difference below which errors count as equal.

/// Returns whether any part of the line is in the rectangle.
bool crosses(const QLineF& line, const QRectF& place)
{
    if (place.contains(line.p1()) || place.contains(line.p2())) return true;
    const QLineF sides[] = {{place.topLeft(), place.topRight()},
                            {place.topRight(), place.bottomRight()},
                            {place.bottomRight(), place.bottomLeft()},
                            {place.bottomLeft(), place.topLeft()}};
    return std::any_of(std::begin(sides), std::end(sides), [&](const QLineF& side) {
        return line.intersects(side, nullptr) == QLineF::BoundedIntersection;
    });
}

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
    arrange();
    say();
}

void StudyChart::showStudy(ChartedStudy study)
{
    setTitles(study.costTitle, study.errorTitle);
    setHeading(study.heading, study.details);
    setEmptyText(study.emptyText);
    parameters_ = study.parameters;
    setPoints(std::move(study.points));
}

bool StudyChart::hasModelErrors() const
{
    return std::any_of(points_.begin(), points_.end(), [](const ChartPoint& p) {
        return p.cost > 0 && p.modelError &&
               std::abs(*p.modelError - p.error) > sameError * std::max(*p.modelError, p.error);
    });
}

void StudyChart::build()
{
    const bool both = hasModelErrors();
    std::vector<ChartSpan> spans{points_.begin(), points_.end()};
    if (!both)
        for (ChartSpan& span : spans) span.modelError.reset();
    setExactText(!both              ? QString()
                 : parameters_ == 1 ? tr("exact in this parameter")
                                    : tr("exact in these parameters"));
    if (!begin(spans)) return;
    const Theme& t = theme();
    QColor gray = t.dim;
    gray.setAlphaF(0.55F);
    addErrors(gray, false, 6, [](const ChartPoint& p) { return !p.onFront; });
    QCPGraph* front = addErrors(t.accent, true, 7, [](const ChartPoint& p) { return p.onFront; });
    if (both) addModelErrors(*front);
    addTimes(spans, t.dim);
    addMarks();
}

void StudyChart::addModelErrors(QCPGraph& front)
{
    const Theme& t = theme();
    nameInLegend(front, parameters_ == 1 ? tr("against this parameter exact") : tr("against these parameters exact"));
    for (const bool onFront : {false, true}) {
        QCPGraph* graph = addGraph();
        graph->setLineStyle(onFront ? QCPGraph::lsLine : QCPGraph::lsNone);
        graph->setPen(QPen(t.good, 1.5, Qt::DashLine));
        graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(t.good, 1.5), QBrush(t.base), 7));
        for (const ChartPoint* p :
             byCost([&](const ChartPoint& each) { return each.onFront == onFront && each.modelError; }))
            graph->addData(p->cost, shownError(*p->modelError));
        if (onFront) nameInLegend(*graph, tr("against everything exact"));
    }
    legend->setVisible(true);
}

std::vector<const ChartPoint*> StudyChart::byCost(const std::function<bool(const ChartPoint&)>& holds) const
{
    std::vector<const ChartPoint*> shown;
    for (const ChartPoint& p : points_)
        if (p.cost > 0 && holds(p)) shown.push_back(&p);
    std::sort(shown.begin(), shown.end(), [](const ChartPoint* a, const ChartPoint* b) { return a->cost < b->cost; });
    return shown;
}

QCPGraph* StudyChart::addErrors(const QColor& color, bool lined, double size,
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
    return graph;
}

/// Label of a point, and its rectangle in pixels.
struct StudyChart::Label {
    std::size_t point;
    QCPItemText* item;
    QRectF place;
};

void StudyChart::addMarks()
{
    const bool crowded = points_.size() > 24;
    std::vector<Label> labels;
    if (const std::optional<QRectF> exact = markExact()) labels.push_back({points_.size(), nullptr, *exact});
    // Marked points come first: a label that would cover an earlier one is left out.
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return isMarked(i); });
    for (const std::size_t i : order) {
        if (!(points_[i].cost > 0)) continue;
        addRings(i);
        if ((!isMarked(i) && crowded) || sharesLabel(i, labels)) continue;
        addLabel(i, labels);
    }
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
        return other.item != nullptr && !isMarked(i) && !isMarked(other.point) && isAt(other.point);
    });
    if (same == labels.end()) return false;
    const QString text = same->item->text() + QStringLiteral(", ") + points_[i].text;
    QRectF place = same->place;
    const double more = QFontMetricsF(labelFont()).horizontalAdvance(text) + 2 * besideLabel - place.width();
    if (same->item->positionAlignment() & Qt::AlignRight)
        place.setLeft(place.left() - more);
    else
        place.setRight(place.right() + more);
    std::vector<Label> others = labels;
    others.erase(others.begin() + (same - labels.begin()));
    if (!isFree(place, same->point, others)) return true;  // If both names do not fit, only one is shown.
    same->item->setText(text);
    same->place = place;
    return true;
}

bool StudyChart::isFree(const QRectF& place, std::size_t point, const std::vector<Label>& labels) const
{
    if (!QRectF(axisRect()->rect()).contains(place)) return false;
    if (std::any_of(labels.begin(), labels.end(), [&](const Label& other) { return other.place.intersects(place); }))
        return false;
    const bool both = hasModelErrors();
    const QRectF text = place.adjusted(besideLabel, 0, -besideLabel, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!(points_[i].cost > 0)) continue;
        const auto covers = [&](double error) {
            const QPointF at(xAxis->coordToPixel(points_[i].cost), yAxis->coordToPixel(shownError(error)));
            return QRectF(at.x() - pointRadius, at.y() - pointRadius, 2 * pointRadius, 2 * pointRadius)
                .intersects(text);
        };
        if (i != point && covers(points_[i].error)) return false;
        if (both && points_[i].modelError && covers(*points_[i].modelError)) return false;
    }
    return true;
}

void StudyChart::addLabel(std::size_t i, std::vector<Label>& labels)
{
    const ChartPoint& p = points_[i];
    QString text = p.text;
    if (p.knee) text += tr(" · knee");
    if (p.present) text += tr(" · present");
    const QFontMetricsF metrics(labelFont());
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * besideLabel, metrics.height() + aboveLabel);
    const QPointF at = placeOf(i);
    const std::vector<QLineF> lines = curves();
    const auto isCrossed = [&](const QRectF& words) {
        return std::any_of(lines.begin(), lines.end(), [&](const QLineF& line) { return crosses(line, words); });
    };
    const std::array<std::pair<bool, bool>, 4> sides{{{true, true}, {true, false}, {false, true}, {false, false}}};
    // Prefers a position that no curve crosses.
    for (const bool mayBeCrossed : {false, true}) {
        for (const auto& [above, right] : sides) {
            const QRectF place(QPointF(right ? at.x() : at.x() - size.width(), above ? at.y() - size.height() : at.y()),
                               size);
            const QRectF words =
                place.adjusted(besideLabel, above ? 0 : aboveLabel, -besideLabel, above ? -aboveLabel : 0);
            if (!isFree(place, i, labels) || (!mayBeCrossed && isCrossed(words))) continue;
            auto* label = new QCPItemText(this);
            label->setText(text);
            label->setColor(p.onFront ? theme().text : theme().dim);
            label->setFont(labelFont());
            label->setPositionAlignment((right ? Qt::AlignLeft : Qt::AlignRight) |
                                        (above ? Qt::AlignBottom : Qt::AlignTop));
            label->position->setType(QCPItemPosition::ptPlotCoords);
            label->position->setCoords(p.cost, shownError(p.error));
            label->setPadding(QMargins(besideLabel, above ? 0 : aboveLabel, besideLabel, above ? aboveLabel : 0));
            label->setSelectable(false);
            labels.push_back({i, label, place});
            return;
        }
    }
}

std::vector<QLineF> StudyChart::curves() const
{
    std::vector<QLineF> lines;
    std::optional<QPointF> before, modelBefore;
    const bool both = hasModelErrors();
    for (const ChartPoint* p : byCost([](const ChartPoint& each) { return each.onFront; })) {
        const auto join = [&](std::optional<QPointF>& from, double error) {
            const QPointF to(xAxis->coordToPixel(p->cost), yAxis->coordToPixel(shownError(error)));
            if (from) lines.emplace_back(*from, to);
            from = to;
        };
        join(before, p->error);
        if (both && p->modelError) join(modelBefore, *p->modelError);
    }
    return lines;
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
    if (measured.empty()) return setSentences(emptyText().isEmpty() ? tr("No point is measured yet") : emptyText());
    const auto number = [](double value) { return QString::number(value, 'g', 3); };
    QStringList all{tr("%1 over %2, both logarithmic: %n points.", nullptr, static_cast<int>(measured.size()))
                        .arg(errorTitle(), costTitle())};
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
    // The last point stays shown, so that the pointer can move to its pictures. Only another point replaces it.
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

QString settingWords(const std::vector<study::SettingPart>& parts)
{
    if (parts.empty()) return translatedText(study::settingText(parts));
    QStringList all;
    for (const study::SettingPart& part : parts)
        all << translatedText(part.label) + QLatin1Char(' ') + translatedText(part.value);
    return all.join(QStringLiteral(", "));
}

namespace {

QString axisTitle(const study::StudyCosts& costs, bool clockTrusted)
{
    if (costs.axis == study::CostAxis::time)
        return clockTrusted ? StudyChart::tr("milliseconds of a picture")
                            : StudyChart::tr("milliseconds of a picture, by a clock that is not trusted");
    return costs.name.empty() ? StudyChart::tr("counted work")
                              : StudyChart::tr("%1 in all views").arg(translatedText(study::costTitle(costs.name)));
}

void setCost(ChartPoint& point, const study::StudyCosts& costs, std::size_t i)
{
    const study::SettingCost& cost = costs.settings[i];
    point.cost = cost.cost;
    point.costLow = cost.interval.low;
    point.costHigh = cost.interval.high;
    point.onFront = costs.onFront(i);
    point.dominated = !point.onFront;
    point.knee = costs.knee == i;
}

/// Returns the label of a setting: the value for one parameter, names and values for two, nothing for more.
QString pointWords(const std::vector<study::SettingPart>& parts, std::size_t parameters)
{
    if (parameters > 2) return {};
    return parameters == 1 && !parts.empty() ? translatedText(parts.front().value) : settingWords(parts);
}

ChartedStudy chartedBy(const study::StudyCosts& costs, render::Metric metric, bool clockTrusted)
{
    ChartedStudy study;
    study.costTitle = axisTitle(costs, clockTrusted);
    study.errorTitle = translatedText(title(metric));
    study.parameters = costs.parameters;
    study.law = translatedText(study::lawSentence(costs));
    return study;
}

/// Returns "Fur: Shell count", or "Fur: all parameters" for more than two.
QString headingOf(Subjects subjects, const study::StudyRequest& request)
{
    QStringList labels;
    for (const study::StudyAxis& axis : request.axes)
        labels << translatedText(study::axisLabel(subjects, request.sceneState, request.subject, axis));
    return translatedText(subjects[request.subject]->title()) + QStringLiteral(": ") +
           (labels.size() > 2 ? StudyChart::tr("all parameters") : labels.join(QStringLiteral(", ")));
}

QString conditions(std::size_t views, glm::ivec2 size, bool alone, const std::string& clock)
{
    QStringList all{StudyChart::tr("Views: %1").arg(views), StudyChart::tr("%1 × %2 pixels").arg(size.x).arg(size.y)};
    if (alone) all << StudyChart::tr("without the hall");
    if (!clock.empty()) all << StudyChart::tr("clock: %1").arg(translatedText(clock));
    return all.join(QStringLiteral(" · "));
}

}  // namespace

ChartedStudy charted(Subjects subjects, const study::StudyRequest& request, const study::StudyResult& result,
                     study::CostAxis axis)
{
    const study::StudyCosts costs = study::costsAlong(axis, request, result);
    ChartedStudy study = chartedBy(costs, request.metric, result.clockTrusted);
    study.heading = headingOf(subjects, request);
    study.details = conditions(result.views.size(), request.size, request.alone, result.clock);
    int drawn = 0;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const study::StudyPoint& p = result.points[i];
        ChartPoint c;
        setCost(c, costs, i);
        c.error = p.error;
        c.errorLow = p.lowestError;
        c.errorHigh = p.worstError;
        c.modelError = p.modelError;
        c.text = pointWords(study::settingParts(subjects, request, p), request.axes.size());
        c.present = result.present == i;
        drawn += study::isDrawn(p) ? 1 : 0;
        study.points.push_back(std::move(c));
    }
    const int all = static_cast<int>(result.points.size());
    if (axis == study::CostAxis::time)
        study.emptyText =
            StudyChart::tr("%1 of %2 settings are drawn.\nTimes are measured once all are drawn.").arg(drawn).arg(all);
    else if (drawn < all)
        study.emptyText = StudyChart::tr("%1 of %2 settings are drawn.\nTheir work is compared once all are drawn.")
                              .arg(drawn)
                              .arg(all);
    else
        study.emptyText = StudyChart::tr("No count of work tells these settings apart.");
    return study;
}

ChartedStudy charted(const study::KeptStudy& kept, const QString& title, study::CostAxis axis)
{
    const study::StudyCosts costs = study::costsAlong(axis, kept);
    ChartedStudy study = chartedBy(costs, kept.metric, kept.clockTrusted);
    study.heading = title;
    study.details = conditions(kept.views.size(), kept.size, kept.alone, kept.clock);
    for (std::size_t i = 0; i < kept.points.size(); ++i) {
        const study::KeptPoint& p = kept.points[i];
        ChartPoint c;
        setCost(c, costs, i);
        c.error = std::isfinite(p.error) ? p.error : 0;
        c.errorLow = std::min(p.lowestError, c.error);
        c.errorHigh = std::isfinite(p.worstError) ? std::max(p.worstError, c.error) : c.error;
        c.modelError = p.modelError;
        c.text = pointWords(kept.settingParts(i), kept.parameters.size());
        study.points.push_back(std::move(c));
    }
    study.emptyText = axis == study::CostAxis::time ? StudyChart::tr("This study has no times.")
                                                    : StudyChart::tr("No count of work tells these settings apart.");
    return study;
}

}  // namespace vitrine::ui

#include "moc_study_chart.cpp"
