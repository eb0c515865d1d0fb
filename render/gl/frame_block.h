#pragma once

#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// Mirrors the std140 block Frame of shaders/lib/frame.glsl.
struct FrameBlock {
    glm::mat4 viewFromWorld, clipFromView, clipFromWorld, worldFromView;
    glm::vec4 eye, size, sampling, shift, timing;
};

/// `time` is wrapped to a day here: nothing that moves slower than that is drawn from it.
[[nodiscard]] FrameBlock frameBlock(const View&, double time, int sample, std::uint32_t seed);

}  // namespace vitrine::render::gl
