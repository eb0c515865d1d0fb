// The walls are drawn in two steps on software renderers. In one step, they look the same but for rounding.
#include "render/gl/context.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <algorithm>

namespace vitrine {
namespace {

using test::gallery;
using DeferredWalls = test::GlTest;

/// Returns the plan without splitting a pass.
render::FramePlan inOneStep(const render::FramePlan& plan)
{
    render::FramePlan copy;
    copy.view = plan.view;
    copy.time = plan.time;
    copy.seed = plan.seed;
    copy.allSlices = plan.allSlices;
    for (const auto& [name, image] : plan.images()) copy.image(image);
    for (const auto& [name, buffer] : plan.buffers()) copy.buffer(buffer);
    for (render::Pass pass : plan.passes()) {
        pass.triangleSamples = nullptr;
        pass.localLights = nullptr;  // They are in its block.
        copy.add(std::move(pass));
    }
    return copy;
}

bool ran(const render::FrameReport& report, const char* pass)
{
    return std::any_of(report.ran.begin(), report.ran.end(),
                       [&](const render::StepReport& step) { return step.name == pass; });
}

TEST_F(DeferredWalls, LookAsInOneStep)
{
    const bool isSplit = render::gl::currentContextInfo().software;
    render::gl::Renderer& renderer = gallery().renderer;
    // From the entrance, and close to the wall beside the window, where the sun shines in.
    for (const render::Camera& camera : {render::Camera{{1.35, 1.65, 10.2}, {-0.35, 2.15, -4}, 0.96},
                                         render::Camera{{2, 1.65, -9}, {0.5, 2.5, -12}, 0.96}}) {
        SceneState state = gallery().museum.initialSceneState();
        FrameRequest request;
        request.camera = camera;
        request.raster.size = {160, 90};
        request.channels.normal = true;
        const render::FramePlan plan = test::planned(gallery().museum, state, request, renderer.persistentState());
        const render::FrameReport report = renderer.draw(plan);
        EXPECT_EQ(ran(report, "hall/walls/light"), isSplit);
        const render::Image deferred = renderer.read(radianceImage), normals = renderer.read(normalImage);
        EXPECT_FALSE(ran(renderer.draw(inOneStep(plan)), "hall/walls/light"));
        const render::Image once = renderer.read(radianceImage);
        EXPECT_EQ(test::largestDifference(renderer.read(normalImage), normals), 0);
        double most = 0;
        for (std::size_t i = 0; i < once.pixels.size(); ++i)
            most = std::max(most, std::abs(double(once.pixels[i]) - deferred.pixels[i]) /
                                      (1e-3 + std::abs(double(once.pixels[i]))));
        EXPECT_LT(most, 2e-3) << "a half float has 11 bits";
        EXPECT_GT(*std::max_element(once.pixels.begin(), once.pixels.end()), 0.1F) << "nothing is in this picture";
    }
}

TEST_F(DeferredWalls, AreLitInOneStepWhereNoSmallTriangleIsInView)
{
    SceneState state = gallery().museum.initialSceneState();
    const std::size_t sea = *gallery().museum.find("noise");
    FrameRequest request;
    request.camera = gallery().museum.bestView(sea, state.values[sea]);
    request.raster.size = {64, 36};
    const render::FramePlan plan =
        test::planned(gallery().museum, state, request, gallery().renderer.persistentState());
    ASSERT_NE(plan.find("hall/walls"), nullptr);
    EXPECT_FALSE(plan.withDeferredShading());
}

}  // namespace
}  // namespace vitrine
