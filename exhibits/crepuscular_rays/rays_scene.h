#pragma once

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "exhibits/framework/scene/exhibit.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::crepuscular_rays {

#include "shaders/crepuscular_rays/rays_block.glsl"

/// State that the passes of one frame share.
struct RaysScene {
    const CrepuscularRaysTable& table;
    const PlanContext& context;
    const ParameterValues& values;
    render::View wholeView;  ///< View of the whole picture in pixels of the mask, also while a tile is drawn.
    bool tile = false;       ///< The frame is one tile of a larger picture.
    SunInPicture sun;
    std::vector<Beam> beams;
    render::Box air;  ///< Part of the air that holds dust, world space.
    glm::ivec2 maskSize{0};
    glm::ivec2 coarseSize{0};  ///< Size of the images before they are upsampled to the picture.
    RaysBlock block;

    [[nodiscard]] bool uses(RayTechnique technique) const
    {
        return (block.technique & static_cast<int>(technique)) != 0;
    }
    /// Returns 0 if nothing is drawn behind the dust (transparent background, studio), where the box of the air would
    /// be seen.
    [[nodiscard]] render::Factor endOfAir() const;
    /// Returns 0 if no sunbeam enters the air.
    [[nodiscard]] render::Factor anyBeam() const;
    [[nodiscard]] render::Factor sunAhead() const
    {
        return render::required(sun.inFront, "the sun is not in front of the camera");
    }
    /// Returns a pass over a whole image, with the parameters and the block bound.
    [[nodiscard]] render::Pass pass(const char* name, std::string reason, std::string fragment) const;
};

[[nodiscard]] RaysScene raysScene(const CrepuscularRaysTable&, const PlanContext&, const render::FramePlan&);

/// Returns a bound on the light that screen-space rays add. Also in a tile they come from the sky of the whole picture.
[[nodiscard]] render::ContributionBound screenRaysBound(const RaysScene&);
/// Returns a bound on what dust absorbs, and on what it scatters of the hall's light, in this view.
[[nodiscard]] render::ContributionBound hazeBound(const RaysScene&, const render::View&);
/// Returns a bound on the light that dust scatters from the sun's beams, in this view.
[[nodiscard]] render::ContributionBound beamBound(const RaysScene&, const render::View&);

// The following functions are defined in screen_rays.cpp.

/// Plans the mask: the bright sky of the whole picture. Returns its image.
[[nodiscard]] render::ResourceId planMask(const RaysScene&, render::FramePlan&);
/// Plans the integration of the mask: its mean along the rays, or the running sum on the polar grid.
[[nodiscard]] render::ResourceId planGathering(RaysScene&, const render::ResourceId& mask, render::FramePlan&);
/// Returns the method in use. A tile cannot read its neighbors' passes, so it uses the loop in place of three passes.
/// The plain sum, and a path too short for a running sum, use the loop, too.
[[nodiscard]] RayMethod methodOf(const RaysScene&);

// The following function is defined in air_beams.cpp.

/// Plans the light scattered from the sun's beams. Returns its image.
[[nodiscard]] render::ResourceId planMarch(const RaysScene&, render::FramePlan&);

}  // namespace vitrine::crepuscular_rays
