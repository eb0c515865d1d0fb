#pragma once

#include "exhibits/framework/scene/scene_lighting.h"
#include "render/plan/frame_plan.h"

#include <string>

namespace vitrine {

/// Makes a pass run after everything opaque and read what is behind its surfaces: with the define BACKDROP,
/// shaders/kit/backdrop.glsl finds where a ray meets the picture. Radiance and depth are copied once a frame, before
/// the first such pass. `blurred` adds smaller mip levels for rough glass.
void seeThrough(render::Pass&, render::FramePlan&, bool blurred);

/// Makes a pass that draws a mirror at y = 0 run after everything opaque, with the define MIRROR_PICTURE: it reflects
/// what that picture shows, found in screen space by shaders/kit/mirrored.frag, sharp and blurred.
void mirrorPicture(render::Pass&, render::FramePlan&);

/// Returns the depth image at which the air in the picture ends: the depth behind the glass, if the plan contains
/// glass. Valid once all passes that call `seeThrough` are planned.
[[nodiscard]] std::string depthBehindGlass(const render::FramePlan&);

}  // namespace vitrine
