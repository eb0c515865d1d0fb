#pragma once

#include "render/plan/render_backend.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::render {

/// What steps took when they last ran: what leaving them out saves now.
class StepCosts {
public:
    void note(const FrameReport&);
    /// Milliseconds; negative where it never ran and was timed. The ledger has one line for an exhibit that is left out
    /// as a whole, "fur": its steps in the frame that drew it last, but for "fur/shadow", which has a line of its own.
    [[nodiscard]] double of(const std::string& step) const;
    /// What each variant of a step took when it was last drawn, by `Pass::variant`, in the order in which they were
    /// first seen. At most 64 are kept of a step.
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& variantsOf(const std::string& step) const;

private:
    std::map<std::string, double> steps_;
    std::map<std::string, double> groups_;  ///< By what stands before the slash.
    std::map<std::string, std::vector<std::pair<std::string, double>>> variants_;
};

}  // namespace vitrine::render
