#pragma once

#include "exhibits/framework/parameters.h"

#include <CLI/CLI.hpp>

#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace vitrine::app {

/// Numbers that an option takes, both ends included. Plain numbers are typed, and kept, in `unit`.
struct NumberRange {
    double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
    Unit unit = Unit::none;
    bool whole = false;
};

/// Range of a row, in a unit in which its values may be shown: a row in meters in `Unit::millimeter`.
[[nodiscard]] NumberRange rangeOf(const ParameterInfo&, Unit = Unit::none);

/// The same of a table's row by its handle.
template <typename Row>
[[nodiscard]] NumberRange rangeOf(const Parameters& table, const Row& row, Unit unit = Unit::none)
{
    return rangeOf(table.rows()[row.row], unit);
}

/// "a number from 1 to 175 deg": after "give ".
[[nodiscard]] std::string rangeText(const NumberRange&);

/// Reads a finite number in the range: plain, an expression, or with a unit of its own ("40deg", "3cm"). Throws Failure
/// (Blame::usage) that begins with the option.
[[nodiscard]] double readNumber(const std::string& option, const std::string& typed, const NumberRange&);

/// The same without a range; nothing where it is none.
[[nodiscard]] std::optional<double> plainOrWithUnit(const std::string& typed, Unit);

/// The same text with a decimal point, where it is a number with a decimal comma ("0,5"); nothing for all else.
[[nodiscard]] std::optional<std::string> withDecimalPoint(const std::string& typed);
/// Refuses a number with a decimal comma. Throws Failure (Blame::usage) that begins with `option`.
void refuseDecimalComma(const std::string& option, const std::string& typed);

/// A unit behind its number: " mm", "°".
[[nodiscard]] std::string behindNumber(std::string_view symbol);

/// How an option's range stands in help texts: "NUMBER", "1..64".
[[nodiscard]] std::string typeName(const NumberRange&);
/// How an option's present value stands there.
[[nodiscard]] std::string presentText(double);

/// The number that an option keeps: itself, or what an optional holds.
template <typename T> struct KeptNumber {
    using Type = T;
};
template <typename T> struct KeptNumber<std::optional<T>> {
    using Type = T;
};

/// Adds an option for one number, the only kind that commands have: it is finite and in its range, or refused.
template <typename Number>
CLI::Option* addNumber(CLI::App& command, const std::string& name, Number& value, NumberRange range,
                       const std::string& help)
{
    using Plain = typename KeptNumber<Number>::Type;
    range.whole = std::is_integral_v<Plain>;
    CLI::Option* option = command.add_option_function<std::string>(
        name,
        [&value, name, range](const std::string& typed) { value = static_cast<Plain>(readNumber(name, typed, range)); },
        help);
    if constexpr (std::is_arithmetic_v<Number>)
        option->default_function([&value] { return presentText(static_cast<double>(value)); });
    return option->type_name(typeName(range));
}

/// Adds an option that takes one of these names.
CLI::Option* addChoice(CLI::App&, const std::string& name, std::string& value, const std::vector<std::string>& names,
                       const std::string& help);

}  // namespace vitrine::app
