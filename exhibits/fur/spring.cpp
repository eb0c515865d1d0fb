#include "exhibits/fur/spring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::fur {
namespace {

/// Cosine and sine parts of a damped oscillation after t seconds, including the decay.
struct Decay {
    double c, s;
};

Decay decay(const Spring& spring, double t)
{
    const double p = spring.zeta * spring.omega;
    const double d = spring.omega * spring.omega * (1 - spring.zeta) * (1 + spring.zeta);
    const double x = d * t * t;
    if (std::abs(x) < 1e-3) {
        // Critical damping or a short step: cos and sin(.)/. by their series, which do not divide by the root of d.
        const double e = std::exp(-p * t);
        return {e * (1 - x / 2 * (1 - x / 12 * (1 - x / 30))), e * t * (1 - x / 6 * (1 - x / 20 * (1 - x / 42)))};
    }
    if (d > 0) {
        const double w = std::sqrt(d);
        const double e = std::exp(-p * t);
        return {e * std::cos(w * t), e * std::sin(w * t) / w};
    }
    // Overdamped: the hyperbolic functions overflow before the decay reduces them, but their product does not.
    const double mu = std::sqrt(-d);
    const double slow = std::exp(-spring.omega * spring.omega / (p + mu) * t);
    const double fast = std::exp(-(p + mu) * t);
    return {0.5 * (slow + fast), 0.5 * (slow - fast) / mu};
}

}  // namespace

SpringState advance(const SpringState& state, const glm::dvec3& target, const Spring& spring, double seconds,
                    FurSpring model)
{
    if (!(seconds > 0) || !std::isfinite(seconds)) return state;
    const glm::dvec3 x = state.value - target;
    const double k = spring.omega * spring.omega;
    const double c = 2 * spring.zeta * spring.omega;
    if (model == FurSpring::explicitEuler)
        return {state.value + state.rate * seconds, state.rate - (k * x + c * state.rate) * seconds};
    if (model == FurSpring::semiImplicit) {
        const glm::dvec3 rate = state.rate - (k * x + c * state.rate) * seconds;
        return {state.value + rate * seconds, rate};
    }
    if (k == 0) return {state.value + state.rate * seconds, state.rate};
    const Decay d = decay(spring, seconds);
    const double p = 0.5 * c;
    return {target + x * (d.c + p * d.s) + state.rate * d.s, state.rate * (d.c - p * d.s) - x * (k * d.s)};
}

double energy(const SpringState& state, const glm::dvec3& target, const Spring& spring)
{
    const glm::dvec3 x = state.value - target;
    return 0.5 * (glm::dot(state.rate, state.rate) + spring.omega * spring.omega * glm::dot(x, x));
}

SpringState limited(const SpringState& state, double limit)
{
    const double length = glm::length(state.value);
    if (!std::isfinite(length)) return {};  // The unstable method has overflowed.
    if (length <= limit) return state;
    const glm::dvec3 out = state.value / length;
    return {out * limit, state.rate - out * std::max(glm::dot(state.rate, out), 0.0)};
}

glm::dvec3 rotationVector(const glm::dquat& q)
{
    const double sign = q.w < 0 ? -1 : 1;
    glm::dvec3 axis(sign * q.x, sign * q.y, sign * q.z);
    const double sine = glm::length(axis);
    if (sine < 1e-300) return glm::dvec3(0);
    if (q.w == 0) {
        const double first = axis.x != 0 ? axis.x : axis.y != 0 ? axis.y : axis.z;
        if (first < 0) axis = -axis;
    }
    return axis * (2 * std::atan2(sine, sign * q.w) / sine);
}

glm::dquat rotationOf(const glm::dvec3& r)
{
    const double angle = glm::length(r);
    // sin(a/2)/a by its series where the quotient would be 0/0.
    const double s = angle < 1e-4 ? 0.5 - angle * angle / 48 : std::sin(0.5 * angle) / angle;
    return {std::cos(0.5 * angle), s * r.x, s * r.y, s * r.z};
}

}  // namespace vitrine::fur
