#pragma once

#include "exhibits/framework/table/parameters.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// Range of an option's number, both ends included. Plain numbers are typed and stored in `unit`.
struct NumberRange {
    double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
    Unit unit = Unit::none;
    bool whole = false;
};

/// Returns the range of a parameter in a unit in which its values may be shown, such as `Unit::millimeter` for a
/// parameter in meters.
[[nodiscard]] NumberRange rangeOf(const ParameterInfo&, Unit = Unit::none);

/// The same for a parameter of a table, given by its handle.
template <typename Row>
[[nodiscard]] NumberRange rangeOf(const Parameters& table, const Row& row, Unit unit = Unit::none)
{
    return rangeOf(table.rows()[row.row], unit);
}

/// Returns the text that follows "give ": "a number from 1 to 175 deg".
[[nodiscard]] std::string rangeText(const NumberRange&);

/// Reads a finite number in the range: plain, an expression, or with a unit ("40deg", "3cm"). Throws Failure
/// (ErrorKind::usage) whose sentence begins with the option.
[[nodiscard]] double readNumber(const std::string& option, const std::string& typed, const NumberRange&);

/// The same without a range; nullopt if the text is no number.
[[nodiscard]] std::optional<double> plainOrWithUnit(const std::string& typed, Unit);

/// Returns the text with a decimal point if it is a number with a decimal comma ("0,5"); nullopt otherwise.
[[nodiscard]] std::optional<std::string> withDecimalPoint(const std::string& typed);
/// Refuses a number with a decimal comma. Throws Failure (ErrorKind::usage) whose sentence begins with `option`.
void refuseDecimalComma(const std::string& option, const std::string& typed);

/// Returns a unit as it follows a number: " mm", "°".
[[nodiscard]] std::string behindNumber(std::string_view symbol);

/// Parses a value of the command line. A number without a unit is in SI units. Returns nullopt if the text is invalid.
[[nodiscard]] std::optional<Value> optionValue(const ParameterInfo&, const std::string& text);
/// Returns the text that follows "give ": "a number from 0 to 1", "one of none, hard". Numbers are in SI units if
/// `typed` is a plain number, else in the parameter's displayed unit.
[[nodiscard]] std::string whatItTakes(const ParameterInfo&, const std::string& typed = {});

/// Returns an option's range for help texts: "NUMBER", "1..64".
[[nodiscard]] std::string typeName(const NumberRange&);
/// Returns an option's present value for help texts.
[[nodiscard]] std::string presentText(double);

}  // namespace vitrine
