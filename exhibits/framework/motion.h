#pragma once

#include "exhibits/framework/value.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

struct ParameterInfo;
class ParameterValues;

/// What a row goes by while it moves between two values: where "position" 0 is `Motion::from` and 1 is `Motion::to`.
enum class MotionKind : std::uint8_t {
    ease,      ///< Once there, from `start` on within `period`; then it stays.
    sine,      ///< There and back in each period, slowest at both ends.
    triangle,  ///< There and back in each period, each way by the ease.
    steps,     ///< In each period through `steps` evenly spaced positions, both ends among them, then from the first.
    noise,     ///< From one random position to the next within each period, smoothly.
    distance   ///< As far as the visitor is away: `from` at `nearest` or nearer, `to` at `farthest` or farther.
};
inline constexpr std::array<std::string_view, 6> motionKinds{"ease", "sine", "triangle", "steps", "noise", "distance"};

/// How a way begins and ends: evenly, slow at first, slow at last, or both.
enum class Ease : std::uint8_t { linear, in, out, inOut };
inline constexpr std::array<std::string_view, 4> easeNames{"linear", "in", "out", "inOut"};

/// Whether it goes on for ever, by `phase`.
[[nodiscard]] constexpr bool isPeriodic(MotionKind kind)
{
    return kind != MotionKind::ease && kind != MotionKind::distance;
}
/// Whether it goes its ways by `ease`.
[[nodiscard]] constexpr bool isEased(MotionKind kind)
{
    return kind == MotionKind::ease || kind == MotionKind::triangle || kind == MotionKind::distance;
}

/// The limits that files and people are held to.
inline constexpr double shortestPeriod = 0.01, longestPeriod = 1e6;  // Seconds.
inline constexpr int mostMotionSteps = 1000;

/// How one row moves, as a function of the exhibits' clock and of the visitor's distance alone.
struct Motion {
    MotionKind kind = MotionKind::sine;
    Value from, to;
    Ease ease = Ease::inOut;           ///< Where `isEased`.
    double period = 4;                 ///< Seconds; of all but distance.
    double phase = 0;                  ///< In periods, where `isPeriodic`: where it stands when the clock begins.
    double start = 0;                  ///< Seconds on the clock; of ease.
    int steps = 4;                     ///< At least 2.
    std::uint32_t seed = 1;            ///< Of noise.
    double nearest = 1, farthest = 6;  ///< Meters; of distance.
    std::optional<double> heldAt;      ///< It stands as it is at this second, or at so many meters.

    bool operator==(const Motion&) const = default;
};

/// By the names of their rows.
using Motions = std::map<std::string, Motion, std::less<>>;

/// What motions are evaluated at.
struct MotionMoment {
    double time = 0;      ///< Seconds on the exhibits' clock.
    double distance = 0;  ///< Meters from the eye to the middle of what moves.
};

/// Why a row of this description cannot move, as a full sentence; empty: it can.
///  - files and texts: every value would have to be read;
///  - rows of accuracy (`quality`): they say what a picture costs, size its images, and studies and the drawing itself
///    set them;
/// Every other row can. A count, choice or switch may stand for a shader or a mesh of its own, which is then made at
/// its first visit and found again at the next ones.
[[nodiscard]] std::string_view whyUnmoved(const ParameterInfo&);

/// Where between its ends a motion is, 0 to 1. The period is counted in double, so that it keeps its rhythm for days.
[[nodiscard]] double positionOf(const Motion&, const MotionMoment&);

/// What the row then is, in its own space: `morphed` from one end to the other, never out of range.
[[nodiscard]] Value valueOf(const ParameterInfo&, const Motion&, const MotionMoment&);

/// Seconds until the row next has another value by itself: 0 while it moves, infinity when it stands, is held, or goes
/// by the distance alone. Switches and choices change in the middle of a way only.
[[nodiscard]] double nextChangeOf(const ParameterInfo&, const Motion&, double time);

/// The same of all rows that move and act; infinity: none does.
[[nodiscard]] double nextMotion(const ParameterValues&, double time);

/// The values at that moment: every row that moves has the value that it then has, and still moves.
[[nodiscard]] ParameterValues valuesAt(const ParameterValues&, const MotionMoment&);

/// The values with every moving row at one end of its way: 0, `from`; 1, `to`.
[[nodiscard]] ParameterValues valuesAtEnd(const ParameterValues&, int end);

/// The same motion held as it is at this moment, or going on from where it was held.
[[nodiscard]] Motion held(Motion, const MotionMoment&);
[[nodiscard]] Motion resumed(Motion, const MotionMoment&);

/// "sine between 0.1 and 0.9, period 4 s", for people.
[[nodiscard]] std::string describe(const ParameterInfo&, const Motion&);

}  // namespace vitrine
