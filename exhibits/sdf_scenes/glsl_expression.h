#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace vitrine::scenes {

/// Texts that replace the names p, d, a, b and i in an expression of a node kind.
using ExpressionNames = std::map<std::string, std::string, std::less<>>;

/// Returns the text of an `Expression` with its names and numbers replaced. `number` returns the text of V(n); V3(n) is
/// built from three.
[[nodiscard]] std::string writtenOut(std::string_view expression, const ExpressionNames& names,
                                     const std::function<std::string(std::uint32_t)>& number);

/// Returns a number as a GLSL literal, rounded to float32.
[[nodiscard]] std::string floatLiteral(double);

}  // namespace vitrine::scenes
