#pragma once

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "exhibits/framework/exhibit.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine {

#include "shaders/crepuscular_rays/rays_block.glsl"

/// Everything that the passes of one frame share.
struct RaysScene {
    const CrepuscularRaysTable& table;
    const PlanContext& context;
    const ParameterValues& values;
    render::View wholeView;  ///< Of the whole picture, also while a tile of it is drawn; in pixels of the mask.
    bool tile = false;       ///< The frame is one tile of a larger picture.
    SunInPicture sun;
    std::vector<Beam> beams;
    render::Box air;  ///< That holds dust, world space.
    glm::ivec2 maskSize{0};
    glm::ivec2 coarseSize{0};  ///< Of the images before they are brought up.
    RaysBlock block;

    [[nodiscard]] bool uses(RayTechnique technique) const
    {
        return (block.technique & static_cast<int>(technique)) != 0;
    }
    /// 0 where something lacks behind the dust, whose box would be seen: on a transparent background, in the studio.
    [[nodiscard]] render::Factor endOfAir() const;
    /// 0 where the sun sends no beam into the air.
    [[nodiscard]] render::Factor anyBeam() const;
    [[nodiscard]] render::Factor sunAhead() const
    {
        return render::required(sun.inFront, "the sun is not in front of the camera");
    }
    /// A pass over the whole of an image, with the parameters and the block bound.
    [[nodiscard]] render::Pass pass(const char* name, std::string reason, std::string fragment) const;
};

[[nodiscard]] RaysScene raysScene(const CrepuscularRaysTable&, const PlanContext&, const render::FramePlan&);

/// What rays in screen space add: in a tile, too, they come from the sky of the whole picture.
[[nodiscard]] render::ContributionBound screenRaysBound(const RaysScene&);
/// What the dust in the hall's air takes away, and adds of the hall's light, in this view.
[[nodiscard]] render::ContributionBound hazeBound(const RaysScene&, const render::View&);
/// What it scatters of the sun's beams, in this view.
[[nodiscard]] render::ContributionBound beamBound(const RaysScene&, const render::View&);

// screen_rays.cpp

/// What shines, in the whole picture.
[[nodiscard]] render::ResourceId planMask(const RaysScene&, render::FramePlan&);
/// What is gathered of the mask: its mean along the rays, or the running sum on the polar grid.
[[nodiscard]] render::ResourceId planGathering(RaysScene&, const render::ResourceId& mask, render::FramePlan&);
/// The method in use: tiles cannot look into each other's passes, the plain sum is a loop, and so is a way that is
/// too short for a running sum.
[[nodiscard]] RayMethod methodOf(const RaysScene&);

// air_beams.cpp

/// The light scattered in the sun's beams.
[[nodiscard]] render::ResourceId planMarch(const RaysScene&, render::FramePlan&);

}  // namespace vitrine
