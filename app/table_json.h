#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"

#include <string_view>

namespace vitrine::app {

/// What `list --json` says of an exhibit or the hall: name, title, summary and every row of its table, and what it
/// offers to be compared with (`subject` may be null: nothing). Numbers are in SI, and a row's `unit` is the SI unit
/// that they are in.
[[nodiscard]] render::Json exhibitJson(std::string_view name, std::string_view title, std::string_view summary,
                                       const Parameters&, const Subject* subject);
/// That of every subject, with the rows that it has in this look.
[[nodiscard]] render::Json exhibitsJson(const Museum&, const SceneState&);

}  // namespace vitrine::app
