#include "exhibits/study/study_judge.h"

#include "render/files/number_text.h"
#include "render/measure/distance.h"
#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using render::Metric;
using render::shortNumber;

/// A reference is trusted when it moves by less than this part of the smallest error.
constexpr double quarter = 0.25;
/// A counter that varies less than this says little of what a parameter costs.
constexpr double leastRatio = 1.15;

bool isDrawn(const StudyPoint& point)
{
    return std::all_of(point.shots.begin(), point.shots.end(),
                       [](const StudyShot& shot) { return !shot.picture.empty(); });
}

/// Those whose reference counts as exact although neither its meaning nor another value says so.
std::vector<StudyAxis> uncheckedAxes(const SceneState& sceneState, const std::vector<StudyAxis>& axes)
{
    std::vector<StudyAxis> found;
    for (const StudyAxis& axis : axes)
        if (const Exactness e = exactness(rowOf(sceneState, axis)); !e.byMeaning && e.neighbors.empty())
            found.push_back(axis);
    return found;
}

/// The counter that tells the settings' work apart: of what is done per pixel, the first that differs enough, else the
/// one in which they differ most; empty when none does.
std::string mostTelling(const std::vector<StudyPoint>& points)
{
    std::map<std::string, std::pair<double, double>> ranges;
    for (const StudyPoint& point : points) {
        if (!isDrawn(point)) continue;
        for (const auto& [name, count] : point.counters) {
            auto [range, isNew] = ranges.try_emplace(name, static_cast<double>(count), static_cast<double>(count));
            range->second.first = std::min(range->second.first, static_cast<double>(count));
            range->second.second = std::max(range->second.second, static_cast<double>(count));
        }
    }
    for (const char* name : {"pixels", "evaluations", "fetches", "marchSteps", "samples"})
        if (const auto known = ranges.find(name);
            known != ranges.end() && known->second.first > 0 && known->second.second > leastRatio * known->second.first)
            return name;
    std::string best;
    double largest = leastRatio;
    for (const auto& [name, range] : ranges) {
        // How a picture is cut into passes and draws is not its work.
        if (name == "passes" || name == "draws" || !(range.first > 0)) continue;
        if (range.second / range.first > largest) {
            largest = range.second / range.first;
            best = name;
        }
    }
    return best;
}

/// Of all runs that every view has.
std::optional<render::Summary> timeOf(const StudyPoint& point)
{
    std::size_t runs = std::numeric_limits<std::size_t>::max();
    for (const StudyShot& shot : point.shots) runs = std::min(runs, shot.milliseconds.size());
    std::vector<double> means(runs, 0.0);
    for (std::size_t run = 0; run < runs; ++run)
        for (const StudyShot& shot : point.shots)
            means[run] += shot.milliseconds[run] / static_cast<double>(point.shots.size());
    return means.empty() ? std::nullopt : std::optional(render::summarize(means));
}

}  // namespace

bool studiesMotion(const StudyRequest& request)
{
    return std::any_of(request.axes.begin(), request.axes.end(), [&](const StudyAxis& axis) {
        return axis.subject == hallIndex && rowOf(request.sceneState, axis).name == historyFramesRow;
    });
}

Errors StudyJudge::errorsOf(const render::Image& reference, const render::Image& picture) const
{
    const render::ColorDifference color = render::colorDifference(reference, picture);
    Errors errors{{Metric::rmse, color.rmse},
                  {Metric::psnr, color.psnr()},
                  {Metric::max, color.max},
                  {Metric::beyond, color.beyond}};
    for (const Metric metric : {Metric::flip, Metric::normal, Metric::depth})
        if (const auto distance = render::distance(metric, reference, picture, request_.pixelsPerDegree))
            errors[metric] = *distance;
    return errors;
}

double StudyJudge::pooled(const std::vector<double>& errors) const
{
    if (errors.empty()) return 0;
    double sum = 0;
    double largest = 0;
    for (const double e : errors) {
        sum += request_.metric == Metric::rmse ? e * e : e;
        largest = std::max(largest, e);
    }
    if (request_.metric == Metric::max) return largest;
    const double mean = sum / static_cast<double>(errors.size());
    return request_.metric == Metric::rmse ? std::sqrt(mean) : mean;
}

void StudyJudge::judge(StudyResult& result, int doublings) const
{
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t uncertain = 0;
    result.present.reset();
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        StudyPoint& point = result.points[i];
        if (!isDrawn(point)) continue;
        judgePoint(point, result.uncertainty);
        uncertain += point.uncertain ? 1 : 0;
        if (point.error > 0) smallest = std::min(smallest, point.error);
        if (isPresent(point)) result.present = i;
    }
    result.converged =
        uncertain == 0 && uncheckedAxes(request_.sceneState, request_.axes).empty() && !studiesMotion(request_);
    result.convergence = convergenceSentence(result, uncertain, smallest, doublings);
    if (std::isinf(smallest) && result.points.size() > 1 &&
        std::all_of(result.points.begin(), result.points.end(), isDrawn)) {
        std::string names;
        for (const StudyAxis& axis : request_.axes)
            names += (names.empty() ? "" : " or ") + axisName(subjects_, request_.sceneState, request_.subject, axis);
        result.convergence =
            "Nothing depends on " + names +
            " at present: every setting gives the same picture. Switch on what it acts on, and study again.";
    }
    judgeCosts(result);
}

void StudyJudge::judgePoint(StudyPoint& point, double uncertainty) const
{
    std::vector<double> errors;
    std::vector<double> modelErrors;
    point.counters.clear();
    for (StudyShot& shot : point.shots) {
        errors.push_back(shot.errors.contains(request_.metric) ? shot.errors.at(request_.metric)
                                                               : std::numeric_limits<double>::quiet_NaN());
        modelErrors.push_back(shot.modelError);
        for (const auto& [name, count] : shot.counters) point.counters[name] += count;
    }
    point.error = pooled(errors);
    point.modelError = pooled(modelErrors);
    point.lowestError = *std::min_element(errors.begin(), errors.end());
    point.worstError = *std::max_element(errors.begin(), errors.end());
    point.uncertain = point.error > 0 && point.error * quarter < uncertainty;
}

bool StudyJudge::isPresent(const StudyPoint& point) const
{
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        if (std::get<double>(request_.sceneState.values[axis.subject].row(axis.row)) != axis.values[point.setting[a]])
            return false;
    }
    return true;
}

std::string StudyJudge::convergenceSentence(const StudyResult& result, std::size_t uncertainErrors,
                                            double smallestError, int doublings) const
{
    const auto listed = [&](const std::vector<StudyAxis>& axes, const std::vector<double>& values) {
        std::string text;
        for (std::size_t i = 0; i < axes.size(); ++i)
            text += (text.empty() ? "" : ", ") + axisName(subjects_, request_.sceneState, request_.subject, axes[i]) +
                    ' ' + axisValueText(request_.sceneState, axes[i], values[i]);
        return text;
    };
    if (studiesMotion(request_)) return "The reference is the picture at rest, whose own error is not checked.";
    const std::vector<StudyAxis> unchecked = uncheckedAxes(request_.sceneState, request_.axes);
    std::vector<double> takenFor;
    for (const StudyAxis& axis : unchecked) takenFor.push_back(exactness(rowOf(request_.sceneState, axis)).exact);
    const std::string onTrust =
        unchecked.empty() ? "" : "What counts as exact is not checked: " + listed(unchecked, takenFor) + '.';
    const auto neighbors = neighborsOf(request_.sceneState, request_.axes);
    if (neighbors.empty()) return onTrust.empty() ? "The reference is exact by the meaning of the parameter." : onTrust;

    std::string text;
    const std::string change = shortNumber(result.uncertainty);
    if (doublings > 0) {
        text = "The reference was made twice as exact " + std::to_string(doublings) +
               (doublings == 1 ? " time" : " times") + ", the last time changing it by " + change;
    } else {
        for (const std::vector<double>& neighbor : neighbors)
            text += (text.empty() ? "At " : ", or at ") + listed(request_.axes, neighbor);
        text += " the reference changes by " + change;
    }
    if (uncertainErrors > 0)
        text += ": " + std::to_string(uncertainErrors) + (uncertainErrors == 1 ? " error is" : " errors are") +
                " under four times that, and uncertain.";
    else
        text += std::isfinite(smallestError)
                    ? ", less than a quarter of the smallest error, " + shortNumber(smallestError) + '.'
                    : ".";
    return text + (onTrust.empty() ? "" : ' ' + onTrust);
}

void StudyJudge::judgeCosts(StudyResult& result) const
{
    for (StudyPoint& point : result.points) point.time = timeOf(point);
    const bool oneParameter = request_.axes.size() <= 2 && !request_.maxMilliseconds;
    const std::string counter = oneParameter ? mostTelling(result.points) : std::string();
    result.costName = counter.empty() ? "ms" : counter;

    std::vector<render::CostAndError> measured;
    const bool anyTimed =
        std::any_of(result.points.begin(), result.points.end(), [](const StudyPoint& p) { return p.time.has_value(); });
    for (StudyPoint& point : result.points) {
        double first = 0;
        for (const StudyShot& shot : point.shots)
            first += shot.firstMilliseconds / static_cast<double>(point.shots.size());
        point.cost = !counter.empty() ? static_cast<double>(point.counters[counter])
                     : point.time     ? point.time->median
                                      : first;
        const bool counts = isDrawn(point) && (!counter.empty() || point.time || !anyTimed);
        measured.push_back({counts ? point.cost : std::numeric_limits<double>::infinity(), point.error});
    }
    result.front = render::paretoFront(measured);
    for (std::size_t i = 0; i < result.points.size(); ++i)
        result.points[i].dominated =
            isDrawn(result.points[i]) && std::find(result.front.begin(), result.front.end(), i) == result.front.end();
    const auto place = render::knee(measured, result.front);
    result.knee = place ? std::optional(result.front[*place]) : std::nullopt;
    fitLaw(result, measured);
}

void StudyJudge::fitLaw(StudyResult& result, std::span<const render::CostAndError> measured) const
{
    result.law.reset();
    const bool numeric = std::any_of(request_.axes.begin(), request_.axes.end(), [&](const StudyAxis& axis) {
        return rowOf(request_.sceneState, axis).isNumeric();
    });
    if (request_.axes.size() > 2 || !numeric) return;
    std::vector<double> errors;
    std::vector<double> costs;
    for (const std::size_t i : result.front) {
        if (result.points[i].uncertain) continue;
        errors.push_back(result.points[i].error);
        costs.push_back(measured[i].cost);
    }
    const render::PowerLaw law = render::fitPowerLaw(errors, costs);
    if (law.points >= 3) result.law = law;
}

}  // namespace vitrine
