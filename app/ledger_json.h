#pragma once

#include "render/files/strict_json.h"
#include "render/plan/render_backend.h"

#include <vector>

namespace vitrine::app {

/// Each step that ran: name, kind, reason, bound (null where nothing is promised), effects; "ms" is null where it was
/// not measured.
[[nodiscard]] render::Json ranJson(const std::vector<render::StepReport>&);
/// Each pass of a plan that has not run, as `ranJson` without times.
[[nodiscard]] render::Json plannedJson(const std::vector<render::Pass>&);
/// Each that is left out, and why.
[[nodiscard]] render::Json skippedJson(const std::vector<render::CulledPass>&);

}  // namespace vitrine::app
