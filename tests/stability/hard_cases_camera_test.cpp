// Depth and cameras at the ends of their ranges. Each test first shows the failure of the plain formula.

#include "exhibits/exhibits.h"
#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/museum/museum.h"
#include "render/scene/camera.h"
#include "tests/stability/fields.h"
#include "tests/support/planned.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using glm::dvec3;
using glm::dvec4;

float asHalf(double x)
{
    return glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(x)));
}

TEST(HardCases, NormalsFromHalfFloatDepthAreStairsAndNoDepthHereIsHalf)
{
    // A floor seen at 20 degrees, 3 to 12 m away: slope of its depth between neighboring lines of a picture with 720,
    // from the original depth and from a half-precision copy.
    const double tilt = glm::radians(20.0);
    std::vector<double> half, full;
    for (int line = 0; line < 400; ++line) {
        const auto at = [&](int y, auto store) {
            const double down = std::tan(glm::radians(10 + 40.0 * y / 720));
            const double z = 1.6 / (std::sin(tilt) + down * std::cos(tilt));
            return dvec3(0, -down, -1) * (0.02 / static_cast<double>(store(0.02 / z)));
        };
        const auto off = [&](auto store) {
            const auto exact = [](double d) { return d; };
            const dvec3 measured = glm::normalize(at(line + 1, store) - at(line, store));
            const dvec3 truth = glm::normalize(at(line + 1, exact) - at(line, exact));
            return glm::degrees(std::acos(std::clamp(std::abs(glm::dot(measured, truth)), 0.0, 1.0)));
        };
        half.push_back(off([](double d) { return asHalf(d); }));
        full.push_back(off([](double d) { return static_cast<float>(d); }));
    }
    std::sort(half.begin(), half.end());
    std::sort(full.begin(), full.end());
    EXPECT_GT(half[half.size() / 2], 1);
    EXPECT_LT(full[full.size() * 99 / 100], 0.2);

    // All images that any plan attaches as depth, or that exhibits share as depth.
    const Museum museum{allExhibits()};
    const SceneState sceneState = museum.initialSceneState();
    int depths = 0;
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        FrameRequest request;
        request.camera = museum.bestView(i, sceneState.values[i]);
        request.runEverything = true;
        const render::FramePlan plan = test::planned(museum, sceneState, request);
        for (const render::Pass& pass : plan.passes()) {
            if (!pass.depth) continue;
            ++depths;
            EXPECT_EQ(plan.images().at(pass.depth->image).format, render::Format::depth32f) << pass.name;
        }
    }
    EXPECT_GT(depths, 3);
}

TEST(HardCases, OrthographicDepthIsLinearAndTheSunsMapIsReadThatWay)
{
    const render::Box box{{-2, 0, -1}, {2, 3, 1}};
    const dvec3 towardsLight = glm::normalize(dvec3(0.3, 0.5, 0.8));
    const render::View sun = lightView(box, towardsLight, {512, 512}, 30);
    // Depth of the beginning and end of the box, and between them, from the matrices.
    const auto depthAt = [&](const dvec3& world) {
        const dvec4 clip = sun.clipFromWorld * dvec4(world, 1);
        EXPECT_DOUBLE_EQ(clip.w, 1);
        return clip.z / clip.w;
    };
    const dvec3 start = box.center();
    const double near = depthAt(start);
    const double far = depthAt(start - towardsLight * 10.0);
    EXPECT_GT(near, far);
    double worst = 0;
    double naiveWorst = 0;
    for (int i = 1; i < 10; ++i) {
        const double stored = static_cast<double>(static_cast<float>(depthAt(start - towardsLight * double(i))));
        worst = std::max(worst, std::abs((near - stored) / (near - far) * 10 - i));
        // A perspective reconstruction assumes distance proportional to 1 / depth.
        naiveWorst = std::max(naiveWorst, std::abs((1 / stored - 1 / near) / (1 / far - 1 / near) * 10 - i));
    }
    EXPECT_LT(worst, 1e-4);
    EXPECT_GT(naiveWorst, 0.1);
}

TEST(HardCases, AMillionTurnsLeaveTheViewOrthonormal)
{
    constexpr int turns = 1'000'000;
    const auto skew = [](const auto& r) {
        double worst = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                worst = std::max(worst, std::abs(static_cast<double>(glm::dot(r[i], r[j])) - (i == j ? 1 : 0)));
        return worst;
    };
    // The rotation multiplied up frame by frame.
    const glm::mat3 step(glm::rotate(glm::mat4(1), 1e-3F, glm::normalize(glm::vec3(1, 2, 3))));
    glm::mat3 naive(1);
    for (int i = 0; i < turns; ++i) naive = step * naive;
    EXPECT_GT(skew(naive), 1e-3);

    // The same drift in the view direction: the view is built from the direction, so it stays orthogonal.
    const render::View view = render::makeView({.eye = {1, 2, 3}, .target = dvec3(1, 2, 3) - dvec3(naive[2])}, {});
    EXPECT_LT(skew(glm::dmat3(view.viewFromWorld)), 1e-12);
}

}  // namespace
}  // namespace vitrine
