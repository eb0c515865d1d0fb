#include "exhibits/study/study_judge.h"

#include "exhibits/study/point_time.h"
#include "exhibits/study/study_costs.h"
#include "exhibits/study/study_situation.h"
#include "render/files/number_text.h"
#include "render/measure/distance.h"
#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::study {
namespace {

using render::Metric;
using render::shortNumber;

/// A reference is trusted if it changes by less than this share of the smallest error.
constexpr double quarter = 0.25;

/// Returns axes whose exact value can be verified neither by its meaning nor by another value.
std::vector<StudyAxis> uncheckedAxes(const SceneState& sceneState, const std::vector<StudyAxis>& axes)
{
    std::vector<StudyAxis> found;
    for (const StudyAxis& axis : axes)
        if (const Exactness e = exactness(parameterOf(sceneState, axis)); !e.byMeaning && e.neighbors.empty())
            found.push_back(axis);
    return found;
}

}  // namespace

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

bool isRanked(const std::vector<StudyPoint>& points, std::size_t point)
{
    const std::optional<render::Summary>& time = points[point].time;
    if (!time || time->interval.confidence < 0.95) return false;
    std::size_t others = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::optional<render::Summary>& other = points[i].time;
        if (i == point || !other) continue;
        ++others;
        const double apart = std::max(time->low - other->high, other->low - time->high);
        if (apart <= std::max(time->high - time->low, other->high - other->low)) return false;
    }
    return others > 0;
}

bool studiesMotion(const StudyRequest& request)
{
    return std::any_of(request.axes.begin(), request.axes.end(), [&](const StudyAxis& axis) {
        const std::string_view name = parameterOf(request.sceneState, axis).name;
        return axis.subject == hallIndex && (name == historyFramesParameter || name == temporalAntialiasingParameter);
    });
}

Errors StudyJudge::errorsOf(const render::Image& reference, const render::Image& picture) const
{
    return render::distances({reference, picture, request_.pixelsPerDegree});
}

double StudyJudge::errorOf(const render::Image& reference, const render::Image& picture) const
{
    return render::distance(request_.metric, reference, picture, request_.pixelsPerDegree).value_or(0);
}

double StudyJudge::pooled(const std::vector<double>& errors) const
{
    return render::pooledError(request_.metric, errors);
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
    const bool allTheSame = std::isinf(smallest) && result.points.size() > 1 &&
                            std::all_of(result.points.begin(), result.points.end(), isDrawn);
    result.convergence = allTheSame ? samenessSentence() : convergenceSentence(result, uncertain, smallest, doublings);
    judgeCosts(result);
}

std::string StudyJudge::samenessSentence() const
{
    std::string names;
    for (const StudyAxis& axis : request_.axes) {
        if (const StudiedParameter declared = declaredOf(request_.sceneState, axis); !declared.same.empty())
            return std::string(declared.same);
        names += (names.empty() ? "" : " or ") + axisName(subjects_, request_.sceneState, request_.subject, axis);
    }
    return "Nothing depends on " + names +
           " at present: every setting gives the same picture. Switch on what it acts on, and study again.";
}

void StudyJudge::judgePoint(StudyPoint& point, double uncertainty) const
{
    std::vector<double> errors;
    std::vector<double> modelErrors;  // Errors of the measured views.
    point.counters.clear();
    for (StudyShot& shot : point.shots) {
        errors.push_back(shot.errors.contains(request_.metric) ? shot.errors.at(request_.metric)
                                                               : std::numeric_limits<double>::quiet_NaN());
        if (shot.modelError) modelErrors.push_back(*shot.modelError);
        for (const auto& [name, count] : shot.counters) point.counters[name] += count;
    }
    point.error = pooled(errors);
    point.modelError.reset();
    if (modelErrors.size() == point.shots.size()) point.modelError = pooled(modelErrors);
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
            text += (text.empty() ? "" : " and ") +
                    axisLabel(subjects_, request_.sceneState, request_.subject, axes[i]) + " at " +
                    axisValueText(request_.sceneState, axes[i], values[i]);
        return text;
    };
    if (studiesMotion(request_)) return "The reference is the picture without motion, whose own error is not checked.";
    const std::vector<StudyAxis> unchecked = uncheckedAxes(request_.sceneState, request_.axes);
    std::vector<double> takenFor;
    for (const StudyAxis& axis : unchecked) takenFor.push_back(exactness(parameterOf(request_.sceneState, axis)).exact);
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
            text += (text.empty() ? "With " : ", or with ") + listed(request_.axes, neighbor);
        text += " the reference changes by " + change;
    }
    if (uncertainErrors > 0)
        text += ": " + std::to_string(uncertainErrors) + (uncertainErrors == 1 ? " error is" : " errors are") +
                " under four times that, and uncertain.";
    else
        text += std::isfinite(smallestError)
                    ? ", less than a quarter of the smallest error, " + shortNumber(smallestError) + '.'
                    : ".";
    if (result.uncertainty == 0)
        for (const StudyAxis& axis : request_.axes)
            if (const StudiedParameter declared = declaredOf(request_.sceneState, axis); !declared.settles.empty())
                text += ' ' + std::string(declared.settles);
    return text + (onTrust.empty() ? "" : ' ' + onTrust);
}

void StudyJudge::judgeCosts(StudyResult& result) const
{
    for (StudyPoint& point : result.points) point.time = timeOf(point);
    if (result.workName.empty() && std::all_of(result.points.begin(), result.points.end(), isDrawn)) {
        std::vector<std::map<std::string, double>> counters;
        for (const StudyPoint& point : result.points)
            counters.emplace_back(point.counters.begin(), point.counters.end());
        result.workName = mostTellingCounter(counters);
    }
    const bool oneParameter = request_.axes.size() <= 2 && !request_.maxMilliseconds;
    const std::string counter = oneParameter ? result.workName : std::string();
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
        return parameterOf(request_.sceneState, axis).isNumeric();
    });
    if (request_.axes.size() > 2 || !numeric) return;
    std::vector<double> errors;
    std::vector<double> costs;
    for (const std::size_t i : result.front) {
        if (result.points[i].uncertain) continue;
        errors.push_back(result.points[i].error);
        costs.push_back(measured[i].cost);
    }
    result.law = costLaw(errors, costs);
}

}  // namespace vitrine::study
