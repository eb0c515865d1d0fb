#pragma once

#include "render/plan/render_backend.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// What became of a pass in one of two frames.
struct PassSide {
    enum class State : std::uint8_t { ran, skipped, absent };
    State state = State::absent;
    double milliseconds = -1;  ///< Negative where it was not measured.
    std::string why = {};      ///< Why it ran or was skipped; empty when absent.
};

/// A pass, or step on the CPU, beside the same one of another frame.
struct PassCost {
    std::string name;
    render::Work work = render::Work::raster;
    PassSide a, b;

    [[nodiscard]] bool ranInOnlyOne() const
    {
        return (a.state == PassSide::State::ran) != (b.state == PassSide::State::ran);
    }
};

/// The ledgers of two frames side by side: in the order in which A ran them, what only B ran behind what B ran before
/// it, then what neither ran. Passes are told by name; the n-th of one name belongs to the n-th of the other.
[[nodiscard]] std::vector<PassCost> passCosts(const render::FrameReport& a, const render::FrameReport& b);

/// A counter of two frames; nothing: that frame did not count it.
struct CounterCost {
    std::string name;
    std::optional<std::int64_t> a, b;
};
/// By name; those of the program's state are left out.
[[nodiscard]] std::vector<CounterCost> counterCosts(const render::FrameReport& a, const render::FrameReport& b);

}  // namespace vitrine
