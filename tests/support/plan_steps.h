#pragma once

#include "render/plan/frame_plan.h"

#include <string>
#include <string_view>

namespace vitrine::test {

/// Returns why a pass is not run.
inline std::string reasonFor(const render::FramePlan& plan, std::string_view name)
{
    const render::CulledPass* skipped = plan.findSkipped(name);
    return skipped ? skipped->reason : plan.find(name) ? "it ran" : "not in the plan";
}

/// Returns whether a pass that will run has a name with this beginning.
inline bool runs(const render::FramePlan& plan, std::string_view start)
{
    for (const render::Pass& pass : plan.passes())
        if (pass.name.substr(0, start.size()) == start) return true;
    return false;
}

}  // namespace vitrine::test
