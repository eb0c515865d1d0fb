// Springs of the fur, compared with an independent integrator. Their stability tests are in
// tests/stability/motion_test.cpp.

#include "exhibits/fur/spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine::fur {
namespace {

using std::numbers::pi;
constexpr FurSpring closed = FurSpring::closedForm;

/// Integrates by the classic fourth-order Runge-Kutta method, with steps far below the period; uses no closed form.
SpringState integrated(SpringState s, const glm::dvec3& target, const Spring& spring, double seconds)
{
    const double fastest = spring.omega * (1 + 2 * spring.zeta);
    const auto steps = static_cast<int>(std::ceil(std::max(seconds * fastest * 200, 200.0)));
    const double h = seconds / steps;
    const auto rate = [&](const SpringState& a) {
        return SpringState{a.rate,
                           -spring.omega * spring.omega * (a.value - target) - 2 * spring.zeta * spring.omega * a.rate};
    };
    const auto plus = [](const SpringState& a, const SpringState& d, double k) {
        return SpringState{a.value + k * d.value, a.rate + k * d.rate};
    };
    for (int i = 0; i < steps; ++i) {
        const SpringState a = rate(s);
        const SpringState b = rate(plus(s, a, h / 2));
        const SpringState c = rate(plus(s, b, h / 2));
        const SpringState d = rate(plus(s, c, h));
        s.value += h / 6 * (a.value + 2.0 * b.value + 2.0 * c.value + d.value);
        s.rate += h / 6 * (a.rate + 2.0 * b.rate + 2.0 * c.rate + d.rate);
    }
    return s;
}

const SpringState start{{0.7, -0.2, 0.1}, {3, 1, -8}};
const glm::dvec3 target(0.1, -0.3, 0);

TEST(Spring, FollowsAnIndependentIntegratorUnderAtAndOverCriticalDamping)
{
    for (const double hertz : {0.3, 2.2, 12.0}) {
        for (const double zeta : {0.0, 0.15, 0.9, 0.999, 1 - 1e-9, 1.0, 1 + 1e-9, 1.001, 1.1, 3.0}) {
            const Spring spring{2 * pi * hertz, zeta};
            for (const double seconds : {1.0 / 240, 1.0 / 60, 0.4}) {
                const SpringState exact = integrated(start, target, spring, seconds);
                const SpringState found = advance(start, target, spring, seconds, closed);
                EXPECT_LT(glm::length(found.value - exact.value), 1e-8) << hertz << ' ' << zeta << ' ' << seconds;
                EXPECT_LT(glm::length(found.rate - exact.rate), 1e-8 * (1 + 2 * pi * hertz))
                    << hertz << ' ' << zeta << ' ' << seconds;
            }
        }
    }
}

TEST(Rotation, GoesThereAndBackFromNothingToHalfATurn)
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.9, -0.4));
    for (const double angle : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14}) {
        const glm::dvec3 r = rotationVector(rotationOf(axis * angle));
        EXPECT_LT(glm::length(r - axis * angle), 1e-14 + 1e-12 * angle) << angle;
    }
    // Beyond half a turn, the shorter rotation is found.
    EXPECT_LT(glm::length(rotationVector(rotationOf(axis * 4.0)) - axis * (4.0 - 2 * pi)), 1e-12);
}

}  // namespace
}  // namespace vitrine::fur
