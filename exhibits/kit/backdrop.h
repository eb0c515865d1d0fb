#pragma once

#include "exhibits/framework/scene_lighting.h"
#include "render/plan/frame_plan.h"

#include <string>

namespace vitrine {

/// Draws the pass after everything opaque and lets it see through what it draws: shaders/kit/backdrop.glsl, as the
/// define BACKDROP says, finds where a ray meets what the picture shows. A copy of radiance and depth is made once a
/// frame, before the first pass that asks. `blurred`: rough glass needs its smaller levels too.
void seeThrough(render::Pass&, render::FramePlan&, bool blurred);

/// The depth image at which the air in the picture ends: that of what is behind the glass, where the plan has glass.
/// Meaningful once all that is seen through is planned.
[[nodiscard]] std::string depthBehindGlass(const render::FramePlan&);

}  // namespace vitrine
