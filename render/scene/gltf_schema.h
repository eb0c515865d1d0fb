#pragma once

#include "render/files/strict_json.h"

#include <cstddef>
#include <string>

namespace vitrine::render {

/// Checks the members that are read: each has the type that the JSON schema of glTF 2.0 requires, and no required one
/// is missing. Animations, skins, cameras, extras and most extensions are not checked here; gltf_animation.cpp checks
/// what it reads itself. Throws Failure naming file, line and key, and what the schema requires there.
void checkGltfSchema(const JsonDocument&);

/// Converts every whole number to an integer: "4.0" and "4" are the same number in JSON, and the schema's integers may
/// be written either way.
void makeWholeNumbersIntegers(Json&);

/// Returns the array of that name; an empty one if it is missing.
[[nodiscard]] const Json& arrayAt(const JsonDocument&, const char* key);

/// Returns the path of an element or, with a `key`, of one of its members: "accessors[3].count".
[[nodiscard]] std::string elementPath(const char* array, std::size_t i, const char* key);

}  // namespace vitrine::render
