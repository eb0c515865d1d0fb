#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"

#include <string_view>

namespace vitrine::app {

/// Returns the entry of an exhibit or the hall in `list --json`: name, title, summary, all parameters, and the
/// comparisons that `subject` offers (null: none). Numbers are in SI units, and a parameter's `unit` names that unit.
[[nodiscard]] render::Json exhibitJson(std::string_view name, std::string_view title, std::string_view summary,
                                       const Parameters&, const SceneObject* subject);
/// Returns the entries of all subjects, with their parameters in this scene state.
[[nodiscard]] render::Json exhibitsJson(const Museum&, const SceneState&);

}  // namespace vitrine::app
