#pragma once

#include "exhibits/framework/table/value.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Kind of animation of a parameter between two values: position 0 is `Motion::from` and 1 is `Motion::to`.
enum class MotionKind : std::uint8_t {
    ease,      ///< Once to the end, from `start` on within `period`; then it stays.
    sine,      ///< To the end and back in each period, slowest at both ends.
    triangle,  ///< To the end and back in each period, each way by the ease.
    steps,  ///< In each period through `steps` evenly spaced positions, both ends included, then from the first again.
    noise,  ///< Smoothly from one random position to the next within each period.
    distance  ///< By the distance of the viewer: `from` at `nearest` or nearer, `to` at `farthest` or farther.
};
inline constexpr std::array<std::string_view, 6> motionKinds{"ease", "sine", "triangle", "steps", "noise", "distance"};

/// Easing curve: linear, slow at first, slow at last, or both.
enum class Ease : std::uint8_t { linear, in, out, inOut };
inline constexpr std::array<std::string_view, 4> easeNames{"linear", "in", "out", "inOut"};

/// Returns whether the animation repeats forever and uses `phase`.
[[nodiscard]] constexpr bool isPeriodic(MotionKind kind)
{
    return kind != MotionKind::ease && kind != MotionKind::distance;
}
/// Returns whether the animation uses `ease`.
[[nodiscard]] constexpr bool isEased(MotionKind kind)
{
    return kind == MotionKind::ease || kind == MotionKind::triangle || kind == MotionKind::distance;
}

/// Limits for files and users.
inline constexpr double shortestPeriod = 0.01, longestPeriod = 1e6;  // Seconds.
inline constexpr int mostMotionSteps = 1000;

/// Animation of one parameter: a function of the exhibits' clock and of the viewer's distance alone.
struct Motion {
    MotionKind kind = MotionKind::sine;
    Value from, to;
    Ease ease = Ease::inOut;  ///< Used if `isEased`.
    double period = 4;        ///< Seconds; unused by distance.
    double phase = 0;         ///< In periods, used if `isPeriodic`: position in the period when the clock starts.
    double start = 0;         ///< Start on the clock, in seconds; used by the kind ease.
    int steps = 4;            ///< Number of positions, at least 2; used by the kind steps.
    std::uint32_t seed = 1;   ///< Seed of the random positions; used by the kind noise.
    double nearest = 1, farthest = 6;  ///< Distances of both ends in meters; used by the kind distance.
    std::optional<double> heldAt;      ///< The animation is frozen at this second, or at this distance in meters.

    bool operator==(const Motion&) const = default;
};

/// Animations by the names of their parameters.
using Motions = std::map<std::string, Motion, std::less<>>;

/// Arguments of an animation.
struct AnimationTime {
    double time = 0;      ///< Seconds on the exhibits' clock.
    double distance = 0;  ///< Meters from the eye to the center of the animated subject.
};

}  // namespace vitrine
