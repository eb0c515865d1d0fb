#pragma once

#include "exhibits/framework/table/parameters.h"

#include <optional>

namespace vitrine::ui {

/// Returns whether a control can move the parameter: numbers with a range, switches and choices.
[[nodiscard]] bool isMovable(const ParameterInfo&);
/// Returns the value at a position of a control, 0 to 1. Numbers follow their slider. A switch is on from 0.5. Choices
/// share the way evenly. Requires `isMovable`.
[[nodiscard]] Value valueAt(const ParameterInfo&, double position);
/// Returns the position of a value, 0 to 1; that of a switch or a choice is the middle of its part of the way. Requires
/// `isMovable`.
[[nodiscard]] double positionOf(const ParameterInfo&, const Value&);

/// Soft takeover: a control moves a parameter only after it has touched or passed the parameter's present value, so
/// that the value never jumps. A value that something else has changed must be touched again.
class Takeover {
public:
    /// Largest distance at which a control touches a value: half a step of a control with 128 positions.
    static constexpr double touch = 0.5 / 127;

    /// Takes a new position of the control. Returns the value to set; nullopt while the control has not taken over.
    [[nodiscard]] std::optional<Value> move(const ParameterInfo&, const Value& present, double position);
    /// Returns the position at which the control stands while it has not taken over; nullopt: it has, or its position
    /// is not known.
    [[nodiscard]] std::optional<double> waitingAt(const Value& present) const;

private:
    std::optional<double> last_;  ///< Last position of the control.
    std::optional<Value> set_;    ///< Value that it set last.
};

}  // namespace vitrine::ui
