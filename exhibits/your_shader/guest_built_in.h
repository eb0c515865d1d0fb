#pragma once

#include "exhibits/your_shader/guest_work.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <string>

// Cube map and volumes that take the place of those of Shadertoy's site, which are not public.
namespace vitrine::guest {

/// Width and height of the faces of the built-in cube map, in pixels.
inline constexpr int environmentSide = 256;
/// Width, height and depth of the built-in volumes, in texels. They repeat.
inline constexpr int noiseSide = 32;

/// Returns whether a picture is a built-in cube map or volume.
[[nodiscard]] bool isBuiltIn(PassPicture::From);

/// Declares a built-in picture and plans the pass that fills it; once made, it is kept. Does nothing if it is planned
/// already. Returns its image.
std::string planBuiltIn(PassPicture::From, render::FramePlan&);

/// Returns the width and height of a built-in picture.
[[nodiscard]] glm::ivec2 sizeOfBuiltIn(PassPicture::From);

}  // namespace vitrine::guest
