#pragma once

#include <numbers>

namespace vitrine::test {

inline constexpr double degree = std::numbers::pi / 180;  ///< One degree in radians.

}  // namespace vitrine::test
