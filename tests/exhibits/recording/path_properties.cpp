// Properties of all camera paths.

#include "exhibits/recording/camera_path.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>  // After gtest, which it needs.

#include <cmath>

namespace {

using namespace vitrine;
using recording::CameraPath;
using render::Camera;

double numberIn(int low, int high)
{
    return *rc::gen::inRange(1000 * low, 1000 * high) / 1000.0;
}

std::vector<Camera> anyStops()
{
    std::vector<Camera> stops;
    const int count = *rc::gen::inRange(2, 7);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 eye(numberIn(-6, 6), numberIn(1, 3), numberIn(-12, 12));
        const glm::dvec3 look(numberIn(-3, 3), numberIn(-2, 2), numberIn(-3, 3));
        stops.push_back({eye, eye + (glm::length(look) > 0.1 ? look : glm::dvec3(0, 0, 1)), numberIn(0, 1) + 0.3});
    }
    return stops;
}

/// Returns the distance that the path's length assigns to two nearby cameras.
double step(const Camera& a, const Camera& b)
{
    const auto bearing = [](const Camera& c) { return std::atan2(c.target.x - c.eye.x, -(c.target.z - c.eye.z)); };
    const auto height = [](const Camera& c) { return std::asin(glm::normalize(c.target - c.eye).y); };
    const double turn = std::remainder(bearing(a) - bearing(b), 2 * 3.14159265358979);
    const double reach = std::log(glm::length(a.target - a.eye) / glm::length(b.target - b.eye));
    return std::sqrt(std::pow(glm::length(a.eye - b.eye), 2) + std::pow(1.5 * turn, 2) +
                     std::pow(1.5 * (height(a) - height(b)), 2) + std::pow(1.5 * (a.fovY - b.fovY), 2) +
                     std::pow(0.01 * reach, 2));
}

RC_GTEST_PROP(CameraPathProperties, ItEndsWhereItShould, ())
{
    const std::vector<Camera> stops = anyStops();
    const CameraPath path(stops, false);
    RC_ASSERT(path.at(0) == stops.front());
    RC_ASSERT(path.at(1) == stops.back());
    // There are no jumps at its ends.
    RC_ASSERT(step(path.at(1e-7), stops.front()) < 1e-4);
    RC_ASSERT(step(path.at(1 - 1e-7), stops.back()) < 1e-4);
}

RC_GTEST_PROP(CameraPathProperties, ItPassesEveryStop, ())
{
    const std::vector<Camera> stops = anyStops();
    const CameraPath path(stops, *rc::gen::arbitrary<bool>());
    for (const Camera& stop : stops) {
        double nearest = 1e9;
        for (int i = 0; i <= 4000; ++i) nearest = std::min(nearest, step(path.at(i / 4000.0), stop));
        RC_ASSERT(nearest <= path.length() / 4000);
    }
}

RC_GTEST_PROP(CameraPathProperties, ItsSpeedIsConstant, ())
{
    const CameraPath path(anyStops(), *rc::gen::arbitrary<bool>());
    RC_PRE(path.length() > 0.1);
    constexpr int count = 3000, finer = 200;
    for (int i = 0; i < count; ++i) {
        const auto at = [&](double part) { return path.at((i + part) / count); };
        double length = step(at(0), at(1));
        // A chord is shorter than the arc if the path bends within it.
        if (length * count < 0.99 * path.length()) {
            length = 0;
            for (int k = 0; k < finer; ++k) length += step(at(k / double{finer}), at((k + 1) / double{finer}));
        }
        length *= count / path.length();
        RC_ASSERT(length < 1.02);
        RC_ASSERT(length > 0.98);
    }
}

RC_GTEST_PROP(CameraPathProperties, ItNeverRollsNorTurnsOver, ())
{
    const CameraPath path(anyStops(), *rc::gen::arbitrary<bool>());
    for (int i = 0; i <= 500; ++i) {
        const glm::dmat4 view = render::makeView(path.at(i / 500.0), {}).viewFromWorld;
        RC_ASSERT(std::abs(view[1][0]) < 1e-9);  // The horizontal axis of the picture is level.
        RC_ASSERT(view[1][1] > 0);               // The vertical axis points up.
    }
}

}  // namespace
