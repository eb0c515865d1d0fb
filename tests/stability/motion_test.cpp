// Stability cases of motion: clocks that stop, jump and run backwards, springs and rotations at singularities of their
// formulas, and coming to rest. Each test compares the plain formula with the one in use.

#include "exhibits/fur/rigid_bodies.h"
#include "exhibits/fur/spring.h"
#include "exhibits/fur/strand_cpu.h"
#include "exhibits/fur/strand_cpu32.h"
#include "tests/stability/flush_to_zero.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine {
namespace {

using fur::advance;
using fur::BallShape;
using fur::energy;
using fur::FurSpring;
using fur::limited;
using fur::RigidBodies;
using fur::RingShape;
using fur::RollShape;
using fur::rotationVector;
using fur::Spring;
using fur::SpringState;
using glm::dvec3;

using std::numbers::pi;
constexpr FurSpring closed = FurSpring::closedForm;

SpringState stepped(SpringState s, const glm::dvec3& target, const Spring& spring, double seconds, int steps,
                    FurSpring method)
{
    for (int i = 0; i < steps; ++i) s = advance(s, target, spring, seconds / steps, method);
    return s;
}

const SpringState start{{0.7, -0.2, 0.1}, {3, 1, -8}};
const glm::dvec3 target(0.1, -0.3, 0);

TEST(Spring, LeavesItsStateAloneWhenTheClockIsBroken)
{
    // Speed as distance by time is 0/0 in a paused frame, and NaN from then on.
    const auto speed = [](double way, double seconds) { return way / seconds; };
    EXPECT_TRUE(std::isnan(speed(0, 0)));
    EXPECT_TRUE(std::isinf(speed(1e-3, 5e-324)));
    // A clock that runs backwards adds energy to a damped spring. A time that is NaN stays in the state.
    const Spring spring{14, 0.3};
    const auto naive = [&](SpringState s, double h) {
        s.rate -= (spring.omega * spring.omega * s.value + 2 * spring.zeta * spring.omega * s.rate) * h;
        s.value += s.rate * h;
        return s;
    };
    SpringState backwards{{1, 0, 0}, {}};
    for (int i = 0; i < 60; ++i) backwards = naive(backwards, -1.0 / 60);
    EXPECT_GT(energy(backwards, {}, spring), 10 * energy({{1, 0, 0}, {}}, {}, spring));
    EXPECT_TRUE(std::isnan(naive(naive(start, std::nan("")), 1.0 / 60).value.x));

    for (const double seconds : {0.0, -1.0, -1.0 / 60, -1e-300, std::nan(""), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()})
        for (const FurSpring method : {closed, FurSpring::semiImplicit, FurSpring::explicitEuler})
            EXPECT_EQ(advance(start, target, spring, seconds, method), start) << seconds;
    // Denormal times, both kept and flushed to zero.
    const auto expectStill = [&] {
        const SpringState after = advance(start, target, spring, 5e-324, closed);
        EXPECT_EQ(after.value, start.value);
        EXPECT_LT(glm::length(after.rate - start.rate), 1e-300);
    };
    expectStill();
    const test::FlushToZero asOnTheGpu;
    expectStill();
}

TEST(Spring, BreaksInTheSemiImplicitMethodWhereTheoryPutsIt)
{
    const auto longestSemiImplicitStep = [](const Spring& spring) {
        return 2 * (std::sqrt(1 + spring.zeta * spring.zeta) - spring.zeta) / spring.omega;
    };
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
    // Published values: 26 ms at 5 Hz and 13 ms at 10 Hz, both critically damped.
    EXPECT_NEAR(longestSemiImplicitStep({2 * pi * 5, 1}), 0.026, 0.0005);
    EXPECT_NEAR(longestSemiImplicitStep({2 * pi * 10, 1}), 0.013, 0.0003);
    // A pause of ten seconds in a debugger: the semi-implicit method diverges, the closed form comes to rest.
    const Spring spring{2 * pi * 10, 1};
    EXPECT_GT(glm::length(advance(start, target, spring, 10, FurSpring::semiImplicit).value), 1e5);
    EXPECT_LT(glm::length(advance(start, target, spring, 10, closed).value - target), 1e-9);
}

TEST(Spring, TakesOneStepOfASecondLikeSixHundred)
{
    // Closed form: 4 Hz, damping 0.15, from 1 at rest: 0.02115 after a second.
    const Spring spring{2 * pi * 4, 0.15};
    EXPECT_NEAR(advance({{1, 0, 0}, {}}, {}, spring, 1, closed).value.x, 0.02115, 5e-6);
    for (const int steps : {30, 60, 240, 600}) {
        const SpringState many = stepped(start, target, spring, 1, steps, closed);
        const SpringState one = advance(start, target, spring, 1, closed);
        EXPECT_LT(glm::length(many.value - one.value), 1e-12) << steps;
        EXPECT_LT(glm::length(many.rate - one.rate), 1e-10) << steps;
    }
    // The other methods that the visitor can choose depend on the step.
    EXPECT_GT(glm::length(stepped(start, target, spring, 1, 60, FurSpring::explicitEuler).value), 1);
    EXPECT_GT(std::abs(stepped({{1, 0, 0}, {}}, {}, spring, 1, 60, FurSpring::semiImplicit).value.x - 0.02115), 0.005);
}

TEST(Spring, ChangesSmoothlyThroughCriticalDamping)
{
    // The plain factor of the sine is 0/0 at critical damping, and the root of a negative number slightly beyond.
    const auto naive = [](double zeta, double omega, double t) {
        const double w = omega * std::sqrt(1 - zeta * zeta);
        return std::exp(-zeta * omega * t) * std::sin(w * t) / w;
    };
    EXPECT_TRUE(std::isnan(naive(1, 14, 0.1)));
    EXPECT_TRUE(std::isnan(naive(1 + 1e-9, 14, 0.1)));
    for (const double zeta : {1 - 1e-9, 1.0, 1 + 1e-9}) {
        const SpringState s = advance(start, target, {14, zeta}, 0.1, closed);
        const SpringState critical = advance(start, target, {14, 1}, 0.1, closed);
        EXPECT_LT(glm::length(s.value - critical.value), 1e-7) << zeta;
    }
    for (const double seconds : {0.01, 0.1, 0.5}) {
        SpringState last = advance(start, target, {14, 0.999}, seconds, closed);
        for (int i = 1; i <= 2000; ++i) {
            const SpringState next = advance(start, target, {14, 0.999 + 1e-6 * i}, seconds, closed);
            ASSERT_LT(glm::length(next.value - last.value), 1e-6) << i;
            last = next;
        }
    }
}

TEST(Spring, StaysFiniteWithoutStiffnessOrDampingAndWithFarTooMuch)
{
    // The damping ratio without stiffness or mass: c / (2 sqrt(k m)), also without damping.
    const auto ratio = [](double c, double k, double m) { return c / (2 * std::sqrt(k * m)); };
    EXPECT_TRUE(std::isnan(ratio(0, 0, 1)));
    EXPECT_TRUE(std::isinf(ratio(1, 4, 0)));
    const SpringState free = advance(start, target, {0, 0.3}, 2, closed);
    EXPECT_LT(glm::length(free.value - (start.value + 2.0 * start.rate)), 1e-12);
    for (const double omega : {0.0, 1e-9, 1.0, 6283.0})
        for (const double zeta : {0.0, 1e-12, 1.0, 100.0})
            for (const double seconds : {1e-6, 10.0, 3600.0}) {
                const SpringState s = advance(start, target, {omega, zeta}, seconds, closed);
                ASSERT_TRUE(std::isfinite(glm::length(s.value)) && std::isfinite(glm::length(s.rate)))
                    << omega << ' ' << zeta << ' ' << seconds;
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
    EXPECT_GT(energy(stepped(start, target, spring, 2, 60, FurSpring::explicitEuler), target, spring),
              energy(start, target, spring));
}

TEST(Spring, KeepsItsLimit)
{
    SpringState s = start;
    for (int i = 0; i < 1000; ++i) {
        s.rate += glm::dvec3(40 * std::sin(i * 1.7), 30 * std::cos(i * 0.9), 25);
        s = limited(advance(s, target, {14, 0.1}, 1.0 / 60, closed), 1.5);
        ASSERT_LE(glm::length(s.value), 1.5 * (1 + 1e-12));
    }
    // A teleport by 1000 km, and diverged numbers.
    EXPECT_LE(glm::length(limited({{1e6, 0, 0}, {1e9, 0, 0}}, 2).value), 2 * (1 + 1e-12));
    EXPECT_EQ(limited({{std::nan(""), 0, 0}, {}}, 2), SpringState{});
    const SpringState atLimit = limited({{3, 0, 0}, {5, 1, 0}}, 2);
    // The outward part of the speed is removed, the tangential one stays.
    EXPECT_EQ(atLimit.rate, glm::dvec3(0, 1, 0));
}

TEST(Spring, CatchesUpAnHourInOneStep)
{
    const Spring spring{2 * pi * 2.2, 0.0002};  // Still oscillating after an hour.
    constexpr int missed = 3600 * 60;
    const SpringState hour = advance(start, target, spring, 3600, closed);
    const SpringState many = stepped(start, target, spring, 3600, missed, closed);
    EXPECT_LT(glm::length(hour.value - many.value), 1e-9);
    EXPECT_GT(glm::length(hour.rate), 1e-9);
    // The other methods need all steps. In one step, they diverge.
    EXPECT_GT(glm::length(advance(start, target, spring, 3600, FurSpring::semiImplicit).value), 1e6);
    EXPECT_GT(glm::length(advance(start, target, spring, 3600, FurSpring::explicitEuler).rate), 1e5);
}

TEST(Rotation, IsTheSameForAQuaternionAndItsNegative)
{
    // The textbook conversion to axis and angle takes the long way for one of q and -q.
    const auto naive = [](const glm::dquat& q) { return 2 * std::acos(q.w); };
    const glm::dquat small = glm::angleAxis(0.1, glm::dvec3(0, 1, 0));
    EXPECT_NEAR(naive(small), 0.1, 1e-9);
    EXPECT_GT(naive(-small), 6);
    EXPECT_NEAR(glm::length(rotationVector(-small)), 0.1, 1e-12);
    for (const double angle : {0.0, 1e-12, 1e-3, 1.0, 3.0, pi}) {
        const glm::dquat q = glm::angleAxis(angle, glm::normalize(glm::dvec3(1, -2, 0.5)));
        EXPECT_LT(glm::length(rotationVector(q) - rotationVector(-q)), angle == pi ? 1e-7 : 1e-12) << angle;
    }
    const glm::dquat half(0, 0, 1, 0);
    EXPECT_EQ(rotationVector(half), rotationVector(-half));
}

/// Returns evenly distributed points on a sphere: Fibonacci spiral (Gonzalez 2010).
dvec3 onSphere(int i, int n)
{
    const double y = 1 - 2 * (i + 0.5) / n;
    const double phi = 2 * pi * std::fmod(i * 0.6180339887498949, 1.0);
    const double r = std::sqrt(1 - y * y);
    return {r * std::cos(phi), y, r * std::sin(phi)};
}

double lengthOf(const dvec3& root, const dvec3& tip, double curvature, int model)
{
    double length = 0;
    dvec3 last(0);
    for (int i = 1; i <= 400; ++i) {
        const dvec3 next = glsl::strandPoint(root, tip, i / 400.0, curvature, model);
        length += glm::length(next - last);
        last = next;
    }
    return length;
}

TEST(Bending, KeepsTheLengthWithinOnePercentAtEveryAngle)
{
    const dvec3 root(0, 1, 0);
    for (int degrees = 0; degrees <= 180; degrees += 5) {
        const double a = degrees * pi / 180;
        const dvec3 tip(std::sin(a), std::cos(a), 0);
        for (const double curvature : {0.0, 0.5, 0.8, 1.0, 2.0, 5.0})
            EXPECT_NEAR(lengthOf(root, tip, curvature, glsl::STRAND_SLERP), 1, 0.01) << degrees << ' ' << curvature;
    }
    // The linear mix of the reference shortens a strand's middle by 13 % at 60 degrees and by half at 120 (the chord).
    const auto shortest = [&](double a) {
        return glm::length(
            glsl::strandDirection(root, dvec3(std::sin(a), std::cos(a), 0), 0.5, glsl::STRAND_MATRIX_MIX));
    };
    EXPECT_NEAR(shortest(pi / 3), 0.866, 1e-3);
    EXPECT_NEAR(shortest(2 * pi / 3), 0.5, 1e-12);
    EXPECT_NEAR(shortest(pi), 0, 1e-12);
}

TEST(Bending, IsDefinedAtNothingAndAtHalfATurn)
{
    // The plain spherical interpolation divides by a sine of zero for nearly equal directions.
    const auto naive = [](float cosine, float k) {
        return std::sin(k * std::acos(cosine)) / std::sin(std::acos(cosine));
    };
    EXPECT_TRUE(std::isnan(naive(1, 0.5F)));
    EXPECT_TRUE(std::isnan(naive(std::cos(1e-4F), 0.5F)));  // Its cosine is rounded to 1.
    for (int i = 0; i < 200; ++i) {
        const dvec3 n = onSphere(i, 200);
        for (const double k : {0.0, 0.25, 0.5, 1.0}) {
            for (const int model : {glsl::STRAND_NLERP, glsl::STRAND_SLERP}) {
                EXPECT_NEAR(glm::length(glsl::strandDirection(n, n, k, model)), 1, 1e-12);
                EXPECT_NEAR(glm::length(glsl::strandDirection(n, -n, k, model)), 1, 1e-9);
            }
        }
        EXPECT_LT(glm::length(glsl::strandDirection(n, -n, 1, glsl::STRAND_SLERP) + n), 1e-9);
    }
    // Angles for which a float arc cosine gives 0.
    for (const double a : {1e-12, 1e-9, 1e-6, 1e-3}) {
        const dvec3 root(0, 1, 0);
        const dvec3 d = glsl::strandDirection(root, dvec3(std::sin(a), std::cos(a), 0), 0.5, glsl::STRAND_SLERP);
        EXPECT_NEAR(d.x, std::sin(a / 2), 1e-9 * a + 1e-16) << a;
        const glm::vec3 d32 = glsl32::strandDirection(glm::vec3(root), glm::vec3(dvec3(std::sin(a), std::cos(a), 0)),
                                                      0.5F, glsl32::STRAND_SLERP);
        EXPECT_NEAR(d32.x, a / 2, 1e-6 * a) << a;
    }
}

TEST(Bodies, ComeToRestOnTheFloorAndSleepUntilTheyAreDisturbed)
{
    RigidBodies world({.radius = 1.6});
    const int ball = world.add(BallShape{0.3}, {{0, 0.5, 0}}, 1);
    const int roll = world.add(RollShape{0.2, 0.2}, {{0.8, 0.4, 0}}, 1);
    const int ring = world.add(RingShape{0.35, 0.15}, {{-0.8, 0.4, 0}}, 1);
    // Waiting for exact rest would take minutes, because a spring's motion decays without an end.
    EXPECT_NE(stepped({{1, 0, 0}, {}}, {}, {14, 0.3}, 60, 3600, closed).value, dvec3(0));
    for (int i = 0; i < 240 * 15 && !(world.asleep(ball) && world.asleep(roll) && world.asleep(ring)); ++i)
        world.step(1.0 / 240);
    EXPECT_TRUE(world.asleep(ball));
    EXPECT_TRUE(world.asleep(roll));
    EXPECT_TRUE(world.asleep(ring));
    EXPECT_NEAR(world.pose(ball).position.y, 0.3, 0.01);
    EXPECT_NEAR(world.pose(roll).position.y, 0.2, 0.01);
    EXPECT_NEAR(world.pose(ring).position.y, 0.15, 0.01);
    const glm::dvec3 before = world.pose(ball).position;
    for (int i = 0; i < 240; ++i) world.step(1.0 / 240);
    EXPECT_EQ(world.pose(ball).position, before);
    world.accelerate(ball, {0, 2, 0}, {});
    world.step(1.0 / 240);
    EXPECT_FALSE(world.asleep(ball));
    EXPECT_GT(world.pose(ball).position.y, before.y);
}

}  // namespace
}  // namespace vitrine
