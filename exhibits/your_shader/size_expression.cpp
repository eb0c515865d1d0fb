#include "exhibits/your_shader/size_expression.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/your_shader/guest_shader.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

/// Prefix that no unit and no function of expressions begins with. Inputs are called "m" or "s" as well.
constexpr std::string_view inputPrefix = "input_";

/// Replaces "$name" by a name that expressions know.
std::string withPrefixes(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '$')
            out += inputPrefix;
        else
            out += c;
    }
    return out;
}

}  // namespace

PassSize passSize(std::string_view text, int width, int height, int whole, const InputValue& valueOf)
{
    if (text.find_first_not_of(" \t\n") == std::string_view::npos) return {.pixels = whole, .problem = {}};
    if (text.size() > Limits::expressionBytes)
        return {.problem = message("this size is longer than {1} bytes; shorten it", Limits::expressionBytes)};
    Message unknown;
    const auto names = [&](std::string_view name) -> std::optional<NamedValue> {
        if (!name.starts_with(inputPrefix)) return std::nullopt;
        name.remove_prefix(inputPrefix.size());
        if (name == "WIDTH") return NamedValue{static_cast<double>(width)};
        if (name == "HEIGHT") return NamedValue{static_cast<double>(height)};
        const std::optional<double> value = valueOf(name);
        if (!value) unknown = message("there is no input “{1}” with a number; declare it in INPUTS", name);
        return value ? std::optional(NamedValue{*value}) : std::nullopt;
    };
    const std::optional<double> value = evaluate(withPrefixes(text), Unit::none, names);
    if (!unknown.empty()) return {.problem = unknown};
    if (!value) {
        return {.problem =
                    message("“{1}” is not a size; write an expression of numbers, $WIDTH, $HEIGHT and inputs, such "
                            "as floor($WIDTH/2)",
                            text)};
    }
    if (*value >= Limits::side + 1)
        return {.problem = message("“{1}” gives more than {2} pixels; choose a smaller size", text, Limits::side)};
    return {.pixels = std::max(1, static_cast<int>(std::floor(*value))), .problem = {}};
}

}  // namespace vitrine::guest
