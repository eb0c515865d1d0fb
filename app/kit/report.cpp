#include "app/kit/report.h"

#include "app/kit/passes_json.h"
#include "render/files/strict_json.h"
#include "render/measure/memory.h"
#include "render/plan/step_costs.h"
#include "render/version.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::app {
namespace {

using render::Json;

constexpr int timedRuns = 5;

/// Returns the request of the picture's frame with one sample, limited to the size of a tile.
FrameRequest frameOf(const RequestedPicture& job, const render::RenderBackend& backend)
{
    FrameRequest frame = job.request.frame;
    frame.raster.tile =
        glm::min(frame.raster.size, glm::ivec2(std::min(job.request.largestTile, backend.largestSide())));
    return frame;
}

/// Returns the sum of a counting channel; exact below 2^53.
std::int64_t total(const render::Image& counts)
{
    double sum = 0;
    for (const float count : counts.pixels) sum += count;
    return std::llround(sum);
}

/// Returns the times of several frames in milliseconds, sorted.
std::vector<double> timesOf(const Museum& museum, render::gl::Renderer& renderer, const Prepared& prepared,
                            const FrameRequest& frame)
{
    std::vector<double> milliseconds;
    for (int run = 0; run < timedRuns; ++run)
        milliseconds.push_back(renderer.draw(museum.plan(prepared, frame, renderer.persistentState())).milliseconds);
    std::sort(milliseconds.begin(), milliseconds.end());
    return milliseconds;
}

Json memoryJson(const render::gl::Renderer& renderer)
{
    const auto used = render::processMemory();
    Json memory{{"residentBytes", used.resident}, {"ownBytes", used.own}};
    for (const render::gl::Stored& kept : renderer.stored())
        memory[kept.what] = Json{{"count", kept.count}, {"bytes", kept.bytes}};
    return memory;
}

}  // namespace

std::string reportText(const Museum& museum, render::gl::Renderer& renderer, const render::gl::ContextInfo& gl,
                       const RequestedPicture& job, const PictureMaker& maker)
{
    const FrameRequest frame = frameOf(job, renderer);
    const Prepared prepared = museum.prepare(job.sceneState, frame);
    const std::vector<double> milliseconds = timesOf(museum, renderer, prepared, frame);

    renderer.timeSteps(true);
    std::map<std::string, double> stepMilliseconds;
    for (const render::StepReport& step : renderer.draw(museum.plan(prepared, frame, renderer.persistentState())).ran)
        stepMilliseconds[step.name] = step.milliseconds;
    renderer.timeSteps(false);

    // Runs the skipped passes, too: first to build programs and cached data, then to measure.
    FrameRequest everything = frame;
    everything.runEverything = true;
    const Prepared preparedAll = museum.prepare(job.sceneState, everything);
    (void)renderer.draw(museum.plan(preparedAll, everything));
    renderer.timeSteps(true);
    render::StepCosts wouldCost;
    wouldCost.note(renderer.draw(museum.plan(preparedAll, everything)));
    renderer.timeSteps(false);

    const render::FrameReport& first = maker.report();
    std::vector<render::StepReport> ran = first.ran;
    for (render::StepReport& step : ran) {
        const auto timed = stepMilliseconds.find(step.name);
        step.milliseconds = timed == stepMilliseconds.end() ? -1 : timed->second;
    }
    Json skipped = skippedJson(first.skipped);
    for (std::size_t i = 0; i < skipped.size(); ++i) {
        const double known = wouldCost.of(first.skipped[i].name);
        skipped[i]["wouldCostMs"] = known < 0 ? Json(nullptr) : Json(known);
    }

    Json counters = Json::object();
    for (const auto& [name, count] : first.counters) counters[name] = count;
    FrameRequest counting = frame;
    counting.channels.evaluations = true;
    (void)renderer.draw(museum.plan(prepared, counting, renderer.persistentState()));
    counters["evaluations"] = total(renderer.read(evaluationsImage));

    const Json report{
        {"app", render::programVersion()},
        {"exhibit", std::string(museum.subject(job.subject).name())},
        {"size", Json::array({frame.raster.size.x, frame.raster.size.y})},
        {"renderer", gl.renderer},
        {"clock",
         Json{{"method", first.clock}, {"trusted", first.clockTrusted}, {"overheadMs", first.overheadMilliseconds}}},
        {"ran", ranJson(ran)},
        {"skipped", skipped},
        {"counters", counters},
        {"memory", memoryJson(renderer)},
        {"ms", Json{{"median", milliseconds[timedRuns / 2]},
                    {"low", milliseconds.front()},
                    {"high", milliseconds.back()},
                    {"runs", timedRuns}}}};
    return render::writeJson(report);
}

}  // namespace vitrine::app
