#include "exhibits/study/study_costs.h"

#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::study {
namespace {

/// Ratio below which a counter says little about the cost of a parameter.
constexpr double leastRatio = 1.15;

/// A setting in a form that both kinds of study share.
struct CostedSetting {
    SettingCost cost;
    double error = 0;
    bool uncertain = false;
};

SettingCost timed(double median, const render::Interval& interval)
{
    return {median, interval};
}

SettingCost counted(double count)
{
    return count > 0 ? SettingCost{count, {count, count, 1}} : SettingCost{};
}

/// Adds front, knee and law to costs that have their name and axis.
StudyCosts judged(StudyCosts costs, const std::vector<CostedSetting>& settings, bool numeric)
{
    std::vector<render::CostAndError> measured;
    for (const CostedSetting& each : settings) {
        costs.settings.push_back(each.cost);
        const double cost = each.cost.cost > 0 ? each.cost.cost : std::numeric_limits<double>::infinity();
        measured.push_back({cost, each.error});
    }
    costs.front = render::paretoFront(measured);
    if (const auto place = render::knee(measured, costs.front)) costs.knee = costs.front[*place];
    if (costs.parameters > 2 || !numeric) return costs;
    std::vector<double> errors, prices;
    for (const std::size_t i : costs.front) {
        if (settings[i].uncertain) continue;
        errors.push_back(measured[i].error);
        prices.push_back(measured[i].cost);
    }
    costs.law = costLaw(errors, prices);
    return costs;
}

}  // namespace

bool StudyCosts::onFront(std::size_t setting) const
{
    return std::find(front.begin(), front.end(), setting) != front.end();
}

std::string mostTellingCounter(const std::vector<std::map<std::string, double>>& settings)
{
    std::map<std::string, std::pair<double, double>> ranges;
    for (const auto& counters : settings) {
        for (const auto& [name, count] : counters) {
            const auto [range, isNew] = ranges.try_emplace(name, count, count);
            range->second.first = std::min(range->second.first, count);
            range->second.second = std::max(range->second.second, count);
        }
    }
    const auto ratio = [](const std::pair<double, double>& range) {
        return range.first > 0 ? range.second / range.first : 0;
    };
    for (const char* name : {"pixels", "evaluations", "fetches", "marchSteps"})
        if (const auto known = ranges.find(name); known != ranges.end() && ratio(known->second) > leastRatio)
            return name;
    std::string best;
    double largest = leastRatio;
    for (const auto& [name, range] : ranges) {
        // Passes and draws are not work of the picture.
        if (name == "passes" || name == "draws" || ratio(range) <= largest) continue;
        largest = ratio(range);
        best = name;
    }
    return best;
}

std::optional<render::PowerLaw> costLaw(const std::vector<double>& errors, const std::vector<double>& costs)
{
    const render::PowerLaw law = render::fitPowerLaw(errors, costs);
    return law.points >= 3 ? std::optional(law) : std::nullopt;
}

StudyCosts costsAlong(CostAxis axis, const StudyRequest& request, const StudyResult& result)
{
    StudyCosts costs;
    costs.axis = axis;
    costs.name = axis == CostAxis::time ? "ms" : result.workName;
    costs.parameters = request.axes.size();
    std::vector<CostedSetting> settings;
    for (const StudyPoint& point : result.points) {
        CostedSetting setting{{}, point.error, point.uncertain};
        if (axis == CostAxis::time && point.time)
            setting.cost = timed(point.time->median, point.time->interval);
        else if (const auto count = point.counters.find(costs.name);
                 axis == CostAxis::work && isDrawn(point) && count != point.counters.end())
            setting.cost = counted(static_cast<double>(count->second));
        settings.push_back(setting);
    }
    const bool numeric = std::any_of(request.axes.begin(), request.axes.end(), [&](const StudyAxis& each) {
        return parameterOf(request.sceneState, each).isNumeric();
    });
    return judged(std::move(costs), settings, numeric);
}

StudyCosts costsAlong(CostAxis axis, const KeptStudy& study)
{
    StudyCosts costs;
    costs.axis = axis;
    costs.parameters = study.parameters.size();
    if (axis == CostAxis::time) {
        costs.name = "ms";
    } else if (study.cost != "ms") {
        costs.name = study.cost;
    } else {
        std::vector<std::map<std::string, double>> counters;
        for (const KeptPoint& point : study.points)
            if (point.measured()) counters.push_back(point.counters);
        costs.name = mostTellingCounter(counters);
    }
    std::vector<CostedSetting> settings;
    bool numeric = false;
    for (const KeptPoint& point : study.points) {
        CostedSetting setting{{}, point.error, point.uncertain};
        const auto count = point.counters.find(costs.name);
        if (axis == CostAxis::time && point.time && point.measured())
            setting.cost = timed(point.time->median, point.time->interval);
        else if (axis == CostAxis::work && point.measured() && count != point.counters.end())
            setting.cost = counted(count->second);
        settings.push_back(setting);
        for (const render::Json& value : point.values) numeric = numeric || value.is_number();
    }
    return judged(std::move(costs), settings, numeric);
}

}  // namespace vitrine::study
