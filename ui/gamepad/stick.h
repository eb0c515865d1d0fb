#pragma once

namespace vitrine::ui {

/// Deflection of a stick as a vector of length 0 to 1.
struct Push {
    double x = 0, y = 0;
    bool operator==(const Push&) const = default;
};

constexpr double stickRests = 0.24;   ///< Dead zone as a part of the range, as makers of usual sticks specify it.
constexpr double stickIsFull = 0.95;  ///< Position that counts as fully deflected: many sticks do not reach their edge.
constexpr double triggerRests = 0.12;

/// Converts a stick position, each coordinate -1 to 1, to a deflection. Within the round dead zone it is 0. From there
/// it grows with the square of the distance, so that it starts smoothly and is fine near the middle. Directions are
/// kept.
[[nodiscard]] Push pushOf(double x, double y);
/// The same for a trigger, 0 to 1.
[[nodiscard]] double pullOf(double trigger);

}  // namespace vitrine::ui
