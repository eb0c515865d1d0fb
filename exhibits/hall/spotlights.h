#pragma once

#include "exhibits/hall/hall_scene.h"
#include "render/plan/local_lights.h"

#include <vector>

namespace vitrine {

/// Returns the spotlights of the hall, one for each exhibit with a place: above frames in the walls as picture lights,
/// elsewhere in the vault. Picture lights shine all day, unless the work lights the hall itself; the others shine with
/// the lamps of the vault.
[[nodiscard]] std::vector<render::LocalLight> spotlights(const HallModel&, const std::vector<ExhibitSlot>&,
                                                         const HallTable&, const ParameterValues&);

}  // namespace vitrine
