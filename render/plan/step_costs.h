#pragma once

#include "render/plan/render_backend.h"

#include <map>
#include <string>

namespace vitrine::render {

/// What steps took when they last ran: what leaving them out saves now.
class StepCosts {
public:
    void note(const FrameReport&);
    /// Milliseconds; negative where it never ran and was timed. The ledger has one line for an exhibit that is left out
    /// as a whole, "fur": its steps in the frame that drew it last, but for "fur/shadow", which has a line of its own.
    [[nodiscard]] double of(const std::string& step) const;

private:
    std::map<std::string, double> steps_;
    std::map<std::string, double> groups_;  ///< By what stands before the slash.
};

}  // namespace vitrine::render
