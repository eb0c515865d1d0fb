#pragma once

#include "exhibits/exhibits.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::bench {

/// One exhibit and a renderer of its own, as the programs measure it. Sizes are in pixels.
struct BenchFrame {
    render::gl::HeadlessContext context{false};
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    SceneState sceneState = museum.initialSceneState();
    std::size_t exhibit;
    glm::ivec2 size;

    BenchFrame(std::string_view name, const glm::ivec2& pixels) : exhibit(*museum.find(std::string(name))), size(pixels)
    {
    }

    [[nodiscard]] ParameterValues& values() { return sceneState.values[exhibit]; }

    /// The exhibit alone from its best view, in linear light, with evaluations.
    [[nodiscard]] FrameRequest alone()
    {
        FrameRequest request;
        request.alone = exhibit;
        request.camera = museum.subject(exhibit).bestView(values());
        request.raster.size = size;
        request.averageIn = AverageIn::radiance;
        request.channels.evaluations = true;
        return request;
    }

    [[nodiscard]] render::FramePlan plan(const FrameRequest& request)
    {
        return test::planned(museum, sceneState, request, renderer.persistentState());
    }

    /// Draws it; the milliseconds of the passes whose names begin so, while steps are timed.
    double draw(const render::FramePlan& plan, std::string_view passes)
    {
        double sum = 0;
        for (const render::StepReport& step : renderer.draw(plan).ran)
            if (step.name.starts_with(passes)) sum += step.milliseconds;
        return sum;
    }

    /// Of so many pictures, the median of these passes' milliseconds; after `warmUp` others.
    [[nodiscard]] double medianMilliseconds(const FrameRequest& request, std::string_view passes, int runs, int warmUp)
    {
        renderer.timeSteps(true);
        std::vector<double> times;
        for (int run = -warmUp; run < runs; ++run) {
            const double milliseconds = draw(plan(request), passes);
            if (run >= 0) times.push_back(milliseconds);
        }
        renderer.timeSteps(false);
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    }

    /// Of the evaluations of the last picture, a pixel.
    [[nodiscard]] double meanEvaluations()
    {
        const render::Image counts = renderer.read(evaluationsImage);
        double sum = 0;
        for (const float count : counts.pixels) sum += static_cast<double>(count);
        return sum / (static_cast<double>(size.x) * size.y);
    }
};

}  // namespace vitrine::bench
