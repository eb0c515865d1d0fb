#pragma once

#include "render/files/strict_json.h"

#include <cstddef>
#include <string>

namespace vitrine::render {

/// Checks that the members which are read have the types that the JSON schema of glTF 2.0 gives them, and that those it
/// requires are there. Animations, skins, cameras, extensions and extras are not looked at: they are not read.
/// Throws Failure naming file, line and key, and what the schema wants there.
void checkGltfSchema(const JsonDocument&);

/// Turns every number that is whole into an integer: "4.0" and "4" are the same number in JSON, and the schema's
/// integers may be written as either.
void makeWholeNumbersIntegers(Json&);

/// The array of that name; an empty one where there is none.
[[nodiscard]] const Json& arrayAt(const JsonDocument&, const char* key);

/// The path of an element or, with a `key`, of one of its members: "accessors[3].count".
[[nodiscard]] std::string elementPath(const char* array, std::size_t i, const char* key);

}  // namespace vitrine::render
