#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"

namespace vitrine::ice_cream {

#include "shaders/ice_cream/backdrop_block.glsl"

/// Returns the bounds of the backdrop in exhibit space: a sheet over the back of the niche that sweeps forward onto its
/// floor. Empty if the values switch it off.
[[nodiscard]] render::Box backdropBox(const IceCreamTable&, const ParameterValues&);

/// Adds the pass "ice_cream/backdrop", or the reason for skipping it. `foot` is the center of the plinth's base in
/// exhibit space, `footRadius` its radius; both in meters.
void planBackdrop(const IceCreamTable&, const PlanContext&, const glm::dvec3& foot, double footRadius,
                  render::FramePlan&);

}  // namespace vitrine::ice_cream
