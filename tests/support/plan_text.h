#pragma once

#include "render/plan/frame_plan.h"

#include <string>

namespace vitrine::test {

/// Returns the complete content of a plan, one line for each pass, skipped pass and image. Meshes and pictures are
/// given by their bytes' hash.
[[nodiscard]] std::string wholeText(const render::FramePlan&);

}  // namespace vitrine::test
