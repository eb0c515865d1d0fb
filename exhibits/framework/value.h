#pragma once

#include <glm/glm.hpp>

#include <string>
#include <variant>

namespace vitrine {

/// A parameter value of any type. A number for real, count, toggle (0 or 1) and choice (its index). Three numbers for
/// color (linear Rec. 709) and direction (unit length). A string for file (its path) and text.
using Value = std::variant<double, glm::dvec3, std::string>;

}  // namespace vitrine
