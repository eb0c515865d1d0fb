#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Returns the shortest decimal text that reads back as exactly `x`, in every locale: "0.1", "1e+20", "-0". `x` must be
/// finite.
[[nodiscard]] std::string shortestNumber(double x);

/// Returns three significant digits, for sentences, in every locale: "0.0318", "1.5e+06", "inf".
[[nodiscard]] std::string shortNumber(double x);

/// Parses the whole of `text` as a number ("-1.5e3"; no blanks, no leading +, a decimal point in every locale). Returns
/// nothing if it is not a finite number.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace vitrine::render
