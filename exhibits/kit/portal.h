#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace vitrine {

#include "shaders/kit/portal/portal_block.glsl"

/// Opening with a view into a separate world, and its position in that world. The defaults are for the deep frames in
/// the hall's side walls, places 5 to 9. Their origin is the center of the frame's mouth, +z into the room. The opening
/// is 5 mm in front of the back of the recess, so the frame's inner sides are visible in front of it.
struct Portal {
    glm::dvec2 halfSize{1.2, 0.8};  ///< Meters.
    double behind = 0.495;          ///< Distance behind the mouth, meters.
    glm::dmat4 workFromExhibit{1};  ///< Rotation, translation and uniform scale, to meters of the world beyond.
    int side = 0;                   ///< Side of a divider that is drawn: right (1) or left (-1); 0: both.
    double divider = 0;  ///< Position of the vertical divider, meters to the right of the center of the opening.
};

/// Returns the flat bounds of the opening in exhibit space.
[[nodiscard]] render::Box portalBounds(const Portal&);
/// Share of the picture's height that an opening takes in its best view. In a picture of 16:9, an opening of 3:2 then
/// takes three quarters of the area, and the rest shows a little of the frame.
inline constexpr double openingInView = 0.945;

/// Returns a camera straight in front of a rectangle, from which it takes `openingInView` of the picture's height;
/// field of view 50°. `behind`: distance of the rectangle behind the frame's mouth; both in meters.
[[nodiscard]] render::Camera closeView(double halfHeight, double behind);
[[nodiscard]] render::Camera portalView(const Portal&);

/// Returns the columns of a tile in which one side of a divided picture may be visible, as in `Pass::columns`. The
/// range is empty if there are none; unset means all columns.
[[nodiscard]] std::optional<glm::ivec2> portalColumns(const Portal&, const glm::dmat4& worldFromExhibit,
                                                      const render::View&);
/// Returns a pass that draws what is visible through the opening: radiance without light of the hall, the depth of the
/// opening, normals and evaluations. `fragment` is a shader with kit/portal/portal.glsl and kit/portal/main.glsl.
///
/// The pass binds its parameters and the hall's light block, whose sun it may follow, but no maps. If the exhibit is
/// shown alone, the world beyond fills the picture, with its own depths.
[[nodiscard]] render::Pass portalPass(std::string name, std::string reason, const ParameterValues&,
                                      std::string fragment, const Portal&, const PlanContext&);

}  // namespace vitrine
