#pragma once

#include <numbers>

namespace vitrine::test {

inline constexpr double degree = std::numbers::pi / 180;  ///< In radians.

}  // namespace vitrine::test
