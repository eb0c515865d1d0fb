#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine {

/// Returns a pass with the exhibit's values bound: `parameters.NAME` in its shaders. Everything else is empty.
[[nodiscard]] render::Pass exhibitPass(std::string name, std::string reason, const ParameterValues&, std::string vertex,
                                       std::string fragment);

/// Makes a pass draw surfaces into the picture: radiance and depth over what is there, depth-tested, with back faces
/// culled. Defines tell shaders to write further outputs. With `channels.normal` it is WRITE_NORMAL, the normal at
/// location 1. With `channels.evaluations` it is WRITE_EVALUATIONS, whose value is the location of the count, and with
/// `channels.albedo` likewise WRITE_ALBEDO (`writeAlbedo`).
void drawSurface(render::Pass&, const Channels&, render::Load = render::Load::keep);

/// Adds the image of base colors to a pass that has all its other color images. The define WRITE_ALBEDO is its location
/// in the shader, which writes (base color, 1), blended like the radiance.
void writeAlbedo(render::Pass&, render::Load = render::Load::keep);

/// Returns the depth-only variant for meshes whose positions determine their depth, so every fragment must be opaque.
/// Draws are `surfaceDraw`s, or contain their block alone.
[[nodiscard]] render::DepthOnly meshDepth();

/// Returns a pass of meshes with materials (`surfaceDraw`s) in this light, as by `drawSurface`. `defines` are
/// permutations of shaders/kit/surface.frag. Its depth-only variant is `meshDepth`; unset `depthOnly` if textures cut
/// holes.
[[nodiscard]] render::Pass surfacePass(std::string name, std::string reason, const SceneLighting&, const Channels&,
                                       std::vector<std::string> defines = {}, render::Load = render::Load::keep);

/// Reason for the passes that `Exhibit::planShadow` adds.
inline constexpr const char* shadowReason = "the sun reaches it and its shadow may be seen";

/// Makes a pass draw into the exhibits' shadow map, seen from the sun: nearest depth. It is kept until the shadow of
/// any exhibit changes, and skipped if no shadow can be visible. Culling and depth bias are unchanged.
void castShadow(render::Pass&, const PlanContext&);

/// Makes a pass draw what glass transmits of the sunlight: color, and in alpha the depth behind which it applies, in
/// units of the exhibits' shadow map. It is kept and skipped like that map.
void castGlassShadow(render::Pass&, const PlanContext&);

/// Returns the shadow pass of meshes with the shader of `meshDepth`.
[[nodiscard]] render::Pass meshShadow(std::string name, const PlanContext&);

}  // namespace vitrine
