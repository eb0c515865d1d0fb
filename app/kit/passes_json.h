#pragma once

#include "render/files/strict_json.h"
#include "render/plan/render_backend.h"

#include <vector>

namespace vitrine::app {

/// Returns the passes that ran: name, kind, reason, bound (null: none), effects. "ms" is null if it was not measured.
[[nodiscard]] render::Json ranJson(const std::vector<render::StepReport>&);
/// Returns the passes of a plan that has not run, as `ranJson` without times.
[[nodiscard]] render::Json plannedJson(const std::vector<render::Pass>&);
/// Returns the skipped passes with their reasons.
[[nodiscard]] render::Json skippedJson(const std::vector<render::CulledPass>&);

}  // namespace vitrine::app
