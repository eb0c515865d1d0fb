#pragma once

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vitrine {

/// A parameter value of any type. A number for real, count, toggle (0 or 1) and choice (its index). Three numbers for
/// color (linear Rec. 709) and direction (unit length). A string for file (its path) and text.
using Value = std::variant<double, glm::dvec3, std::string>;

/// The texts of a parameter that takes several: the lines of its value that are not empty.
[[nodiscard]] std::vector<std::string> linesOf(std::string_view value);

}  // namespace vitrine
