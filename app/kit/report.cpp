#include "app/kit/report.h"

#include "app/kit/passes_json.h"
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

/// Draws the frames that a report needs besides the picture.
class ReportFrames {
public:
    ReportFrames(const Museum& museum, render::gl::Renderer& renderer, const SceneState& sceneState,
                 const FrameRequest& frame, const std::function<void()>& between)
        : museum_(museum), renderer_(renderer), sceneState_(sceneState), frame_(frame), between_(between),
          prepared_(museum.prepare(sceneState, frame))
    {
    }

    /// Returns the times of several frames in milliseconds, sorted.
    [[nodiscard]] std::vector<double> times() const
    {
        std::vector<double> milliseconds;
        for (int run = 0; run < timedRuns; ++run) milliseconds.push_back(draw(cachedPlan(frame_)).milliseconds);
        std::sort(milliseconds.begin(), milliseconds.end());
        return milliseconds;
    }

    /// Returns the milliseconds of each pass.
    [[nodiscard]] std::map<std::string, double> stepTimes() const
    {
        std::map<std::string, double> milliseconds;
        for (const render::StepReport& step : timed(cachedPlan(frame_)).ran)
            milliseconds[step.name] = step.milliseconds;
        return milliseconds;
    }

    /// Returns the costs of all passes, including those that the frame skips.
    [[nodiscard]] render::StepCosts allCosts() const
    {
        FrameRequest everything = frame_;
        everything.runEverything = true;
        const Prepared prepared = museum_.prepare(sceneState_, everything);
        (void)draw(museum_.plan(prepared, everything));  // Builds programs.
        render::StepCosts costs;
        costs.note(timed(museum_.plan(prepared, everything)));
        return costs;
    }

    /// Returns the number of evaluations of distance functions.
    [[nodiscard]] std::int64_t evaluations() const
    {
        FrameRequest counting = frame_;
        counting.channels.evaluations = true;
        (void)draw(cachedPlan(counting));
        return total(renderer_.read(evaluationsImage));
    }

private:
    /// Switches the clock of the passes on, until it is destroyed.
    struct StepClock {
        explicit StepClock(render::gl::Renderer& of) : renderer(of) { renderer.timeSteps(true); }
        ~StepClock() { renderer.timeSteps(false); }
        StepClock(const StepClock&) = delete;
        StepClock& operator=(const StepClock&) = delete;
        render::gl::Renderer& renderer;
    };

    /// Returns the plan of a frame that uses what earlier ones left.
    [[nodiscard]] render::FramePlan cachedPlan(const FrameRequest& frame) const
    {
        return museum_.plan(prepared_, frame, renderer_.persistentState());
    }
    render::FrameReport draw(const render::FramePlan& plan) const
    {
        between_();
        return renderer_.draw(plan);
    }
    render::FrameReport timed(const render::FramePlan& plan) const
    {
        const StepClock clock(renderer_);
        return draw(plan);
    }

    const Museum& museum_;
    render::gl::Renderer& renderer_;
    const SceneState& sceneState_;
    const FrameRequest& frame_;
    const std::function<void()>& between_;
    Prepared prepared_;
};

Json memoryJson(const render::gl::Renderer& renderer)
{
    const auto used = render::processMemory();
    Json memory{{"residentBytes", used.resident}, {"ownBytes", used.own}};
    for (const render::gl::Stored& kept : renderer.stored())
        memory[kept.what] = Json{{"count", kept.count}, {"bytes", kept.bytes}};
    return memory;
}

}  // namespace

Json pictureReport(const Museum& museum, render::gl::Renderer& renderer, const render::gl::ContextInfo& gl,
                   const RequestedPicture& job, const render::FrameReport& first, const std::function<void()>& between)
{
    const FrameRequest frame = frameOf(job, renderer);
    const ReportFrames frames(museum, renderer, job.sceneState, frame, between);
    const std::vector<double> milliseconds = frames.times();
    const std::map<std::string, double> stepMilliseconds = frames.stepTimes();
    const render::StepCosts wouldCost = frames.allCosts();

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
    counters["evaluations"] = frames.evaluations();

    return {
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
}

}  // namespace vitrine::app
