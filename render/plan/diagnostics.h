#pragma once

#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine::render {

/// What the log hears of frames: one line when bad input begins, however many frames it lasts, and another when
/// it comes again after a frame without it.
class Diagnostics {
public:
    /// The complaints of this frame that the last one did not have.
    [[nodiscard]] std::vector<CulledPass> begun(const std::vector<CulledPass>& skipped);

private:
    std::vector<std::string> last_;
};

/// "fur/clock: the time is not a number"; what is said of a file says itself where it belongs.
[[nodiscard]] std::string lineOf(const CulledPass& complaint);

}  // namespace vitrine::render
