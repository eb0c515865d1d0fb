#include "exhibits/study/study_search.h"

#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>

namespace vitrine::study {
namespace {

/// Costs within this factor differ by noise only.
constexpr double noise = 1.04;
/// Errors that differ by less than this share of the largest one count as equal in the search.
constexpr double nextToNothing = 0.002;
/// Settings more expensive than this multiple of the present one are predicted, not measured.
constexpr double dearest = 16;
/// A numeric axis with more values than this is first measured at as many; the search adds values where they matter.
constexpr std::size_t coarseValues = 5;
/// Number of points on the front around which each round of the search measures.
constexpr std::size_t pointsLookedAround = 4;

/// Returns whether the first round includes this value. Choices have no order, so all of theirs are included.
bool isCoarse(const StudyAxis& axis, const ParameterInfo& parameter, std::size_t i)
{
    const std::size_t count = axis.values.size();
    const std::size_t stride =
        parameter.isNumeric() && count > coarseValues ? (count - 1 + coarseValues - 2) / (coarseValues - 1) : 1;
    return i % stride == 0 || i + 1 == count;
}

/// Returns the index of the value nearest to `value`.
std::size_t nearest(const std::vector<double>& values, double value)
{
    std::size_t best = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (std::abs(values[i] - value) < std::abs(values[best] - value)) best = i;
    return best;
}

}  // namespace

bool StudySearch::advance()
{
    const std::size_t before = result_.points.size();
    if (generation_ == 0) {
        addEachAlone();
    } else if (generation_ == 1) {
        measureSteps();
        // Half of the settings are left for the neighborhood of what this finds.
        const std::size_t half = (before + mostSettings() + 1) / 2;
        for (const Setting& setting : predictedFront())
            if (hasRoom() && result_.points.size() < half) add_(setting);
    } else {
        addAroundFront();
    }
    ++generation_;
    return generation_ <= 2 || result_.points.size() > before;
}

std::size_t StudySearch::mostSettings() const
{
    return static_cast<std::size_t>(std::max(request_.settings, 1));
}

bool StudySearch::hasRoom() const
{
    return result_.points.size() < mostSettings();
}

void StudySearch::addEachAlone()
{
    // Each parameter is varied alone, to measure its effect and its cost.
    Setting present;
    for (const StudyAxis& axis : request_.axes)
        present.push_back(
            nearest(axis.values, std::get<double>(request_.sceneState.values[axis.subject].row(axis.row))));
    add_(present);
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        const std::size_t exact = nearest(axis.values, result_.exact[a]);
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            if (i != exact && !isCoarse(axis, parameterOf(request_.sceneState, axis), i)) continue;
            Setting setting = present;
            setting[a] = i;
            add_(setting);
        }
    }
}

void StudySearch::addAroundFront()
{
    // Neighbors of the front are added, as long as the front changes and settings are left.
    for (const std::size_t f : searchedFront()) {
        for (std::size_t a = 0; a < request_.axes.size(); ++a) {
            for (const int direction : {-1, 1}) {
                Setting setting = result_.points[f].setting;
                const std::size_t moved = setting[a] + static_cast<std::size_t>(direction);
                if (moved >= request_.axes[a].values.size() || steps_[a][moved] == steps_[a][setting[a]] || !hasRoom())
                    continue;
                setting[a] = moved;
                add_(setting);
            }
        }
    }
}

double StudySearch::fromLimit(double error, double cost) const
{
    if (!request_.maxError && !request_.maxMilliseconds) return 0;
    const double ratio = request_.maxError ? error / *request_.maxError : cost / *request_.maxMilliseconds;
    return std::abs(std::log(std::max(ratio, 1e-9)));
}

double StudySearch::presentCost() const
{
    // The time of one frame is noisy; every setting with the same work was timed once, too.
    std::vector<double> costs;
    for (const StudyPoint& point : result_.points)
        if (point.counters == result_.points.front().counters) costs.push_back(point.cost);
    return std::max(render::quantile(costs, 0.5), 1e-9);
}

double StudySearch::searchedCost(const StudyPoint& point, double present) const
{
    const bool near = point.cost < present * noise && point.cost * noise > present;
    return near || point.counters == result_.points.front().counters ? present : point.cost;
}

void StudySearch::measureSteps()
{
    judge_();
    const StudyPoint& present = result_.points.front();
    const double cost = presentCost();
    steps_.clear();
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        const auto pointAt = [&](std::size_t i) -> const StudyPoint* {
            Setting setting = present.setting;
            setting[a] = i;
            const auto found = std::find_if(result_.points.begin(), result_.points.end(),
                                            [&](const StudyPoint& point) { return point.setting == setting; });
            return found == result_.points.end() ? nullptr : &*found;
        };
        const StudyPoint& exact = *pointAt(nearest(axis.values, result_.exact[a]));
        std::vector<Step>& steps = steps_.emplace_back(axis.values.size());
        std::size_t last = 0;
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            const StudyPoint* point = pointAt(i);
            if (!point) continue;
            std::vector<double> errors;
            for (std::size_t view = 0; view < exact.shots.size(); ++view)
                errors.push_back(
                    errors_.errorsOf(exact.shots[view].picture, point->shots[view].picture)[request_.metric]);
            steps[i] = {errors_.pooled(errors), searchedCost(*point, cost) / cost};
            // Values between two measured ones are interpolated until they are measured.
            for (std::size_t j = last + 1; j < i; ++j) {
                const double t = static_cast<double>(j - last) / static_cast<double>(i - last);
                steps[j] = {std::lerp(steps[last].error, steps[i].error, t),
                            std::pow(steps[last].ratio, 1 - t) * std::pow(steps[i].ratio, t)};
            }
            last = i;
        }
    }
    // Negligible changes of the picture do not count.
    double largest = 0;
    for (const std::vector<Step>& steps : steps_)
        for (const Step& step : steps) largest = std::max(largest, step.error);
    for (std::size_t a = 0; a < steps_.size(); ++a)
        for (Step& step : steps_[a])
            if (std::abs(step.error - steps_[a][present.setting[a]].error) < largest * nextToNothing)
                step.error = steps_[a][present.setting[a]].error;
}

std::vector<Setting> StudySearch::predictedFront() const
{
    // Costs roughly multiply and errors add, which is accurate enough to decide where to measure.
    const Setting present = result_.points.front().setting;
    std::vector<std::vector<std::size_t>> useful;  // By axis, from most expensive and exact to cheapest.
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        std::vector<render::CostAndError> measured;
        for (const Step& step : steps_[a]) measured.push_back({step.ratio, step.error});
        useful.push_back(render::paretoFront(measured));
        // A step that gives the same cost and error as the present one is not a change.
        for (std::size_t& i : useful.back())
            if (steps_[a][i] == steps_[a][present[a]]) i = present[a];
        std::reverse(useful.back().begin(), useful.back().end());
    }
    // From everything exact, takes the step that saves the most for the least error (marginal analysis).
    struct Predicted {
        Setting setting;
        double fromLimit = 0;
    };
    const double cost = presentCost();
    std::vector<Predicted> path;
    std::vector<std::size_t> place(useful.size(), 0);
    while (true) {
        Setting setting;
        double ratio = 1;
        double error = 0;
        for (std::size_t a = 0; a < useful.size(); ++a) {
            setting.push_back(useful[a][place[a]]);
            ratio *= steps_[a][setting.back()].ratio;
            error += steps_[a][setting.back()].error;
        }
        if (ratio <= dearest) path.push_back({setting, fromLimit(error, ratio * cost)});
        std::optional<std::size_t> best;
        double bestWorth = -1;
        for (std::size_t a = 0; a < useful.size(); ++a) {
            if (place[a] + 1 == useful[a].size()) continue;
            const Step& here = steps_[a][useful[a][place[a]]];
            const Step& next = steps_[a][useful[a][place[a] + 1]];
            const double worth = std::log(here.ratio / next.ratio) / std::max(next.error - here.error, 1e-12);
            if (worth > bestWorth) {
                bestWorth = worth;
                best = a;
            }
        }
        if (!best) break;
        ++place[*best];
    }
    std::stable_sort(path.begin(), path.end(),
                     [](const Predicted& a, const Predicted& b) { return a.fromLimit < b.fromLimit; });
    std::vector<Setting> settings;
    if (request_.maxError) {
        // Includes everything exact, so a setting keeps the limit even if effects of parameters depend on each other.
        settings.emplace_back();
        for (std::size_t a = 0; a < request_.axes.size(); ++a)
            settings.back().push_back(nearest(request_.axes[a].values, result_.exact[a]));
    }
    for (Predicted& p : path) settings.push_back(std::move(p.setting));
    return settings;
}

std::vector<std::size_t> StudySearch::searchedFront()
{
    judge_();
    const double present = presentCost();
    std::vector<render::CostAndError> measured;
    for (const StudyPoint& point : result_.points) measured.push_back({searchedCost(point, present), point.error});
    std::vector<std::size_t> front = render::paretoFront(measured);
    if (!request_.maxError && !request_.maxMilliseconds) return front;
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
        return fromLimit(result_.points[a].worstError, measured[a].cost) <
               fromLimit(result_.points[b].worstError, measured[b].cost);
    });
    front.resize(std::min(front.size(), pointsLookedAround));
    return front;
}

}  // namespace vitrine::study
