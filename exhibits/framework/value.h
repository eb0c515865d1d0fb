#pragma once

#include <glm/glm.hpp>

#include <string>
#include <variant>

namespace vitrine {

/// A value as code that walks a table sees it: a number for real, count, toggle (0 or 1) and choice
/// (its index); three numbers for color (linear Rec. 709) and direction (unit length); a path for file; what is written
/// for text.
using Value = std::variant<double, glm::dvec3, std::string>;

}  // namespace vitrine
