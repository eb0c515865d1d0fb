// Temporal antialiasing: a picture in motion is averaged over its frames.
#include "exhibits/hall/hall_scene.h"
#include "render/glsl/std140.h"
#include "shaders/lib/bindings.glsl"

namespace vitrine::hall {

#include "shaders/hall/antialiasing_block.glsl"

namespace {

constexpr int samplesInTurn = 1024;  ///< Length of the sequence of sample positions, which then repeats.

bool isWhole(const FrameRequest& request)
{
    return request.raster.drawn() == request.raster.size;
}

render::Pass historyPass(std::string name, std::string fragment, std::string source, const AntialiasingBlock& block)
{
    render::Pass pass;
    pass.name = std::move(name);
    pass.phase = render::PassPhase::present;
    pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = std::move(fragment)};
    pass.inputs = {{UNIT_SOURCE, std::move(source)}};
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    pass.draws = {render::Draw{}};
    // Every pixel is written, so the previous content is not needed.
    pass.colors = {render::Attachment::cleared(frameHistoryImage)};
    return pass;
}

}  // namespace

bool isAveragedOverFrames(const FrameRequest& request, const FrameHistory& history)
{
    return request.movingFrame > 0 && history.frames > 1 && request.samples == 1 &&
           request.averageIn == AverageIn::display;
}

int antialiasingSample(const FrameRequest& request)
{
    return (request.movingFrame - 1) % samplesInTurn;
}

void planAntialiasing(const FrameRequest& request, const FrameHistory& history, render::FramePlan& plan)
{
    if (history.frames <= 1) return plan.skip("antialias", "frames are independent of each other");
    const bool moves = isAveragedOverFrames(request, history);
    const bool kept = !request.finished && isWhole(request) && request.averageIn == AverageIn::display;
    if (!moves && !kept) return plan.skip("antialias", "no motion follows this frame");
    plan.history({.image = {.name = frameHistoryImage, .format = render::Format::rgba16f},
                  .dependencies = {{"a value changed", history.look}},
                  .cutSeconds = std::numeric_limits<double>::infinity()});
    if (moves) {
        render::Pass pass =
            historyPass("antialias", "hall/antialiasing.frag", displayImage, {static_cast<float>(history.frames)});
        pass.reason = "the picture moves";
        pass.inputs.push_back({UNIT_EXHIBIT_A, render::previous(frameHistoryImage)});
        pass.inputs.push_back({UNIT_EXHIBIT_B, std::string(depthImage)});
        pass.colors.push_back(render::Attachment::cleared("frame"));
        return plan.add(std::move(pass));
    }
    plan.skip("antialias", "nothing moves");
    if (request.samples == 1 || request.sample + 1 < request.samples) return;
    const int frames = std::min(history.frames, request.samples);
    render::Pass pass = historyPass("antialias/begin", "hall/keep_history.frag", "frame", {static_cast<float>(frames)});
    pass.reason = "the next motion starts from the finished picture";
    plan.add(std::move(pass));
}

}  // namespace vitrine::hall
