#include "render/plan/step_costs.h"

namespace vitrine::render {

void StepCosts::note(const FrameReport& report)
{
    std::map<std::string, double> groups;
    for (const StepReport& step : report.ran) {
        if (step.milliseconds < 0) continue;
        steps_[step.name] = step.milliseconds;
        const std::string group = step.name.substr(0, step.name.find('/'));
        if (group != step.name && step.name != group + "/shadow") groups[group] += step.milliseconds;
    }
    // A simulation may go on for the sake of a shadow.
    for (const CulledPass& step : report.skipped) groups.erase(step.name);
    for (const auto& [group, milliseconds] : groups) groups_[group] = milliseconds;
}

double StepCosts::of(const std::string& step) const
{
    for (const auto* known : {&steps_, &groups_})
        if (const auto found = known->find(step); found != known->end()) return found->second;
    return -1;
}

}  // namespace vitrine::render
