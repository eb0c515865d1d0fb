#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// The shortest decimal text that reads back as exactly `x`, whatever the locale: "0.1", "1e+20", "-0".
/// `x` must be finite.
[[nodiscard]] std::string shortestNumber(double x);

/// Three significant digits, for sentences, whatever the locale: "0.0318", "1.5e+06", "inf".
[[nodiscard]] std::string shortNumber(double x);

/// The number that the whole of `text` spells ("-1.5e3"; no blanks, no leading +, a dot whatever the
/// locale), or nothing when it is not a finite number.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace vitrine::render
