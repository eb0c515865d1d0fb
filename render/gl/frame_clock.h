#pragma once

#include "render/gl/object.h"
#include "render/measure/clock_trial.h"

#include <vector>

namespace vitrine::render::gl {

/// Measures the time between marks in the stream of OpenGL commands of the current context.
class FrameClock {
public:
    explicit FrameClock(ClockMethod method) : method_(method) {}

    /// Sets a mark after the commands issued so far. Waits for them to finish, unless the clock is a timer query.
    void mark();
    /// Returns the seconds from each mark to the next; waits for the last one.
    [[nodiscard]] std::vector<double> seconds();

private:
    ClockMethod method_;
    std::vector<QueryName> queries_;
    std::vector<double> readings_;
};

/// Chooses the clock for the current context: draws a known load ×1, ×2 and ×4 and compares the measured times. Done
/// once per process and renderer, in some tens of milliseconds. `software` says whether the renderer runs on the CPU.
[[nodiscard]] const ClockChoice& trustedClock(bool software);

}  // namespace vitrine::render::gl
