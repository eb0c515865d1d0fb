#pragma once

#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

#include "shaders/lib/frame_block.glsl"
#include "shaders/lib/temporal_block.glsl"

/// `time` is wrapped to a day here: nothing that moves slower than that is drawn from it.
[[nodiscard]] FrameBlock frameBlock(const View&, double time, int sample, std::uint32_t seed);

/// Of one part (0 on) of the pass; `valid`: what its past says, unless the renderer lost it.
[[nodiscard]] TemporalBlock temporalBlock(const Pass&, int part, bool valid);

}  // namespace vitrine::render::gl
