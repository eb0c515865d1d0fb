#pragma once

#include "render/files/strict_json.h"

#include <string>

namespace vitrine {

/// The version that a preset or exhibition file declares: "version", or 0 for the first files, which said
/// "schema": "vitrine" instead. Throws Failure for anything else and for versions newer than `presetVersion`.
[[nodiscard]] int declaredVersion(const render::JsonDocument&);

/// The file's JSON in the form of `presetVersion`: a chain of pure functions, one per version.
[[nodiscard]] render::Json migrated(const render::Json&, int fromVersion);

/// Where a key path of the migrated JSON stood in a file of that version: "params.morph" for
/// "values.morph" in version 0. Empty when it is the same.
[[nodiscard]] std::string originalPath(const std::string& path, int fromVersion);

}  // namespace vitrine
