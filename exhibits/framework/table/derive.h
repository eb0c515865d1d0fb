#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/hash.h"
#include "render/plan/frame_plan.h"

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

// Functions that derive code and text from a parameter table. Each reads only the parameters, so a new parameter needs
// no change here.
namespace vitrine::derive {

/// Returns the enumerators of a table's choices as GLSL: `const int shadowMethod_area = 5;` for the choice "area" of
/// the parameter "shadowMethod".
[[nodiscard]] std::string enumerators(const Parameters&);

/// Returns the std140 uniform block of a table as GLSL, to be placed after its `enumerators`. Shaders read
/// `parameters.shellCount`. Real parameters are float, count and choice int, toggle bool, color and direction vec3.
/// File parameters have no field.
[[nodiscard]] std::string uniformBlock(const Parameters&);

/// Returns the bytes of that block.
[[nodiscard]] render::Bytes uniformBytes(const ParameterValues&);

/// Returns the Markdown table of the parameters for the exhibit's page in the manual.
[[nodiscard]] std::string manualTable(const Parameters&);

/// Returns up to `points` values that span the comfortable range, spaced by the parameter's scale, with both ends and
/// the initial value. Returns all choices of a choice, and nothing for colors, directions and files.
[[nodiscard]] std::vector<double> sweep(const ParameterInfo&, int points);

/// Adds all values to the hash of a result that depends on them.
void addToKey(render::Hash&, const ParameterValues&);

/// Returns these parameters as text, by name and to the last bit: the key of an asset that is made of them and of
/// nothing else.
[[nodiscard]] std::string keyOf(const ParameterValues&, std::span<const std::size_t> rows);
[[nodiscard]] std::string keyOf(const ParameterValues&, std::initializer_list<std::size_t> rows);
/// The same for all parameters of a group, so that none is forgotten.
[[nodiscard]] std::string keyOf(const ParameterValues&, Parameters::Group);

}  // namespace vitrine::derive
