#pragma once

#include "exhibits/framework/exhibit.h"
#include "render/plan/render_backend.h"

#include <string>

namespace vitrine {

/// What every image of a frame holds before anybody draws into it.
struct Poison {
    glm::vec4 color;
    float depth = 0;
};

/// NaN, and a depth that no surface has: whoever reads a texel that nobody wrote spreads it.
[[nodiscard]] Poison spreadingPoison();

/// The plan, with passes before it that fill every image which is not kept from frame to frame.
[[nodiscard]] render::FramePlan poisoned(const render::FramePlan&, const Poison&);

/// Empty, or what is wrong with the images of a frame of the museum that was just drawn: NaN or infinity (of a texel
/// that nobody wrote, too), negative light, a depth outside [0, 1], a normal that is neither 0 nor of unit length.
/// Looked at are the picture, its channels, and what was drawn for later frames.
[[nodiscard]] std::string faultOfImages(const render::FramePlan&, render::RenderBackend&, const Channels&);

}  // namespace vitrine
