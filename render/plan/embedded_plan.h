#pragma once

#include "render/plan/frame_plan.h"

#include <string>

namespace vitrine::render {

/// Place of a plan within another one.
struct EmbeddedPlan {
    std::string passPrefix;                 ///< Prefix of the names of its passes: "your_shader/picture of fur/".
    std::string imagePrefix;                ///< Prefix of the names of its images, buffers and states.
    std::string reason;                     ///< Reason of its passes, for people: Pass::reason.
    PassPhase phase = PassPhase::simulate;  ///< Phase of all its passes, which keep their order.
    bool onlyKept = false;  ///< Declares its persistent images and buffers, so that they survive, and adds no pass.
};

/// Adds the passes of `inner`, a complete and pruned plan, to `plan`, with images, buffers and states of their own. The
/// size of the inner picture is independent of the outer one. The renderer waits for its programs only where it has no
/// other program of the same family. Histories of `inner` are not continued: it must not read the frame before.
/// Complaints of `inner` are added, other skipped passes are not.
void embed(FramePlan& plan, const FramePlan& inner, const EmbeddedPlan&);

}  // namespace vitrine::render
