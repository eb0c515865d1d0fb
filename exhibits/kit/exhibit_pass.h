#pragma once

#include "exhibits/framework/exhibit.h"
#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine {

/// A pass with the exhibit's values bound: `parameters.NAME` in its shaders. Everything else is as in an empty pass.
[[nodiscard]] render::Pass exhibitPass(std::string name, std::string reason, const ParameterValues&, std::string vertex,
                                       std::string fragment);

/// Makes it a pass that draws surfaces of the picture: their radiance and depth over what is there, the nearest one
/// kept, back faces culled. Shaders write further outputs as the defines say: with `channels.normal`, WRITE_NORMAL and
/// the normal at location 1; with `channels.evaluations`, WRITE_EVALUATIONS with the location of the count.
void drawSurface(render::Pass&, const Channels&, render::Load = render::Load::keep);

/// The depth of meshes, for which their positions tell all: of passes whose every fragment hides what is behind. Their
/// draws are `surfaceDraw`s, or have their block alone.
[[nodiscard]] render::DepthOnly meshDepth();

/// A pass of meshes with materials, `surfaceDraw`s, in this light, as by `drawSurface`. `defines` are permutations of
/// shaders/kit/surface.frag. Its depth alone is `meshDepth`: one whose textures cut holes unsets `depthOnly`.
[[nodiscard]] render::Pass surfacePass(std::string name, std::string reason, const SceneLighting&, const Channels&,
                                       std::vector<std::string> defines = {}, render::Load = render::Load::keep);

/// Why a shadow that `Exhibit::planShadow` adds is there.
inline constexpr const char* shadowReason = "the sun reaches it and its shadow may be seen";

/// Makes it a pass that draws into the exhibits' shadow map as the sun sees them: nearest depth, kept until anything
/// about any exhibit's shadow changes, left out where no shadow can be seen. Culling and depth bias stay as they are.
void castShadow(render::Pass&, const PlanContext&);

/// Makes it a pass that draws what glass lets through of the sun: color, and in alpha the depth from which on it does,
/// as the exhibits' shadow map has it. Kept and left out as that is.
void castGlassShadow(render::Pass&, const PlanContext&);

/// The shadow of meshes, as `meshDepth`.
[[nodiscard]] render::Pass meshShadow(std::string name, const PlanContext&);

}  // namespace vitrine
