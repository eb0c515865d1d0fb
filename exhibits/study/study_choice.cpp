// How a study of many parameters finds its way, and how it chooses among what it measured.

#include "exhibits/study/study.h"
#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

/// A cost that is nearer to another than this factor is no saving but noise.
constexpr double noise = 1.04;
/// Errors that differ by less than this share of the largest one are the same to the search.
constexpr double nextToNothing = 0.002;
/// What is dearer than this many times the present setting is predicted, not measured.
constexpr double dearest = 16;
constexpr int heldOutRuns = 3;
/// A numeric axis with more values than this is first looked at in as many places; the search fills in where it matters.
constexpr std::size_t coarseValues = 5;
/// In each round of the search, the settings around so many of the front's points are measured.
constexpr std::size_t pointsLookedAround = 4;

/// Whether the first look takes this value. Choices have no order to fill in between.
bool isCoarse(const StudyAxis& axis, const ParameterInfo& row, std::size_t i)
{
    const std::size_t count = axis.values.size();
    const std::size_t stride = row.isNumeric() && count > coarseValues ? (count - 1 + coarseValues - 2) / (coarseValues - 1) : 1;
    return i % stride == 0 || i + 1 == count;
}

/// The place of the value nearest to `value`; in a logarithmic sense where all are positive.
std::size_t nearest(const std::vector<double>& values, double value)
{
    std::size_t best = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (std::abs(values[i] - value) < std::abs(values[best] - value)) best = i;
    return best;
}

}  // namespace

bool StudyResult::costsTheSame(const StudyPoint& a, const StudyPoint& b) const
{
    if (a.counters == b.counters) return true;
    return costName == "ms" && a.time && b.time ? render::indistinguishable(*a.time, *b.time) : a.cost == b.cost;
}

bool Study::searchOn()
{
    const std::size_t before = result_.points.size();
    const std::size_t mostSettings = static_cast<std::size_t>(std::max(request_.settings, 1));
    const auto room = [&] { return result_.points.size() < mostSettings; };
    if (generation_ == 0) {
        // Each parameter alone: what it gives and what it costs.
        Setting present;
        for (const StudyAxis& axis : request_.axes) present.push_back(nearest(axis.values, std::get<double>(request_.look.values[axis.exhibit].row(axis.row))));
        addSetting(present);
        for (std::size_t a = 0; a < request_.axes.size(); ++a) {
            const StudyAxis& axis = request_.axes[a];
            const std::size_t exact = nearest(axis.values, result_.exact[a]);
            for (std::size_t i = 0; i < axis.values.size(); ++i) {
                if (i != exact && !isCoarse(axis, rowOf(museum_.exhibits(), axis), i)) continue;
                Setting setting = present;
                setting[a] = i;
                addSetting(setting);
            }
        }
    } else if (generation_ == 1) {
        measureSteps();
        // Half of the room, so that the rest can look around what this finds.
        const std::size_t half = (before + mostSettings + 1) / 2;
        for (const Setting& setting : predictedFront())
            if (room() && result_.points.size() < half) addSetting(setting);
    } else {
        // Around the front, as long as it moves and there is room.
        for (const std::size_t f : searchedFront()) {
            for (std::size_t a = 0; a < request_.axes.size(); ++a) {
                for (const int direction : {-1, 1}) {
                    Setting setting = result_.points[f].setting;
                    const std::size_t moved = setting[a] + static_cast<std::size_t>(direction);
                    if (moved >= request_.axes[a].values.size() || steps_[a][moved] == steps_[a][setting[a]] || !room()) continue;
                    setting[a] = moved;
                    addSetting(setting);
                }
            }
        }
    }
    ++generation_;
    return generation_ <= 2 || result_.points.size() > before;
}

double Study::fromLimit(double error, double cost) const
{
    if (!request_.maxError && !request_.maxMilliseconds) return 0;
    const double ratio = request_.maxError ? error / *request_.maxError : cost / *request_.maxMilliseconds;
    return std::abs(std::log(std::max(ratio, 1e-9)));
}

double Study::presentCost() const
{
    // One frame's time is noise; every setting that does the same work was timed once, too.
    std::vector<double> costs;
    for (const StudyPoint& point : result_.points)
        if (point.counters == result_.points.front().counters) costs.push_back(point.cost);
    return std::max(render::quantile(costs, 0.5), 1e-9);
}

double Study::searchedCost(const StudyPoint& point, double present) const
{
    const bool near = point.cost < present * noise && point.cost * noise > present;
    return near || point.counters == result_.points.front().counters ? present : point.cost;
}

void Study::measureSteps()
{
    judge();
    const StudyPoint& present = result_.points.front();
    const double cost = presentCost();
    steps_.clear();
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        const auto pointAt = [&](std::size_t i) -> const StudyPoint* {
            Setting setting = present.setting;
            setting[a] = i;
            const auto found = known_.find(setting);
            return found == known_.end() ? nullptr : &result_.points[found->second];
        };
        const StudyPoint& exact = *pointAt(nearest(axis.values, result_.exact[a]));
        std::vector<Step>& steps = steps_.emplace_back(axis.values.size());
        std::size_t last = 0;
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            const StudyPoint* point = pointAt(i);
            if (!point) continue;
            std::vector<double> errors;
            for (std::size_t view = 0; view < exact.shots.size(); ++view) errors.push_back(errorsOf(exact.shots[view].picture, point->shots[view].picture)[request_.metric]);
            steps[i] = {pooled(errors), searchedCost(*point, cost) / cost};
            // What lies between two that were measured is taken to, until it is measured.
            for (std::size_t j = last + 1; j < i; ++j) {
                const double t = static_cast<double>(j - last) / static_cast<double>(i - last);
                steps[j] = {std::lerp(steps[last].error, steps[i].error, t), std::pow(steps[last].ratio, 1 - t) * std::pow(steps[i].ratio, t)};
            }
            last = i;
        }
    }
    // What changes the picture by next to nothing does not matter here.
    double largest = 0;
    for (const std::vector<Step>& steps : steps_)
        for (const Step& step : steps) largest = std::max(largest, step.error);
    for (std::size_t a = 0; a < steps_.size(); ++a)
        for (Step& step : steps_[a])
            if (std::abs(step.error - steps_[a][present.setting[a]].error) < largest * nextToNothing) step.error = steps_[a][present.setting[a]].error;
}

std::vector<Setting> Study::predictedFront() const
{
    // Costs multiply and errors add, roughly: good enough to know where to measure.
    const Setting present = result_.points.front().setting;
    std::vector<std::vector<std::size_t>> useful;  // By axis, from dearest and most exact to cheapest.
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        std::vector<render::CostAndError> measured;
        for (const Step& step : steps_[a]) measured.push_back({step.ratio, step.error});
        useful.push_back(render::paretoFront(measured));
        // What is as good in both, for it does not matter here, stays as it is.
        for (std::size_t& i : useful.back())
            if (steps_[a][i] == steps_[a][present[a]]) i = present[a];
        std::reverse(useful.back().begin(), useful.back().end());
    }
    // From everything exact, always the step that saves the most for the least error (marginal analysis).
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
    std::stable_sort(path.begin(), path.end(), [](const Predicted& a, const Predicted& b) { return a.fromLimit < b.fromLimit; });
    std::vector<Setting> settings;
    if (request_.maxError) {
        // Everything exact, so that something keeps the limit even where what one parameter gives hangs on another.
        settings.emplace_back();
        for (std::size_t a = 0; a < request_.axes.size(); ++a) settings.back().push_back(nearest(request_.axes[a].values, result_.exact[a]));
    }
    for (Predicted& p : path) settings.push_back(std::move(p.setting));
    return settings;
}

std::vector<std::size_t> Study::searchedFront()
{
    judge();
    const double present = presentCost();
    std::vector<render::CostAndError> measured;
    for (const StudyPoint& point : result_.points) measured.push_back({searchedCost(point, present), point.error});
    std::vector<std::size_t> front = render::paretoFront(measured);
    if (!request_.maxError && !request_.maxMilliseconds) return front;
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
        return fromLimit(result_.points[a].worstError, measured[a].cost) < fromLimit(result_.points[b].worstError, measured[b].cost);
    });
    front.resize(std::min(front.size(), pointsLookedAround));
    return front;
}

void Study::listCandidates()
{
    candidates_.clear();
    for (std::size_t i = 0; i < result_.points.size(); ++i) {
        const StudyPoint& point = result_.points[i];
        if (!point.time) continue;
        const bool keeps = request_.maxError ? point.worstError <= *request_.maxError : point.time->interval.high <= *request_.maxMilliseconds;
        if (keeps) candidates_.push_back(i);
    }
    if (candidates_.empty()) return;
    const auto badness = [&](std::size_t i) {
        const StudyPoint& p = result_.points[i];
        return request_.maxError ? std::pair(p.cost, p.worstError) : std::pair(p.worstError, p.cost);
    };
    // Best last, by the median of the time or by the worst error; of equal ones, the better in the other.
    std::sort(candidates_.begin(), candidates_.end(), [&](std::size_t a, std::size_t b) { return badness(a) > badness(b); });
    if (!result_.present) return;
    // Those that cannot be told from the best one: of them, the one that changes the fewest parameters, and of these
    // the most exact.
    const StudyPoint& best = result_.points[candidates_.back()];
    const auto asGood = std::stable_partition(candidates_.begin(), candidates_.end(), [&](std::size_t i) {
        const StudyPoint& p = result_.points[i];
        return request_.maxError ? !result_.costsTheSame(p, best) : p.worstError > best.worstError;
    });
    const Setting& present = result_.points[*result_.present].setting;
    const auto changes = [&](std::size_t i) {
        std::size_t count = 0;
        for (std::size_t a = 0; a < present.size(); ++a) count += result_.points[i].setting[a] != present[a] ? 1 : 0;
        return count;
    };
    std::stable_sort(asGood, candidates_.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(changes(a), result_.points[a].worstError) > std::pair(changes(b), result_.points[b].worstError);
    });
}

void Study::tryCandidate()
{
    const std::size_t point = candidates_.back();
    candidates_.pop_back();
    result_.choice = StudyChoice{.point = point, .holds = true};
    for (std::size_t view = result_.views.size(); view < views_.size(); ++view) {
        result_.choice->heldOutViews.push_back(views_[view].view.name);
        const Look look = lookAt(valuesOf(result_.points[point].setting), view);
        addPicture("held-out view " + views_[view].view.name, look, view, [this, view, look](render::Image picture) {
            StudyChoice& choice = *result_.choice;
            const double error = errorsOf(views_[view].reference, picture)[request_.metric];
            choice.heldOutError = std::max(choice.heldOutError, error);
            if (request_.maxError) choice.holds = choice.holds && error <= *request_.maxError;
            if (!request_.maxMilliseconds) return;
            std::vector<double> times;
            for (int run = 0; run < heldOutRuns; ++run) times.push_back(drawTimed(look, view).milliseconds * pictureRequest(look, view).samples);
            const double median = render::quantile(times, 0.5);
            choice.heldOutMilliseconds = std::max(choice.heldOutMilliseconds, median);
            choice.holds = choice.holds && median <= *request_.maxMilliseconds;
        });
    }
}

}  // namespace vitrine
