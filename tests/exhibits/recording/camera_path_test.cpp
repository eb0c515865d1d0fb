// Camera paths with known results.

#include "exhibits/recording/camera_path.h"
#include "exhibits/recording/recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine::recording {
namespace {

using render::Camera;
constexpr double pi = std::numbers::pi;

Camera at(double x, double z, double lookX = 0, double lookZ = -1)
{
    return {{x, 1.65, z}, {x + lookX, 1.65, z + lookZ}, 0.9};
}

glm::dvec3 lookOf(const Camera& camera)
{
    return glm::normalize(camera.target - camera.eye);
}

TEST(CameraPath, BetweenTwoStopsIsStraight)
{
    const CameraPath path({at(0, 0), at(4, 0)}, false);
    EXPECT_NEAR(path.length(), 4, 1e-9);
    for (double share = 0; share <= 1; share += 0.125) {
        EXPECT_NEAR(path.at(share).eye.x, 4 * share, 1e-9);
        EXPECT_NEAR(path.at(share).eye.z, 0, 1e-12);
        EXPECT_NEAR(lookOf(path.at(share)).z, -1, 1e-12);
    }
}

TEST(CameraPath, MatchesThePublishedFormOfACentripetalSpline)
{
    // Tangent at an inner stop by differences over the knots (Yuksel, Schaefer and Keyser). Only positions differ, not
    // directions.
    const std::array<Camera, 4> stops = {at(0, 0), at(1, 0), at(1, 3), at(6, 3)};
    const CameraPath path({stops.begin(), stops.end()}, false);
    const auto knot = [&](int i) {
        return std::sqrt(
            glm::length(stops.at(static_cast<std::size_t>(i) + 1).eye - stops.at(static_cast<std::size_t>(i)).eye));
    };
    for (int i = 1; i <= 2; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double before = knot(i - 1), after = knot(i);
        const glm::dvec3 tangent = (stops.at(n).eye - stops.at(n - 1).eye) / before -
                                   (stops.at(n + 1).eye - stops.at(n - 1).eye) / (before + after) +
                                   (stops.at(n + 1).eye - stops.at(n).eye) / after;
        // Point at which the path passes that stop.
        double nearest = 1, share = 0;
        for (int k = 0; k <= 100000; ++k) {
            const double away = glm::length(path.at(k / 1e5).eye - stops.at(n).eye);
            if (away < nearest) share = k / 1e5;
            nearest = std::min(nearest, away);
        }
        EXPECT_LT(nearest, 1e-3);
        const glm::dvec3 way = path.at(share + 1e-3).eye - path.at(share - 1e-3).eye;
        EXPECT_GT(glm::dot(glm::normalize(way), glm::normalize(tangent)), 0.9999) << i;
    }
}

TEST(CameraPath, TurnsTheShorterWayAndNeverThroughItself)
{
    // From north-west over north to north-east, and from north-east back. Halfway, the camera looks north.
    const CameraPath over({at(0, 0, -0.2, -1), at(0, 0, 0.2, -1)}, false);
    EXPECT_LT(lookOf(over.at(0.5)).z, -0.99);
    const CameraPath round({at(0, 0, 0, -1), at(0, 0, 0.01, 1)}, false);
    for (double share = 0; share <= 1; share += 0.05)
        EXPECT_NEAR(glm::length(round.at(share).target - round.at(share).eye), 1, 0.01) << share;
    EXPECT_NEAR(std::abs(lookOf(round.at(0.5)).x), 1, 1e-3);
}

TEST(CameraPath, AClosedOneComesBackInTheDirectionInWhichItLeft)
{
    const CameraPath path({at(2, 0, 0, 1), at(0, 2, -1, 0), at(-2, 0, 0, -1), at(0, -2, 1, 0)}, true);
    EXPECT_EQ(path.at(0), path.at(1));
    const glm::dvec3 leaves = path.at(1e-4).eye - path.at(0).eye;
    const glm::dvec3 arrives = path.at(1).eye - path.at(1 - 1e-4).eye;
    EXPECT_GT(glm::dot(glm::normalize(leaves), glm::normalize(arrives)), 0.99999);
    // One orbit: the direction makes a whole turn and does not turn back.
    double turn = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 a = lookOf(path.at(i / 200.0)), b = lookOf(path.at((i + 1) / 200.0));
        turn += std::atan2(a.z * b.x - a.x * b.z, glm::dot(a, b));
    }
    EXPECT_NEAR(std::abs(turn), 2 * pi, 1e-6);
}

TEST(CameraPath, OneStopIsAStillAndRepeatedStopsCountOnce)
{
    EXPECT_EQ(CameraPath({at(1, 2)}, false).at(0.3), at(1, 2));
    EXPECT_EQ(CameraPath({at(1, 2)}, true).at(0.3), at(1, 2));
    EXPECT_EQ(CameraPath({at(1, 2), at(1, 2)}, false).length(), 0);
    const CameraPath twice({at(0, 0), at(1, 0), at(1, 0), at(2, 0)}, false);
    EXPECT_NEAR(twice.at(0.5).eye.x, 1, 1e-9);
    EXPECT_EQ(twice.stopBefore(0.1), 0U);
    EXPECT_EQ(twice.stopBefore(0.6), 1U);
}

TEST(Pace, EasedStartsAndEndsAtRest)
{
    EXPECT_EQ(paced(Pace::constant, 0.3), 0.3);
    EXPECT_EQ(paced(Pace::eased, 0), 0);
    EXPECT_EQ(paced(Pace::eased, 1), 1);
    EXPECT_EQ(paced(Pace::eased, 0.5), 0.5);
    EXPECT_LT(paced(Pace::eased, 0.001), 1e-5);
    EXPECT_GT(paced(Pace::eased, 0.999), 1 - 1e-5);
    EXPECT_EQ(paced(Pace::eased, 7), 1);
}

TEST(Turntable, KeepsTheDistanceAndTheHeight)
{
    const Camera start{{3, 2, 1}, {1, 1, 0}, 0.7};
    for (double angle = 0; angle < 7; angle += 0.3) {
        const Camera camera = turned(start, angle);
        EXPECT_NEAR(glm::length(camera.eye - camera.target), glm::length(start.eye - start.target), 1e-12);
        EXPECT_NEAR(camera.eye.y, 2, 1e-12);
        EXPECT_EQ(camera.target, start.target);
    }
    // Counter-clockwise seen from above: from +z to +x.
    const glm::dvec3 quarter = turned({{0, 0, 1}, {0, 0, 0}, 1}, pi / 2).eye;
    EXPECT_NEAR(quarter.x, 1, 1e-12);
}

TEST(Turntable, GoesRoundInALoopOrToAndFro)
{
    const Camera start{{0, 1, 2}, {0, 1, 0}, 0.7};
    EXPECT_TRUE(isWholeTurns(-4 * pi));
    EXPECT_FALSE(isWholeTurns(0));
    EXPECT_FALSE(isWholeTurns(pi / 3));
    EXPECT_EQ(turntable(start, 2 * pi, Pace::constant)(0), start);
    const CameraMotion swing = turntable(start, pi, Pace::eased);
    EXPECT_NEAR(glm::length(swing(0.5).eye - start.eye), 0, 1e-12);
    EXPECT_NEAR(swing(0).eye.x, -2, 1e-12);
    EXPECT_NEAR(swing(1).eye.x, 2, 1e-12);
}

RecordingRequest steady(double seconds, double framesPerSecond, bool closed)
{
    RecordingRequest request;
    request.seconds = seconds;
    request.framesPerSecond = framesPerSecond;
    request.closed = closed;
    request.picture.frame.time = 100;
    request.camera = [](double part) { return at(part, 0); };
    return request;
}

TEST(Moments, AreAtTheNumberOverTheRate)
{
    const RecordingRequest open = steady(2, 30, false);
    ASSERT_EQ(open.frames(), 60);
    EXPECT_EQ(motionSamplesOf(open, 45).front().time, 101.5);
    EXPECT_EQ(motionSamplesOf(open, 0).front().camera.eye.x, 0);
    EXPECT_EQ(motionSamplesOf(open, 59).front().camera.eye.x, 1) << "an open path ends with the last frame";
    const RecordingRequest loop = steady(2, 30, true);
    EXPECT_NEAR(motionSamplesOf(loop, 59).front().camera.eye.x, 59.0 / 60, 1e-12)
        << "the next one would be the first again";
    EXPECT_EQ(steady(0.001, 30, true).frames(), 1);
    EXPECT_EQ(motionSamplesOf(steady(0.001, 30, false), 0).front().camera.eye.x, 0);
}

TEST(Moments, LieEvenlyInTheExposure)
{
    RecordingRequest request = steady(2, 10, true);
    request.shutter = 0.5;
    request.shutterSamples = 4;
    const std::vector<MotionSample> moments = motionSamplesOf(request, 3);
    ASSERT_EQ(moments.size(), 4U);
    for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(moments[static_cast<std::size_t>(j)].time, 100.3 + 0.05 * (j + 0.5) / 4, 1e-9);
    request.shutter = 0;
    EXPECT_EQ(motionSamplesOf(request, 3).size(), 1U);
}

}  // namespace
}  // namespace vitrine::recording
