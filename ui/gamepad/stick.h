#pragma once

namespace vitrine::ui {

/// How far a stick is pushed, and whereto: its length is 0 to 1.
struct Push {
    double x = 0, y = 0;
    bool operator==(const Push&) const = default;
};

constexpr double stickRests = 0.24;   ///< Of the way: what the makers of usual sticks call their middle.
constexpr double stickIsFull = 0.95;  ///< Many do not reach their edge.
constexpr double triggerRests = 0.12;

/// What a stick means by its position, each coordinate -1 to 1: nothing around the middle, in whatever direction; from
/// there its square, so that it sets in without a jerk and is fine near the middle. Directions are kept.
[[nodiscard]] Push pushOf(double x, double y);
/// The same of a trigger, 0 to 1.
[[nodiscard]] double pullOf(double trigger);

}  // namespace vitrine::ui
