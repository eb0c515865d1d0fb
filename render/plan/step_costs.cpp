#include "render/plan/step_costs.h"

#include <algorithm>

namespace vitrine::render {
namespace {

using Variants = std::vector<std::pair<std::string, double>>;

void noteVariant(Variants& known, const StepReport& step)
{
    constexpr std::size_t most = 64;
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const auto& variant) { return variant.first == step.variant; });
    if (found != known.end())
        found->second = step.milliseconds;
    else if (known.size() < most)
        known.emplace_back(step.variant, step.milliseconds);
}

}  // namespace

void StepCosts::note(const FrameReport& report)
{
    std::map<std::string, double> groups;
    for (const StepReport& step : report.ran) {
        if (step.milliseconds < 0) continue;
        steps_[step.name] = step.milliseconds;
        if (!step.variant.empty()) noteVariant(variants_[step.name], step);
        const std::string group = step.name.substr(0, step.name.find('/'));
        if (group != step.name && step.name != group + "/shadow") groups[group] += step.milliseconds;
    }
    // A group with a skipped step keeps its older time: its simulation may still run for the sake of a shadow.
    for (const CulledPass& step : report.skipped) groups.erase(step.name);
    for (const auto& [group, milliseconds] : groups) groups_[group] = milliseconds;
}

double StepCosts::of(const std::string& step) const
{
    for (const auto* known : {&steps_, &groups_})
        if (const auto found = known->find(step); found != known->end()) return found->second;
    return -1;
}

const Variants& StepCosts::variantsOf(const std::string& step) const
{
    static const Variants none;
    const auto found = variants_.find(step);
    return found == variants_.end() ? none : found->second;
}

}  // namespace vitrine::render
