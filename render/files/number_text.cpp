#include "render/files/number_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace vitrine::render {

std::string shortestNumber(double x)
{
    assert(std::isfinite(x));
    std::array<char, 32> text{};  // The longest number has 24 characters: -2.2250738585072014e-308.
    const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), x);
    return std::string(text.data(), end.ptr);
}

std::string shortNumber(double x)
{
    std::array<char, 32> text{};
    const std::to_chars_result end =
        std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 3);
    return std::string(text.data(), end.ptr);
}

std::optional<double> parseNumber(std::string_view text)
{
    double x = 0;
    const char* last = text.data() + text.size();
    const std::from_chars_result end = std::from_chars(text.data(), last, x);
    if (end.ec != std::errc() || end.ptr != last || !std::isfinite(x)) return std::nullopt;
    return x;
}

}  // namespace vitrine::render
