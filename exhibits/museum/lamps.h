#pragma once

#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/scene/scene_object.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace vitrine {

/// Local lights of a frame, and the scene that they light.
struct Lamps {
    std::span<const render::LocalLight> lights;  ///< World space.
    glm::dvec3 center{0};                        ///< The point that the camera looks at ...
    double radius = 0;             ///< ... and the radius around it in which surfaces may be visible, meters.
    std::uint64_t castersKey = 0;  ///< Hash of everything that casts a shadow.
    /// Returns the plan of all surfaces for another view of the frame, not pruned, in the images that exhibits share.
    std::function<render::FramePlan(const render::View&)> planOfView;
};

/// Appends the lamps of an exhibit, in world space. With `steadyOnly`, skips lamps whose light changes by itself.
void takeLamps(const SceneObject& subject, const ExhibitState& state, const glm::dmat4& worldFromSubject,
               bool steadyOnly, std::vector<render::LocalLight>& lamps);

/// Returns whether any of the lights casts shadows.
[[nodiscard]] bool throwShadows(std::span<const render::LocalLight>);

/// Plans the shadow maps, which are kept while nothing in them changes, and selects the lamps that light surfaces.
/// Returns nothing if no lamp shines. The plan lists the reasons for passes that are left out.
[[nodiscard]] std::optional<render::LocalLighting> planLamps(const Lamps&, render::FramePlan&);

}  // namespace vitrine
