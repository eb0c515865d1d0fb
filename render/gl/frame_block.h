#pragma once

#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// Mirrors the std140 block Frame of shaders/lib/frame.glsl.
struct FrameBlock {
    glm::mat4 viewFromWorld, clipFromView, clipFromWorld, worldFromView;
    glm::vec4 eye, size, sampling, shift, timing, clipPlane;
};

/// `time` is wrapped to a day here: nothing that moves slower than that is drawn from it.
[[nodiscard]] FrameBlock frameBlock(const View&, double time, int sample, std::uint32_t seed);

/// Mirrors the std140 block Temporal of shaders/lib/temporal.glsl.
struct TemporalBlock {
    glm::mat4 previousClipFromWorld{1};
    glm::vec4 state{0};
};

/// Of one part (0 on) of the pass; `valid`: what its past says, unless the renderer lost it.
[[nodiscard]] TemporalBlock temporalBlock(const Pass&, int part, bool valid);

}  // namespace vitrine::render::gl
