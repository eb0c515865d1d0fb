// The springs of the fur: against an independent integrator, and by what physics promises.

#include "exhibits/fur/spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vitrine {
namespace {

constexpr double pi = std::numbers::pi;
constexpr FurSpring closed = FurSpring::closedForm;

/// Classic Runge-Kutta of fourth order with steps far below the period: knows nothing of cosines.
SpringState integrated(SpringState s, const glm::dvec3& target, const Spring& spring, double seconds)
{
    const double fastest = spring.omega * (1 + 2 * spring.zeta);
    const auto steps = static_cast<int>(std::ceil(std::max(seconds * fastest * 200, 200.0)));
    const double h = seconds / steps;
    const auto rate = [&](const SpringState& a) {
        return SpringState{a.rate, -spring.omega * spring.omega * (a.value - target) - 2 * spring.zeta * spring.omega * a.rate};
    };
    const auto plus = [](const SpringState& a, const SpringState& d, double k) { return SpringState{a.value + k * d.value, a.rate + k * d.rate}; };
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

SpringState stepped(SpringState s, const glm::dvec3& target, const Spring& spring, double seconds, int steps, FurSpring method)
{
    for (int i = 0; i < steps; ++i) s = advance(s, target, spring, seconds / steps, method);
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
                EXPECT_LT(glm::length(found.rate - exact.rate), 1e-8 * (1 + 2 * pi * hertz)) << hertz << ' ' << zeta << ' ' << seconds;
            }
        }
    }
}

TEST(Spring, TakesOneStepOfASecondLikeSixHundred)
{
    // Published: techniques.md, section 4: 4 Hz, damping 0.15, from 1 at rest: 0.02115 after a second.
    const Spring spring{2 * pi * 4, 0.15};
    EXPECT_NEAR(advance({{1, 0, 0}, {}}, {}, spring, 1, closed).value.x, 0.02115, 5e-6);
    for (const int steps : {30, 60, 240, 600}) {
        const SpringState many = stepped(start, target, spring, 1, steps, closed);
        const SpringState one = advance(start, target, spring, 1, closed);
        EXPECT_LT(glm::length(many.value - one.value), 1e-12) << steps;
        EXPECT_LT(glm::length(many.rate - one.rate), 1e-10) << steps;
    }
    // The methods that the visitor may choose instead are not like that.
    EXPECT_GT(glm::length(stepped(start, target, spring, 1, 60, FurSpring::explicitEuler).value), 1);
    EXPECT_GT(std::abs(stepped({{1, 0, 0}, {}}, {}, spring, 1, 60, FurSpring::semiImplicit).value.x - 0.02115), 0.005);
}

TEST(Spring, ChangesSmoothlyThroughCriticalDamping)
{
    for (const double seconds : {0.01, 0.1, 0.5}) {
        SpringState last = advance(start, target, {14, 0.999}, seconds, closed);
        for (int i = 1; i <= 2000; ++i) {
            const SpringState next = advance(start, target, {14, 0.999 + 1e-6 * i}, seconds, closed);
            ASSERT_LT(glm::length(next.value - last.value), 1e-6) << i;
            last = next;
        }
    }
}

TEST(Spring, NeverGainsEnergyWhateverTheStep)
{
    for (const double hertz : {0.5, 10.0, 1000.0}) {
        for (const double zeta : {0.0, 0.3, 1.0, 5.0}) {
            const Spring spring{2 * pi * hertz, zeta};
            SpringState s = start;
            double before = energy(s, target, spring);
            for (const double seconds : {1.0 / 240, 1.0 / 60, 0.1, 10.0, 1e-4, 3600.0}) {
                s = advance(s, target, spring, seconds, closed);
                const double after = energy(s, target, spring);
                ASSERT_LE(after, before * (1 + 1e-9)) << hertz << ' ' << zeta << ' ' << seconds;
                before = after;
            }
        }
    }
    const Spring spring{2 * pi * 2, 0.05};
    EXPECT_GT(energy(stepped(start, target, spring, 2, 60, FurSpring::explicitEuler), target, spring), energy(start, target, spring));
}

TEST(Spring, SaysWhereTheSemiImplicitMethodBreaks)
{
    for (const Spring spring : {Spring{2 * pi * 5, 1}, Spring{2 * pi * 10, 1}, Spring{2 * pi * 3, 0.2}}) {
        const double limit = longestSemiImplicitStep(spring);
        const auto after = [&](double h) {
            SpringState s{{1, 0, 0}, {}};
            for (int i = 0; i < 400; ++i) s = advance(s, {}, spring, h, FurSpring::semiImplicit);
            return std::abs(s.value.x);
        };
        EXPECT_LT(after(0.98 * limit), 2);
        EXPECT_GT(after(1.02 * limit), 10);
    }
    // Published: 26 ms at 5 Hz and 13 ms at 10 Hz, both critically damped.
    EXPECT_NEAR(longestSemiImplicitStep({2 * pi * 5, 1}), 0.026, 0.0005);
    EXPECT_NEAR(longestSemiImplicitStep({2 * pi * 10, 1}), 0.013, 0.0003);
}

TEST(Spring, LeavesItsStateAloneWhenTheClockIsBroken)
{
    for (const double seconds : {0.0, -1.0, -1e-300, std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
        for (const FurSpring method : {closed, FurSpring::semiImplicit, FurSpring::explicitEuler}) EXPECT_EQ(advance(start, target, {14, 0.3}, seconds, method), start);
    const SpringState after = advance(start, target, {14, 0.3}, 5e-324, closed);
    EXPECT_EQ(after.value, start.value);
    EXPECT_LT(glm::length(after.rate - start.rate), 1e-300);
}

TEST(Spring, StaysFiniteWithoutStiffnessOrDampingAndWithFarTooMuch)
{
    const SpringState free = advance(start, target, {0, 0.3}, 2, closed);
    EXPECT_LT(glm::length(free.value - (start.value + 2.0 * start.rate)), 1e-12);
    for (const double omega : {0.0, 1e-9, 1.0, 6283.0})
        for (const double zeta : {0.0, 1e-12, 1.0, 100.0})
            for (const double seconds : {1e-6, 10.0, 3600.0}) {
                const SpringState s = advance(start, target, {omega, zeta}, seconds, closed);
                ASSERT_TRUE(std::isfinite(glm::length(s.value)) && std::isfinite(glm::length(s.rate))) << omega << ' ' << zeta << ' ' << seconds;
            }
}

TEST(Spring, CatchesUpAnHourInOneStep)
{
    const Spring spring{2 * pi * 2.2, 0.02};
    const SpringState one = advance(start, target, spring, 60, closed);
    const SpringState many = stepped(start, target, spring, 60, 60 * 240, closed);
    EXPECT_LT(glm::length(one.value - many.value), 1e-10);
    const SpringState hour = advance(start, target, spring, 3600, closed);
    EXPECT_LT(glm::length(hour.value - target), 1e-12);
}

TEST(Spring, KeepsItsLimit)
{
    SpringState s = start;
    for (int i = 0; i < 1000; ++i) {
        s.rate += glm::dvec3(40 * std::sin(i * 1.7), 30 * std::cos(i * 0.9), 25);
        s = limited(advance(s, target, {14, 0.1}, 1.0 / 60, closed), 1.5);
        ASSERT_LE(glm::length(s.value), 1.5 * (1 + 1e-12));
    }
    // A teleport by 1000 km, and numbers that have blown up.
    EXPECT_LE(glm::length(limited({{1e6, 0, 0}, {1e9, 0, 0}}, 2).value), 2 * (1 + 1e-12));
    EXPECT_EQ(limited({{std::nan(""), 0, 0}, {}}, 2), SpringState{});
    const SpringState atLimit = limited({{3, 0, 0}, {5, 1, 0}}, 2);
    EXPECT_EQ(atLimit.rate, glm::dvec3(0, 1, 0));  // Nothing leads further out, what leads along stays.
}

TEST(Rotation, IsTheSameForAQuaternionAndItsNegative)
{
    for (const double angle : {0.0, 1e-12, 1e-3, 1.0, 3.0, pi}) {
        const glm::dquat q = glm::angleAxis(angle, glm::normalize(glm::dvec3(1, -2, 0.5)));
        EXPECT_LT(glm::length(rotationVector(q) - rotationVector(-q)), angle == pi ? 1e-7 : 1e-12) << angle;
    }
    const glm::dquat half(0, 0, 1, 0);
    EXPECT_EQ(rotationVector(half), rotationVector(-half));
}

TEST(Rotation, GoesThereAndBackFromNothingToHalfATurn)
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.9, -0.4));
    for (const double angle : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14}) {
        const glm::dvec3 r = rotationVector(rotationOf(axis * angle));
        EXPECT_LT(glm::length(r - axis * angle), 1e-14 + 1e-12 * angle) << angle;
    }
    // Beyond half a turn the short way round is found.
    EXPECT_LT(glm::length(rotationVector(rotationOf(axis * 4.0)) - axis * (4.0 - 2 * pi)), 1e-12);
}

}  // namespace
}  // namespace vitrine
