#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace vitrine::scenes {

/// What stands for the names p, d, a, b and i of an expression of the table of nodes.
using ExpressionNames = std::map<std::string, std::string, std::less<>>;

/// A text of `Call` with its names put in, and its numbers: `number` is asked for the text of V(n), and V3(n) is put
/// together of three.
[[nodiscard]] std::string writtenOut(std::string_view expression, const ExpressionNames& names,
                                     const std::function<std::string(std::uint32_t)>& number);

/// A number as GLSL reads it, rounded to float32.
[[nodiscard]] std::string floatLiteral(double);

}  // namespace vitrine::scenes
