#pragma once

#include "exhibits/framework/exhibit.h"
#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace vitrine {

#include "shaders/kit/portal/portal_block.glsl"

/// An opening through which one looks into a world of its own, and where in that world it is. By default that of the
/// deep frames in the hall's side walls, places 5 to 9, whose origin is the middle of the frame's mouth, +z into the
/// room: 5 mm before the back of the recess, so that the frame's inner sides are seen before it.
struct Portal {
    glm::dvec2 halfSize{1.2, 0.8};  ///< Meters.
    double behind = 0.495;          ///< How far behind the mouth, meters.
    glm::dmat4 workFromExhibit{1};  ///< A rotation, a shift and one scale: meters of the world beyond.
    int side = 0;                   ///< Drawn is what is seen to the right (1) or left (-1) of a divider; 0: all.
    double divider = 0;             ///< An upright line of the opening, so far right of its middle, meters.
};

/// Flat, in the exhibit's space.
[[nodiscard]] render::Box portalBounds(const Portal&);
/// From straight before it, so that the frame around it is in the picture; field of view 50°.
[[nodiscard]] render::Camera portalView(const Portal&);

/// Of a picture that is divided: the columns of its tile in which one side may be seen, as `Pass::columns` counts them;
/// from one to the same where none is. Unset: all.
[[nodiscard]] std::optional<glm::ivec2> portalColumns(const Portal&, const glm::dmat4& worldFromExhibit,
                                                      const render::View&);
/// A pass that draws what is seen through the opening: radiance that no light of the hall has touched, the depth of the
/// opening, normals and evaluations. `fragment` is a shader with kit/portal/portal.glsl and kit/portal/main.glsl; the
/// pass binds its parameters and the hall's light block, whose sun it may follow, and no map. Where the exhibit stands
/// alone, what is beyond fills the picture, with depths of its own.
[[nodiscard]] render::Pass portalPass(std::string name, std::string reason, const ParameterValues&,
                                      std::string fragment, const Portal&, const PlanContext&);

}  // namespace vitrine
