#include "exhibits/study/study_comparison.h"

#include "exhibits/study/study_text.h"
#include "render/measure/pareto.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace vitrine::study {
namespace {

using Point = ComparedCurve::Point;
using Numbers = double Point::*;

double pixelsOf(const KeptStudy& study)
{
    return static_cast<double>(study.size.x) * study.size.y * static_cast<double>(study.views.size());
}

/// Returns whether all studies have a counter, and it differs among the settings of any of them.
bool isTelling(const std::vector<KeptStudy>& studies, const std::string& counter)
{
    bool differs = false;
    for (const KeptStudy& study : studies) {
        std::set<double> counts;
        for (const KeptPoint& point : study.points) {
            if (!point.measured()) continue;
            const auto found = point.counters.find(counter);
            if (found == point.counters.end() || !(found->second > 0)) return false;
            counts.insert(found->second);
        }
        differs = differs || counts.size() > 1;
    }
    return differs;
}

void setCost(const KeptStudy& study, const KeptPoint& from, const std::string& cost, Point& point)
{
    if (cost == "ms") {
        point.cost = from.time->median;
        point.costLow = from.time->interval.low;
        point.costHigh = from.time->interval.high;
        point.costConfidence = from.time->interval.confidence;
        return;
    }
    point.cost = point.costLow = point.costHigh = from.counters.at(cost) / pixelsOf(study);
}

ComparedCurve curveOf(const KeptStudy& study, const std::string& label, const std::string& cost)
{
    ComparedCurve curve;
    curve.label = label;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const KeptPoint& from = study.points[i];
        if (!from.measured() || (cost == "ms" ? !from.time : !from.counters.contains(cost))) continue;
        Point point;
        point.point = i;
        point.text = settingText(study.settingParts(i));
        setCost(study, from, cost, point);
        if (!(point.cost > 0)) continue;
        point.error = from.error;
        point.errorLow = std::min(from.lowestError, from.error);
        point.errorHigh = std::isfinite(from.worstError) ? std::max(from.worstError, from.error) : from.error;
        point.uncertain = from.uncertain;
        curve.points.push_back(std::move(point));
    }
    std::stable_sort(curve.points.begin(), curve.points.end(),
                     [](const Point& a, const Point& b) { return a.cost < b.cost; });
    std::vector<render::CostAndError> all;
    for (const Point& point : curve.points) all.push_back({point.cost, point.error});
    for (const std::size_t i : render::paretoFront(all)) curve.points[i].onFront = true;
    return curve;
}

/// Returns the position of x between a and b on a logarithmic scale; nothing if it is undefined.
std::optional<double> share(double x, double a, double b)
{
    if (!(a > 0) || !(b > 0) || a == b) return std::nullopt;
    return std::log(x / a) / std::log(b / a);
}

double between(double a, double b, double share)
{
    return a > 0 && b > 0 ? a * std::pow(b / a, share) : a;
}

std::optional<double> errorAt(const std::vector<Point>& front, double cost)
{
    if (front.empty() || cost < front.front().cost) return std::nullopt;
    for (std::size_t i = 0; i + 1 < front.size(); ++i)
        if (cost < front[i + 1].cost)
            return between(front[i].error, front[i + 1].error, *share(cost, front[i].cost, front[i + 1].cost));
    return front.back().error;
}

/// The two points of the front between which the error lies, and its position `share` between them. Both are the same
/// if one of them matches, or if the first is good enough. There are none if no point is as exact.
struct Between {
    const Point *a, *b;
    double share;
    [[nodiscard]] double of(Numbers number) const
    {
        return a == b ? a->*number : between(a->*number, b->*number, share);
    }
};
std::optional<Between> whereErrorIs(const std::vector<Point>& front, double error)
{
    if (front.empty() || error < front.back().error) return std::nullopt;
    if (error >= front.front().error) return Between{&front.front(), &front.front(), 0};
    for (std::size_t i = 0; i + 1 < front.size(); ++i) {
        if (error < front[i + 1].error) continue;
        if (error == front[i + 1].error) return Between{&front[i + 1], &front[i + 1], 0};
        const std::optional<double> at = share(error, front[i].error, front[i + 1].error);
        // An error of 0 has no logarithm, so only the exact point is known to be good enough.
        return at ? Between{&front[i], &front[i + 1], *at} : Between{&front[i + 1], &front[i + 1], 0};
    }
    return std::nullopt;
}

void setCostAt(const std::vector<Point>& front, const Point& mine, StudyDifference& difference)
{
    const std::optional<Between> at = whereErrorIs(front, mine.error);
    if (!at) return;
    difference.costAtError = at->of(&Point::cost);
    difference.uncertain = difference.uncertain || at->a->uncertain || at->b->uncertain;
    // Lower bound of the probability that all of them hold.
    double confidence = mine.costConfidence + at->a->costConfidence - 1;
    if (at->a != at->b) confidence += at->b->costConfidence - 1;
    if (!(mine.costLow > 0)) return;
    difference.costRatio = render::Interval{at->of(&Point::costLow) / mine.costHigh,
                                            at->of(&Point::costHigh) / mine.costLow, std::max(confidence, 0.0)};
}

}  // namespace

TimesDiffer timesDiffer(const std::vector<KeptStudy>& studies)
{
    const KeptStudy& first = studies.front();
    for (const KeptStudy& study : studies)
        for (const KeptPoint& point : study.points)
            if (point.measured() && !point.time) return TimesDiffer::notTaken;
    for (const KeptStudy& study : studies) {
        if (study.renderer.empty()) return TimesDiffer::unknownMachine;
        if (study.renderer != first.renderer || study.processors != first.processors) return TimesDiffer::machine;
        if (study.size != first.size) return TimesDiffer::size;
        if (study.alone != first.alone) return TimesDiffer::surroundings;
        if (study.clock != first.clock || study.clockTrusted != first.clockTrusted) return TimesDiffer::clock;
    }
    return TimesDiffer::no;
}

std::vector<std::string> sharedCosts(const std::vector<KeptStudy>& studies)
{
    // The order is: milliseconds of a trusted clock, the costs of the studies' own fronts, work per pixel, the rest.
    // Passes and draws are excluded, since they are not work of the picture.
    std::vector<std::string> wanted;
    const auto want = [&](const std::string& name) {
        if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
    };
    const bool trusted =
        std::all_of(studies.begin(), studies.end(), [](const KeptStudy& study) { return study.clockTrusted; });
    if (trusted) want("ms");
    for (const KeptStudy& study : studies)
        if (study.cost != "ms") want(study.cost);
    for (const char* name : {"pixels", "evaluations", "fetches", "marchSteps"}) want(name);
    for (const KeptStudy& study : studies)
        for (const KeptPoint& point : study.points)
            for (const auto& [name, count] : point.counters)
                if (name != "passes" && name != "draws") want(name);
    want("ms");
    std::vector<std::string> shared;
    for (const std::string& name : wanted)
        if (name == "ms" ? timesDiffer(studies) == TimesDiffer::no : isTelling(studies, name)) shared.push_back(name);
    return shared;
}

std::vector<Point> ComparedCurve::front() const
{
    std::vector<Point> front;
    std::copy_if(points.begin(), points.end(), std::back_inserter(front), [](const Point& p) { return p.onFront; });
    return front;
}

StudyComparison compareStudies(const std::vector<KeptStudy>& studies, const std::vector<std::string>& labels,
                               const std::string& cost)
{
    StudyComparison comparison;
    comparison.cost = cost;
    comparison.metric = studies.front().metric;
    for (std::size_t i = 0; i < studies.size(); ++i) {
        ComparedCurve curve{labels[i], studies[i].metric != comparison.metric, {}};
        if (!curve.leftOut) curve = curveOf(studies[i], labels[i], cost);
        comparison.curves.push_back(std::move(curve));
    }
    const std::vector<Point> mine = comparison.curves.front().front();
    for (std::size_t i = 1; i < comparison.curves.size(); ++i) {
        if (comparison.curves[i].leftOut) continue;
        const std::vector<Point> front = comparison.curves[i].front();
        for (const Point& point : mine) {
            StudyDifference difference{i, point.text, point.cost, point.error, {}, {}, {}, point.uncertain};
            difference.errorAtCost = errorAt(front, point.cost);
            setCostAt(front, point, difference);
            comparison.differences.push_back(std::move(difference));
        }
    }
    return comparison;
}

std::vector<std::string> labelsOf(const std::vector<KeptStudy>& studies)
{
    std::vector<std::string> labels;
    for (const KeptStudy& study : studies)
        labels.push_back(study.name.empty() ? study.exhibit + " · " + study.parameterNames() : study.name);
    const auto twice = [&labels] {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (std::count(labels.begin(), labels.end(), labels[i]) > 1) found.push_back(i);
        return found;
    };
    for (const std::size_t i : twice())
        if (const std::string& when = studies[i].measured; !when.empty())
            labels[i] += " · " + when.substr(0, 10) + ' ' + when.substr(11);
    for (const std::size_t i : twice()) labels[i] += " (" + std::to_string(i + 1) + ')';
    return labels;
}

}  // namespace vitrine::study
