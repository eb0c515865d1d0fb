#pragma once

#include "exhibits/framework/table/typed_number.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace vitrine::app {

/// Type of an option's number: the type itself, or the type that an optional contains.
template <typename T> struct KeptNumber {
    using Type = T;
};
template <typename T> struct KeptNumber<std::optional<T>> {
    using Type = T;
};

/// Adds an option for one number. All numbers of commands use it: values that are not finite or out of range are
/// refused.
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
