#pragma once

#include "render/plan/render_backend.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::compare {

/// State of a pass in one of two frames.
struct PassSide {
    enum class State : std::uint8_t { ran, skipped, absent };
    State state = State::absent;
    double milliseconds = -1;  ///< Negative if not measured.
    std::string why = {};      ///< Why it ran or was skipped; empty when absent.
};

/// A pass, or a step on the CPU, in two frames.
struct PassCost {
    std::string name;
    render::Work work = render::Work::raster;
    PassSide a, b;

    [[nodiscard]] bool ranInOnlyOne() const
    {
        return (a.state == PassSide::State::ran) != (b.state == PassSide::State::ran);
    }
};

/// Returns the frame reports of two frames side by side. Passes are in A's order. A pass that only B ran follows the
/// one that B ran before it; passes that neither ran come last. Passes are matched by name, and the n-th of a name to
/// the n-th of the other frame.
[[nodiscard]] std::vector<PassCost> passCosts(const render::FrameReport& a, const render::FrameReport& b);

/// Counter of two frames; unset if that frame did not count it.
struct CounterCost {
    std::string name;
    std::optional<std::int64_t> a, b;
};
/// Returns the counters by name, without those of the program's state.
[[nodiscard]] std::vector<CounterCost> counterCosts(const render::FrameReport& a, const render::FrameReport& b);

}  // namespace vitrine::compare
