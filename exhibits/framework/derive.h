#pragma once

#include "exhibits/framework/parameters.h"
#include "render/hash.h"
#include "render/plan/frame_plan.h"

#include <initializer_list>
#include <string>
#include <vector>

// What a parameter table turns into. Each function reads the rows and nothing else, so a new row needs no
// change here.
namespace vitrine::derive {

/// The enumerators of a table's choices, as GLSL: `const int shadowMethod_area = 5;` for "area" of the row
/// "shadowMethod".
[[nodiscard]] std::string enumerators(const Parameters&);

/// The std140 block of a table, as GLSL, after its `enumerators`: shaders read `parameters.shellCount`. Real is float,
/// count and choice int, toggle bool, color and direction vec3; files have no field.
[[nodiscard]] std::string uniformBlock(const Parameters&);

/// The bytes of that block.
[[nodiscard]] render::Bytes uniformBytes(const ParameterValues&);

/// The table of an exhibit's page in the manual, in Markdown.
[[nodiscard]] std::string manualTable(const Parameters&);

/// Up to `points` values that span the comfortable range, ends and initial value included, spaced by the
/// row's scale; all choices of a choice. Empty for colors, directions and files.
[[nodiscard]] std::vector<double> sweep(const ParameterInfo&, int points);

/// Adds every value to the key of something that depends on them.
void addToKey(render::Hash&, const ParameterValues&);

/// These rows spelled out, by name and to the last bit: the key of what is made of them and of nothing else.
[[nodiscard]] std::string keyOf(const ParameterValues&, std::initializer_list<std::size_t> rows);

}  // namespace vitrine::derive
