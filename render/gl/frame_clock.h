#pragma once

#include "render/gl/object.h"
#include "render/measure/clock_trial.h"

#include <vector>

namespace vitrine::render::gl {

/// Takes times between marks in the stream of OpenGL commands, on the context that is current.
class FrameClock {
public:
    explicit FrameClock(ClockMethod method) : method_(method) {}

    /// The work given so far ends here. Waits for it, unless the clock is a timer query.
    void mark();
    /// Seconds from each mark to the next; waits for the last one.
    [[nodiscard]] std::vector<double> seconds();

private:
    ClockMethod method_;
    std::vector<QueryName> queries_;
    std::vector<double> readings_;
};

/// What clock to take times with on the current context: draws a known load ×1, ×2 and ×4 and compares. Done once
/// per process and renderer, in some tens of milliseconds. `software` says whether the renderer runs on the processor.
[[nodiscard]] const ClockChoice& trustedClock(bool software);

}  // namespace vitrine::render::gl
