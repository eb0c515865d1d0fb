#pragma once

#include <array>
#include <cstdio>
#include <numbers>
#include <string>

namespace vitrine::lenticular {

constexpr double mmPerInch = 25.4;
constexpr double radiansPerDegree = std::numbers::pi / 180;

/// "0.3175": six significant digits, for messages and labels.
[[nodiscard]] inline std::string shortText(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

}  // namespace vitrine::lenticular
