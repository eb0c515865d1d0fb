#pragma once

#include "render/plan/frame_plan.h"

#include <string>

namespace vitrine::test {

/// Everything that a plan says, word for word and byte for byte, one line for each pass, skipped step and image. Meshes
/// and pictures are told by their content.
[[nodiscard]] std::string wholeText(const render::FramePlan&);

}  // namespace vitrine::test
