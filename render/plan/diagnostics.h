#pragma once

#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine::render {

/// Filter for the log: a complaint about bad input gives one line when it begins, however many frames it lasts. It
/// gives another line only when it comes back after a frame without it.
class Diagnostics {
public:
    /// Returns the complaints of this frame that the last frame did not have.
    [[nodiscard]] std::vector<CulledPass> begun(const std::vector<CulledPass>& skipped);

private:
    std::vector<std::string> last_;
};

/// Returns the line for the log: "fur/clock: the time is not a number". A complaint about a file has no prefix, because
/// its text names the parameter and the file.
[[nodiscard]] std::string lineOf(const CulledPass& complaint);

}  // namespace vitrine::render
