#pragma once

#include "render/plan/frame_plan.h"

#include <string>
#include <string_view>

namespace vitrine::test {

/// Why a step is not run.
inline std::string reasonFor(const render::FramePlan& plan, std::string_view name)
{
    const render::CulledPass* skipped = plan.findSkipped(name);
    return skipped ? skipped->reason : plan.find(name) ? "it ran" : "not in the plan";
}

/// Whether any pass that will run has a name that starts so.
inline bool runs(const render::FramePlan& plan, std::string_view start)
{
    for (const render::Pass& pass : plan.passes())
        if (pass.name.substr(0, start.size()) == start) return true;
    return false;
}

}  // namespace vitrine::test
