// The jump of the fur balls: independent of the order of queries, within its limits, and finite.

#include "exhibits/framework/table/random_values.h"
#include "exhibits/fur/bounce.h"
#include "exhibits/fur/rigid_bodies.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace vitrine::fur {
namespace {

const FurTable& table()
{
    static const FurTable made;
    return made;
}

BounceSettings settings(int toss = 1)
{
    ParameterValues values = table().initial();
    values.set(table().toss, toss);
    return bounceSettings(table(), values, nullptr, 0);
}

double apart(const FurStates& a, const FurStates& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, glm::length(a[i].position - b[i].position));
        most = std::max(most, glm::length(a[i].tipOffset - b[i].tipOffset));
        most = std::max(most, glm::length(rotationVector(a[i].rotation * glm::conjugate(b[i].rotation))));
        most = std::max(most, glm::length(rotationVector(a[i].tipRotation * glm::conjugate(b[i].tipRotation))));
        most = std::max(most, std::abs(a[i].skinScale - b[i].skinScale));
    }
    return most;
}

bool same(const FurStates& a, const FurStates& b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].position != b[i].position || a[i].rotation != b[i].rotation || a[i].skinScale != b[i].skinScale ||
            a[i].tipOffset != b[i].tipOffset || a[i].tipRotation != b[i].tipRotation)
            return false;
    return true;
}

TEST(Bounce, IsTheSameInWhateverOrderOneAsks)
{
    Bounce forwards(settings());
    Bounce backwards(settings());
    std::vector<FurStates> seen;
    for (int i = 0; i < 100; ++i) seen.push_back(forwards.at(0.05 * i));
    for (int i = 99; i >= 0; --i) EXPECT_TRUE(same(backwards.at(0.05 * i), seen[static_cast<std::size_t>(i)])) << i;
    // Another seed gives another throw.
    Bounce other(settings(3));
    EXPECT_GT(apart(other.at(0.5), forwards.at(0.5)), 0.01);
}

TEST(RecordedJump, TakesEachStepOnceAndAnswersManyThreadsAlike)
{
    const RecordedJump jump(settings());
    Bounce alone(settings());
    std::vector<FurStates> truth;
    for (int i = 0; i < 60; ++i) truth.push_back(alone.at(0.02 * i));
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 60; ++i) {
                const int k = (i * (2 * t + 1)) % 60;
                wrong += !same(jump.at(0.02 * k).states, truth[static_cast<std::size_t>(k)]);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(jump.stepsTaken(), alone.steps());
    EXPECT_EQ(jump.at(0.5).steps, 120);
    EXPECT_EQ(jump.stepsTaken(), alone.steps()) << "what was simulated is not simulated again";
}

TEST(Bounce, BeginsAndEndsWhereTheBodiesLie)
{
    Bounce bounce(settings());
    EXPECT_LT(apart(bounce.at(0), restStates(settings())), 1e-12);
    EXPECT_LT(apart(bounce.at(1e-4), bounce.at(0)), 0.02);
    const double rested = bounce.restedAt(1e3);
    ASSERT_LE(rested, Bounce::longest + 0.1);
    EXPECT_GT(rested, 2);
    EXPECT_TRUE(same(bounce.at(rested), restStates(settings(), rested)));
    EXPECT_LT(apart(bounce.at(rested - 1e-6), restStates(settings(), rested)), 2e-3) << "it jumps when it falls asleep";
    const std::int64_t steps = bounce.steps();
    EXPECT_TRUE(same(bounce.at(3600), restStates(settings(), 3600)));
    EXPECT_EQ(bounce.steps(), steps) << "an hour asleep is no work";
}

TEST(Bounce, LeavesTheGroundAndStaysInThePit)
{
    Bounce bounce(settings());
    for (int i = 0; i < furBodyCount; ++i) {
        double highest = 0;
        for (double t = 0; t < 6; t += 0.01) {
            const FurState s = bounce.at(t)[static_cast<std::size_t>(i)];
            highest = std::max(highest, s.position.y);
            ASSERT_TRUE(std::isfinite(glm::length(s.position)));
            ASSERT_LT(std::hypot(s.position.x, s.position.z), pitRadius);
            ASSERT_GT(s.position.y, 0.1);
            ASSERT_LT(s.position.y, 1.7);
        }
        EXPECT_GT(highest, bounce.at(0)[static_cast<std::size_t>(i)].position.y + 0.25) << i;
    }
}

TEST(Bounce, MovesBetweenStepsWithoutJumps)
{
    Bounce bounce(settings());
    FurStates last = bounce.at(0.001);
    for (double t = 0.002; t < 5; t += 0.001) {
        const FurStates next = bounce.at(t);
        for (std::size_t i = 0; i < next.size(); ++i) {
            ASSERT_LT(glm::length(next[i].position - last[i].position), 0.012) << t;
            ASSERT_LT(glm::length(rotationVector(next[i].rotation * glm::conjugate(last[i].rotation))), 0.04) << t;
        }
        last = next;
    }
}

TEST(Bounce, KeepsFurWithinItsLimits)
{
    BounceSettings s = settings();
    s.inertia = 20;
    s.displacementLimit = 0.7;
    s.rotationLimit = 0.4;
    for (const FurSpring method : {FurSpring::closedForm, FurSpring::semiImplicit, FurSpring::explicitEuler}) {
        s.method = method;
        s.springRate = 30;
        s.spring.omega = 80;  // Beyond the stability of the other two methods.
        Bounce bounce(s);
        double most = 0;
        for (double t = 0; t < 3; t += 1.0 / 60) {
            for (const FurState& state : bounce.at(t)) {
                ASSERT_LE(glm::length(state.tipOffset), 0.7 * (1 + 1e-9));
                ASSERT_LE(glm::length(rotationVector(state.tipRotation)), 0.4 + 1e-9);
                most = std::max(most, glm::length(state.tipOffset));
            }
        }
        EXPECT_GT(most, 0.5);
    }
}

TEST(Bounce, IsTheSameAtThirtySixtyAndTwoHundredAndFortyFramesASecond)
{
    Bounce slow(settings()), usual(settings()), fast(settings());
    for (int i = 0; i <= 3 * 240; ++i) {
        const FurStates finest = fast.at(i / 240.0);
        if (i % 4 != 0) continue;
        const FurStates sixty = usual.at(i / 240.0);
        EXPECT_TRUE(same(sixty, finest)) << i;
        if (i % 8 == 0) {
            EXPECT_TRUE(same(slow.at(i / 240.0), finest)) << i;
        }
    }
}

TEST(Bounce, CollidesWithTheRadiusThatIsDrawn)
{
    ParameterValues values = table().initial();
    values.set(table().flattening, 1.0);  // Fur carries nothing: the skin touches the ground.
    values.set(table().growing, true);
    values.set(table().growth, 0.08);
    values.set(table().jump, 1.5);
    const BounceSettings s = bounceSettings(table(), values, nullptr, 0.3);
    Bounce bounce(s);
    bool grew = false, shrank = false;
    for (double t = 0; t < 4; t += 0.01) {
        const double drawn = ballRadius * s.growth.skinScale(t);
        EXPECT_NEAR(drawn, ballRadius + 0.08 * std::sin(2 * 3.14159265358979 * 0.7 * (0.3 + t)), 1e-9);
        EXPECT_NEAR(restStates(s, t)[furBall].position.y, drawn, 1e-9);
        const double under = bounce.at(t)[furBall].position.y - drawn;
        EXPECT_GT(under, -0.02) << "it sinks into the floor, " << t << " s after the press";
        grew = grew || (drawn > ballRadius + 0.07 && under < 0.02);
        shrank = shrank || (drawn < ballRadius - 0.07 && under < 0.02);
    }
    EXPECT_TRUE(grew && shrank) << "it was never seen to lie on the floor, large and small";
}

/// Returns the distance in meters from a body's center to its farthest tip.
double reachOf(int body, const ParameterValues& values, double skinScale)
{
    const double skin = body == furBall   ? ballRadius * skinScale
                        : body == furRoll ? rollHalfLength + rollRadius
                                          : ringRadius + ringTube;
    return skin + values[table().coats[static_cast<std::size_t>(body)].length];
}

TEST(LongBounce, NeverLeavesTheSpaceInWhichItIsLookedFor)
{
    for (int seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomNumbers random(static_cast<std::uint64_t>(seed));
        ParameterValues values = randomValues(table(), random, 0.7);
        values.set(table().byHand, false);
        values.set(table().jump, random.number(0, 8));
        const BounceSettings s = bounceSettings(table(), values, nullptr, 0);
        const render::Box rest = bouncingSpace(table(), values, false);
        const render::Box jump = bouncingSpace(table(), values, true);
        Bounce bounce(s);
        for (double t = 0; t < 4; t += 0.05) {
            const FurStates states = bounce.at(t);
            for (int i = 0; i < furBodyCount; ++i) {
                const FurState& state = states[static_cast<std::size_t>(i)];
                const double reach = reachOf(i, values, state.skinScale);
                const render::Box& space = t == 0 ? rest : jump;
                // Below the floor nothing is visible: fur there is pressed flat.
                ASSERT_LE(state.position.y + reach, space.high.y) << "body " << i << " at " << t << " s";
                for (const int axis : {0, 2}) {
                    ASSERT_GE(state.position[axis] - reach, space.low[axis]) << "body " << i << " at " << t << " s";
                    ASSERT_LE(state.position[axis] + reach, space.high[axis]) << "body " << i << " at " << t << " s";
                }
            }
        }
    }
}

TEST(Bounce, IsLookedForNoHigherThanAThrowOfItsStrengthGets)
{
    // A stone thrown up at v rises v^2 / 2 g; the strongest throw has 1.26 times the mean speed.
    ParameterValues values = table().initial();
    for (const double jump : {0.0, 3.0, 8.0}) {
        values.set(table().jump, jump);
        const double rises = jump * jump * 1.26 * 1.26 / (2 * 9.81);
        EXPECT_NEAR(bouncingSpace(table(), values, true).high.y - bouncingSpace(table(), values, false).high.y, rises,
                    0.02 * rises + 0.25)
            << jump;
    }
}

TEST(LongBounce, HopsBackOverTheRimAndIsNotDrawnHome)
{
    int left = 0, flying = 0, steered = 0;
    for (int toss = 1; toss <= 16; ++toss) {
        ParameterValues values = table().initial();
        values.set(table().jump, 5.0);
        values.set(table().toss, toss);
        const BounceSettings s = bounceSettings(table(), values, nullptr, 0);
        Bounce bounce(s);
        const double rested = bounce.restedAt(1e3);
        EXPECT_LT(rested, Bounce::longest - 1) << "it was put to rest where it lay";
        EXPECT_LT(bounce.slid(), 0.05) << toss;
        constexpr double frame = 1.0 / 60;
        for (double t = 2 * frame; t < rested; t += frame) {
            const FurStates a = bounce.at(t - 2 * frame), b = bounce.at(t - frame), c = bounce.at(t);
            for (std::size_t i = 0; i < a.size(); ++i) {
                left += std::hypot(c[i].position.x, c[i].position.z) > pitRadius + 0.2;
                // Above everything that it could touch, and far from the others.
                bool alone = b[i].position.y > 0.9 && t > 1.6;
                for (std::size_t k = 0; k < a.size(); ++k)
                    alone = alone && (k == i || glm::length(b[k].position - b[i].position) > 1.1);
                if (!alone) continue;
                ++flying;
                const glm::dvec3 acceleration = (c[i].position - 2.0 * b[i].position + a[i].position) / (frame * frame);
                steered += std::hypot(acceleration.x, acceleration.z) > 1 || std::abs(acceleration.y + 9.81) > 1;
            }
        }
    }
    EXPECT_GT(left, 20) << "no body left the pit: there is nothing to come back from";
    // Some are held a meter outside the pit. If a spring pulled them home, nearly all would be steered.
    EXPECT_GT(flying, 60);
    EXPECT_LT(steered, flying / 8) << "something pulls at bodies in the air";
}

TEST(Bounce, RestsOnTheFloorWhateverTheFurCarries)
{
    ParameterValues values = table().initial();
    for (const double flattening : {0.0, 0.5, 1.0}) {
        values.set(table().flattening, flattening);
        const BounceSettings s = bounceSettings(table(), values, nullptr, 0);
        for (int i = 0; i < furBodyCount; ++i) {
            const double skin = i == furBall ? ballRadius : i == furRoll ? rollRadius : ringTube;
            const double length = values[table().coats[static_cast<std::size_t>(i)].length];
            EXPECT_NEAR(restStates(s)[static_cast<std::size_t>(i)].position.y, skin + (1 - flattening) * length, 1e-12);
        }
    }
}

TEST(Bodies, FallAsFastAsGalileoSays)
{
    RigidBodies world({.radius = 10});
    const int ball = world.add(BallShape{0.1}, {{0, 3, 0}}, 1);
    for (int i = 0; i < 120; ++i) world.step(1.0 / 240);
    // Half a second: 1.226 m, minus the air's 5 % a second and the first-order error of the step.
    EXPECT_NEAR(3 - world.pose(ball).position.y, 1.226, 0.02);
}

TEST(Bodies, MeetThePaddedRimWhereItIsDrawnAndNothingAboveIt)
{
    // assets/models/hall_props.py: the top of the leather is 0.18 m above the ground, 0.14 m outside the pit's wall.
    const RigidPit pit{.radius = pitRadius, .depth = pitRim, .padRadius = pitPadRadius, .padLift = pitPadLift};
    RigidBodies world(pit);
    const int ball = world.add(BallShape{0.2}, {{pitRadius + 0.14, 1.2, 0}}, 1);
    double lowest = 2;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0 / 240);
        lowest = std::min(lowest, world.pose(ball).position.y);
    }
    EXPECT_NEAR(lowest, pitRim + 0.18 + 0.2, 0.02);
    // The wall holds a slow body. A high one flies over the rim and lands on the ground outside.
    RigidBodies other(pit);
    const int slow = other.add(BallShape{0.2}, {{0, 0.2, 0}}, 1);
    const int high = other.add(BallShape{0.2}, {{0, 1.5, 0.8}}, 1);
    other.accelerate(slow, {2, 0, 0}, {});
    other.accelerate(high, {0, 0, 5}, {});
    double reached = 0;
    double lowestOutside = 2;
    for (int i = 0; i < 240 * 4; ++i) {
        other.step(1.0 / 240);
        reached = std::max(reached, other.pose(slow).position.x);
        const glm::dvec3 at = other.pose(high).position;
        if (at.z > pitRadius + 0.6 && at.z < 6) lowestOutside = std::min(lowestOutside, at.y);
    }
    EXPECT_LT(reached, pitRadius - 0.15);
    EXPECT_GT(reached, pitRadius - 0.25);
    EXPECT_NEAR(lowestOutside, pitRim + 0.2, 0.03);
}

}  // namespace
}  // namespace vitrine::fur
