#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "render/plan/render_backend.h"

#include <string>

namespace vitrine::stability {

/// Content of every image of a frame before it is drawn.
struct Poison {
    glm::vec4 color;
    float depth = 0;
};

/// Returns NaN, and a depth that no surface has. A shader that reads an unwritten texel spreads it.
[[nodiscard]] Poison spreadingPoison();

/// Returns the plan with additional passes first, which fill every image that is not kept from frame to frame.
[[nodiscard]] render::FramePlan poisoned(const render::FramePlan&, const Poison&);

/// Returns a fault in the images of a frame of the museum that was just drawn; empty if there is none. Faults are NaN
/// or infinity (also of an unwritten texel), negative light, a depth outside [0, 1], and a normal that is neither 0 nor
/// of unit length. The picture, its channels and images for later frames are examined.
[[nodiscard]] std::string faultOfImages(const render::FramePlan&, render::RenderBackend&, const Channels&);

}  // namespace vitrine::stability
