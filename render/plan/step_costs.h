#pragma once

#include "render/plan/render_backend.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::render {

/// Measured time of each step when it last ran. It estimates what leaving the step out saves now.
class StepCosts {
public:
    void note(const FrameReport&);
    /// Returns milliseconds; negative if the step was never timed. The frame report has one line for an exhibit that is
    /// left out as a whole, "fur". Its time is the sum of its steps in the frame that last drew it, without
    /// "fur/shadow", which has its own line.
    [[nodiscard]] double of(const std::string& step) const;
    /// Returns the time of each variant of a step when it was last drawn, by `Pass::variant`, in the order of first
    /// appearance. At most 64 variants of a step are kept.
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& variantsOf(const std::string& step) const;

private:
    std::map<std::string, double> steps_;
    std::map<std::string, double> groups_;  ///< By the part of the step's name before the slash.
    std::map<std::string, std::vector<std::pair<std::string, double>>> variants_;
};

}  // namespace vitrine::render
