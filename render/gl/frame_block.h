#pragma once

#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

#include "shaders/lib/frame_block.glsl"
#include "shaders/lib/temporal_block.glsl"

/// Fills the FRAME block. `time` (seconds) is wrapped to one day, so that it keeps its precision as a float.
[[nodiscard]] FrameBlock frameBlock(const View&, double time, int sample, std::uint32_t seed);

/// Fills the block for one slice of the pass, `part` from 0. `valid` is false if the pass's history is lost.
[[nodiscard]] TemporalBlock temporalBlock(const Pass&, int part, bool valid);

}  // namespace vitrine::render::gl
