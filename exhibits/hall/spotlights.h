#pragma once

#include "exhibits/hall/hall_scene.h"
#include "render/plan/local_lights.h"

#include <vector>

namespace vitrine::hall {

/// Returns whether the place is a frame in, or on, one of the upright walls of the room: its origin is at the wall, and
/// its z axis points out of it.
[[nodiscard]] bool isInWall(const Place&, const render::Box& room);

/// Returns the spotlights of the hall, one for each exhibit with a place: above frames in the walls as picture lights,
/// elsewhere in the vault. Picture lights shine all day, unless the work lights the hall itself; the others shine with
/// the lamps of the vault.
[[nodiscard]] std::vector<render::LocalLight> spotlights(const HallModel&, const std::vector<ExhibitSlot>&,
                                                         const HallTable&, const ParameterValues&);

}  // namespace vitrine::hall
