#include "exhibits/compare/pass_costs.h"

#include "exhibits/study/study_picture.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace vitrine::compare {
namespace {

/// Name of a step, and its index among those of that name.
using StepKey = std::pair<std::string, int>;
struct PassLine {
    StepKey key;
    render::Work work;
    PassSide side;
};

std::vector<PassLine> linesOf(const render::FrameReport& report)
{
    std::vector<PassLine> lines;
    std::map<std::string, int> seen;
    for (const render::StepReport& step : report.ran) {
        const std::string why = step.variant.empty() ? step.reason : step.reason + "; " + step.variant;
        lines.push_back({{step.name, seen[step.name]++}, step.work, {PassSide::State::ran, step.milliseconds, why}});
    }
    for (const render::CulledPass& step : report.skipped)
        lines.push_back({{step.name, seen[step.name]++}, step.work, {PassSide::State::skipped, -1, step.reason}});
    return lines;
}

bool hasRun(const PassCost& cost)
{
    return cost.a.state == PassSide::State::ran || cost.b.state == PassSide::State::ran;
}

}  // namespace

std::vector<PassCost> passCosts(const render::FrameReport& a, const render::FrameReport& b)
{
    std::vector<std::pair<StepKey, PassCost>> merged;
    for (PassLine& line : linesOf(a))
        merged.emplace_back(line.key, PassCost{line.key.first, line.work, std::move(line.side), {}});
    std::size_t after = 0;  // Position for passes of B alone.
    for (PassLine& line : linesOf(b)) {
        const auto found =
            std::find_if(merged.begin(), merged.end(), [&](const auto& known) { return known.first == line.key; });
        if (found != merged.end()) {
            found->second.b = std::move(line.side);
            after = static_cast<std::size_t>(found - merged.begin()) + 1;
        } else {
            PassCost cost{line.key.first, line.work, {}, std::move(line.side)};
            merged.emplace(merged.begin() + static_cast<std::ptrdiff_t>(after), line.key, std::move(cost));
            ++after;
        }
    }
    std::vector<PassCost> costs;
    for (auto& [key, cost] : merged) costs.push_back(std::move(cost));
    std::stable_partition(costs.begin(), costs.end(), hasRun);
    return costs;
}

std::vector<CounterCost> counterCosts(const render::FrameReport& a, const render::FrameReport& b)
{
    std::map<std::string, CounterCost> byName;
    std::map<std::string, std::int64_t> ofA = a.counters, ofB = b.counters;
    study::eraseStateCounters(ofA);
    study::eraseStateCounters(ofB);
    for (const auto& [name, count] : ofA) byName[name].a = count;
    for (const auto& [name, count] : ofB) byName[name].b = count;
    std::vector<CounterCost> costs;
    for (auto& [name, cost] : byName) {
        cost.name = name;
        costs.push_back(std::move(cost));
    }
    return costs;
}

}  // namespace vitrine::compare
