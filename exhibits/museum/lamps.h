#pragma once

#include "exhibits/framework/subject.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace vitrine {

/// The lamps of a frame, and what they shine on.
struct Lamps {
    std::span<const render::LocalLight> lights;  ///< World space.
    glm::dvec3 center{0};                        ///< What one looks at ...
    double radius = 0;                           ///< ... and how far around it surfaces may be seen, meters.
    std::uint64_t castersKey = 0;                ///< Another number whenever anything that throws a shadow changes.
    /// All surfaces for another view of the frame, unpruned, in the images that exhibits share.
    std::function<render::FramePlan(const render::View&)> seenFrom;
};

/// Adds the lamps that an exhibit carries, in world space; with `steadyOnly` none whose light changes by itself.
void takeLamps(const Subject& subject, const ExhibitState& state, const glm::dmat4& worldFromSubject, bool steadyOnly,
               std::vector<render::LocalLight>& lamps);

/// Whether any of them asks for shadows.
[[nodiscard]] bool throwShadows(std::span<const render::LocalLight>);

/// Plans the shadow maps, kept while nothing in them changes, and says which lamps surfaces reckon with; nothing where
/// no lamp shines. The plan says why what is left out is left out.
[[nodiscard]] std::optional<render::LocalLighting> planLamps(const Lamps&, render::FramePlan&);

}  // namespace vitrine
