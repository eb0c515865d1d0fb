// A jump: the same however it is asked for, within its limits, and over when it is over.

#include "exhibits/fur/bounce.h"
#include "render/scene/rigid_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine {
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
        most = std::max(most, glm::length(a[i].pull - b[i].pull));
        most = std::max(most, glm::length(rotationVector(a[i].turn * glm::conjugate(b[i].turn))));
        most = std::max(most, glm::length(rotationVector(a[i].lag * glm::conjugate(b[i].lag))));
        most = std::max(most, std::abs(a[i].grown - b[i].grown));
    }
    return most;
}

bool same(const FurStates& a, const FurStates& b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].position != b[i].position || a[i].turn != b[i].turn || a[i].grown != b[i].grown || a[i].pull != b[i].pull || a[i].lag != b[i].lag) return false;
    return true;
}

TEST(Bounce, IsTheSameInWhateverOrderOneAsks)
{
    Bounce forwards(settings());
    Bounce backwards(settings());
    std::vector<FurStates> seen;
    for (int i = 0; i < 100; ++i) seen.push_back(forwards.at(0.05 * i));
    for (int i = 99; i >= 0; --i) EXPECT_TRUE(same(backwards.at(0.05 * i), seen[static_cast<std::size_t>(i)])) << i;
    // And another number is another throw.
    Bounce other(settings(3));
    EXPECT_GT(apart(other.at(0.5), forwards.at(0.5)), 0.01);
}

TEST(Bounce, H90_BeginsAndEndsWhereTheBodiesLie)
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
            ASSERT_LT(glm::length(rotationVector(next[i].turn * glm::conjugate(last[i].turn))), 0.04) << t;
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
        s.spring.omega = 80;  // Beyond what the other two methods survive.
        Bounce bounce(s);
        double most = 0;
        for (double t = 0; t < 3; t += 1.0 / 60) {
            for (const FurState& state : bounce.at(t)) {
                ASSERT_LE(glm::length(state.pull), 0.7 * (1 + 1e-9));
                ASSERT_LE(glm::length(rotationVector(state.lag)), 0.4 + 1e-9);
                most = std::max(most, glm::length(state.pull));
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
    values.set(table().flattening, 1.0);  // Nothing of the fur carries: skin on the ground.
    values.set(table().growing, true);
    values.set(table().growth, 0.08);
    const BounceSettings s = bounceSettings(table(), values, nullptr, 0.3);
    render::RigidBodies world({pitRadius, 4, 9.81});
    const int ball = world.add(render::BallShape{ballRadius}, {{0, 1, 0}}, 1);
    bool grew = false;
    for (double t = 0; t < 4; t += 0.05) {
        const double drawn = ballRadius * s.growth.grown(t);
        world.resizeBall(ball, drawn);
        EXPECT_NEAR(world.ballRadius(ball), drawn, 1e-7);
        EXPECT_NEAR(drawn, ballRadius + 0.08 * std::sin(2 * 3.14159265358979 * 0.7 * (0.3 + t)), 1e-9);
        EXPECT_NEAR(restStates(s, t)[furBall].position.y, drawn, 1e-9);
        grew = grew || drawn > ballRadius + 0.07;
    }
    EXPECT_TRUE(grew);
}

TEST(Bounce, RestsOnTheFloorWhateverTheFurCarries)
{
    ParameterValues values = table().initial();
    for (const double flattening : {0.0, 0.5, 1.0}) {
        values.set(table().flattening, flattening);
        const BounceSettings s = bounceSettings(table(), values, nullptr, 0);
        for (int i = 0; i < furBodyCount; ++i) {
            const double skin = i == furBall ? ballRadius : i == furRoll ? rollRadius : ringTube;
            const double length = values[coatRows(table(), i).length];
            EXPECT_NEAR(restStates(s)[static_cast<std::size_t>(i)].position.y, skin + (1 - flattening) * length, 1e-12);
        }
    }
}

TEST(Bodies, FallAsFastAsGalileoSays)
{
    render::RigidBodies world({10, 4, 9.81});
    const int ball = world.add(render::BallShape{0.1}, {{0, 3, 0}}, 1);
    for (int i = 0; i < 120; ++i) world.step(1.0 / 240);
    // Half a second: 1.226 m, less what the air's 5 % a second holds back and the step's first order adds.
    EXPECT_NEAR(3 - world.pose(ball).position.y, 1.226, 0.02);
}

}  // namespace
}  // namespace vitrine
