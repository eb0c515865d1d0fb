#include "exhibits/framework/time/animation.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/morph.h"
#include "exhibits/framework/table/value_text.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine {
namespace {

constexpr double standsStill = std::numeric_limits<double>::infinity();

double eased(Ease ease, double t)
{
    switch (ease) {
    case Ease::linear: return t;
    case Ease::in: return t * t;
    case Ease::out: return 1 - (1 - t) * (1 - t);
    case Ease::inOut: return t * t * (3 - 2 * t);
    }
    return t;
}

/// Returns the time, as a share of the way, at which the ease is at its middle.
double halfway(Ease ease)
{
    if (ease == Ease::in) return std::numbers::sqrt2 / 2;
    return ease == Ease::out ? 1 - std::numbers::sqrt2 / 2 : 0.5;
}

/// Position in the current period, 0 to 1, and the number of that period.
struct Phase {
    double part = 0, period = 0;
};
Phase phaseOf(const Motion& motion, double time)
{
    const double periods = time / motion.period + motion.phase;
    const double whole = std::floor(periods);
    return {periods - whole, whole};
}

/// Returns the value of one corner of the noise, 0 to 1. The finalizer of SplitMix64 (Steele, Lea, Flood 2014, "Fast
/// Splittable Pseudorandom Number Generators").
double cornerOf(std::uint32_t seed, double corner)
{
    std::uint64_t x =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(corner)) + 0x9E3779B97F4A7C15ULL * (seed + 1);
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    x ^= x >> 31U;
    return static_cast<double>(x >> 11U) * 0x1p-53;
}

/// Value noise with a continuous second derivative (Perlin 2002, "Improving Noise").
double noiseAt(const Motion& motion, const Phase& phase)
{
    const double t = phase.part;
    const double fade = t * t * t * (t * (6 * t - 15) + 10);
    return std::lerp(cornerOf(motion.seed, phase.period), cornerOf(motion.seed, phase.period + 1), fade);
}

double thereAndBack(double part)
{
    return part < 0.5 ? 2 * part : 2 - 2 * part;
}

/// Returns the seconds from phase `now` to phase `then`, in this period or the next.
double until(const Motion& motion, double now, double then)
{
    return (then > now ? then - now : then + 1 - now) * motion.period;
}

/// Returns when a parameter without intermediate values is next switched.
double nextSwitch(const Motion& motion, double time)
{
    const double part = phaseOf(motion, time).part;
    switch (motion.kind) {
    case MotionKind::ease: {
        const double then = motion.start + halfway(motion.ease) * motion.period;
        return time < then ? then - time : standsStill;
    }
    case MotionKind::sine: return std::min(until(motion, part, 0.25), until(motion, part, 0.75));
    case MotionKind::triangle: {
        const double there = halfway(motion.ease) / 2;
        return std::min(until(motion, part, there), until(motion, part, 1 - there));
    }
    default: return 0;
    }
}

bool isSwitched(const ParameterInfo& parameter)
{
    return parameter.kind == Kind::toggle || parameter.kind == Kind::choice;
}

template <std::size_t Count>
std::string_view nameOf(const std::array<std::string_view, Count>& names, std::size_t which)
{
    return names[which];
}

}  // namespace

double positionOf(const Motion& motion, const AnimationTime& moment)
{
    if (motion.kind == MotionKind::distance) {
        const double distance = motion.heldAt.value_or(moment.distance), wide = motion.farthest - motion.nearest;
        if (!(wide > 0)) return distance < motion.nearest ? 0 : 1;
        return eased(motion.ease, std::clamp((distance - motion.nearest) / wide, 0.0, 1.0));
    }
    const double time = motion.heldAt.value_or(moment.time);
    if (motion.kind == MotionKind::ease)
        return eased(motion.ease, std::clamp((time - motion.start) / motion.period, 0.0, 1.0));
    const Phase phase = phaseOf(motion, time);
    switch (motion.kind) {
    case MotionKind::sine: return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * phase.part);
    case MotionKind::triangle: return eased(motion.ease, thereAndBack(phase.part));
    case MotionKind::steps: return std::floor(phase.part * motion.steps) / (motion.steps - 1);
    default: return noiseAt(motion, phase);
    }
}

Value valueOf(const ParameterInfo& parameter, const Motion& motion, const AnimationTime& moment)
{
    return morphed(parameter, motion.from, motion.to, positionOf(motion, moment));
}

double nextChangeOf(const ParameterInfo& parameter, const Motion& motion, double time)
{
    if (motion.heldAt || motion.kind == MotionKind::distance || motion.from == motion.to) return standsStill;
    if (motion.kind == MotionKind::steps) {
        const double part = phaseOf(motion, time).part * motion.steps;
        return (std::floor(part) + 1 - part) * motion.period / motion.steps;
    }
    if (isSwitched(parameter)) return nextSwitch(motion, time);
    if (motion.kind != MotionKind::ease) return 0;
    if (time < motion.start) return motion.start - time;
    return time < motion.start + motion.period ? 0 : standsStill;
}

double nextMotion(const ParameterValues& values, double time)
{
    double next = standsStill;
    if (values.motions().empty()) return next;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (const Motion* motion = values.motion(i); motion && acts(values, i))
            next = std::min(next, nextChangeOf(values.rows()[i], *motion, time));
    return next;
}

ParameterValues valuesAt(const ParameterValues& values, const AnimationTime& moment)
{
    ParameterValues now = values;
    if (values.motions().empty()) return now;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (const Motion* motion = values.motion(i)) now.setParameter(i, valueOf(values.rows()[i], *motion, moment));
    return now;
}

ParameterValues valuesAtEnd(const ParameterValues& values, int end)
{
    ParameterValues there = values;
    if (values.motions().empty()) return there;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (const Motion* motion = values.motion(i)) there.setParameter(i, end == 0 ? motion->from : motion->to);
    return there;
}

Motion held(Motion motion, const AnimationTime& moment)
{
    if (!motion.heldAt) motion.heldAt = motion.kind == MotionKind::distance ? moment.distance : moment.time;
    return motion;
}

Motion resumed(Motion motion, const AnimationTime& moment)
{
    if (!motion.heldAt) return motion;
    const double missed = moment.time - *motion.heldAt;
    motion.heldAt.reset();
    if (motion.kind == MotionKind::ease) motion.start += missed;
    if (motion.kind == MotionKind::ease || motion.kind == MotionKind::distance) return motion;
    motion.phase -= missed / motion.period;
    // Noise differs in every period, so its phase is kept; all others repeat.
    if (motion.kind != MotionKind::noise) motion.phase -= std::floor(motion.phase);
    return motion;
}

std::string describe(const ParameterInfo& parameter, const Motion& motion)
{
    using render::shortestNumber;
    const std::string_view symbol = info(parameter.unit).symbol;
    const auto shownValue = [&](const Value& value) {
        std::string text = formatValue(parameter, value);
        if (parameter.isNumeric() && !symbol.empty()) (text += ' ') += symbol;
        return text;
    };
    std::string text(nameOf(motionKinds, static_cast<std::size_t>(motion.kind)));
    const bool way = motion.kind == MotionKind::ease || motion.kind == MotionKind::distance;
    ((text += way ? " from " : " between ") += shownValue(motion.from)) += way ? " to " : " and ";
    text += shownValue(motion.to);
    if (motion.kind == MotionKind::distance)
        text += " at " + shortestNumber(motion.nearest) + " to " + shortestNumber(motion.farthest) + " m";
    else
        text += (motion.kind == MotionKind::ease ? " within " : ", period ") + shortestNumber(motion.period) + " s";
    return motion.heldAt ? text + ", held" : text;
}

}  // namespace vitrine
