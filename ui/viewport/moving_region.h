#pragma once

#include "exhibits/museum/museum.h"

#include <optional>

namespace vitrine::ui {

/// Part of a static picture in which something moves, and when it is drawn again by itself. Times are seconds of one
/// steady clock.
class MovingRegion {
public:
    /// Sets the part; nothing: the whole picture is static, or is drawn as a whole.
    void set(std::optional<PictureRegion>);
    [[nodiscard]] const std::optional<PictureRegion>& part() const { return part_; }

    /// Takes note of the state after a tick. `moves`: something moves now; `changed`: something changed since the last
    /// tick. One more drawing after the motion has ended shows its final state.
    void passTick(bool moves, bool changed);
    [[nodiscard]] bool isDue(double now) const { return part_ && isDue_ && now >= restsUntil_; }
    /// Returns whether a drawing is due now or after a rest. `moves`: something moves now.
    [[nodiscard]] bool isWaiting(bool moves) const { return part_ && (isDue_ || moves); }
    /// Seconds until the next drawing can be due.
    [[nodiscard]] double wait(double now) const;
    void begun() { isDue_ = false; }
    /// A drawing took this many seconds. A rest follows, which leaves time for other work.
    void drawn(double now, double seconds);

private:
    std::optional<PictureRegion> part_;
    bool isDue_ = false;
    bool moved_ = false;     // Something moved at the last tick.
    double restsUntil_ = 0;  // Earliest time of the next drawing.
};

}  // namespace vitrine::ui
