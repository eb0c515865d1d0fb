#include "exhibits/framework/table/typed_number.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/value_text.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace vitrine {
namespace {

bool isBounded(const NumberRange& range)
{
    return range.low > std::numeric_limits<double>::lowest() && range.high < std::numeric_limits<double>::max();
}

}  // namespace

NumberRange rangeOf(const ParameterInfo& parameter, Unit unit)
{
    // Converting to another unit is not exact. The ends are round numbers in one of the units, so they are rounded.
    const auto end = [unit](double stored) {
        return unit == Unit::none ? stored : std::round(shown(stored, unit) * 1e9) / 1e9;
    };
    return {end(parameter.range.low), end(parameter.range.high), unit};
}

std::string rangeText(const NumberRange& range)
{
    const std::string kind = range.whole ? "a whole number" : "a number";
    if (!isBounded(range)) return range.whole ? "a whole number" : "a finite number";
    const auto text = [&](double limit) {
        return range.whole && std::abs(limit) < 1e15 ? std::to_string(std::llround(limit))
                                                     : render::shortestNumber(limit);
    };
    return kind + " from " + text(range.low) + " to " + text(range.high) + behindNumber(info(range.unit).symbol);
}

std::optional<std::string> withDecimalPoint(const std::string& typed)
{
    const std::size_t comma = typed.find(',');
    if (comma == std::string::npos || typed.find_first_of(",.", comma + 1) != std::string::npos) return std::nullopt;
    std::string with = typed;
    with[comma] = '.';
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const std::size_t sign = with.find_first_of("+-") == 0 ? 1 : 0;
    const bool before = comma > sign && std::all_of(with.begin() + static_cast<std::ptrdiff_t>(sign),
                                                    with.begin() + static_cast<std::ptrdiff_t>(comma), isDigit);
    if (!before || comma + 1 >= with.size() || !isDigit(with[comma + 1])) return std::nullopt;
    return with;
}

void refuseDecimalComma(const std::string& option, const std::string& typed)
{
    const std::optional<std::string> point = withDecimalPoint(typed);
    if (!point) return;
    throw Failure(ErrorKind::usage, option + " \"" + typed +
                                        "\": numbers have a decimal point here, in every language; write " +
                                        point.value() + '.');
}

std::optional<double> plainOrWithUnit(const std::string& typed, Unit unit)
{
    // Plain ones go no way through another unit: they keep their bits.
    if (const std::optional<double> plain = render::parseNumber(typed)) return plain;
    const std::optional<double> stored = evaluate(typed, unit);
    return stored ? std::optional(shown(*stored, unit)) : std::nullopt;
}

double readNumber(const std::string& option, const std::string& typed, const NumberRange& range)
{
    const std::optional<double> number = plainOrWithUnit(typed, range.unit);
    if (!number) refuseDecimalComma(option, typed);
    // The conditions are written so that NaN, which fails every comparison, is refused.
    const bool good = number && *number >= range.low && *number <= range.high && std::isfinite(*number) &&
                      (!range.whole || *number == std::floor(*number));
    if (!good) throw Failure(ErrorKind::usage, option + " \"" + typed + "\": give " + rangeText(range) + '.');
    return *number;
}

std::string behindNumber(std::string_view symbol)
{
    return symbol.empty() || symbol == "°" || symbol == "%" ? std::string(symbol) : ' ' + std::string(symbol);
}

std::string typeName(const NumberRange& range)
{
    if (!isBounded(range)) return "NUMBER";
    return render::shortestNumber(range.low) + ".." + render::shortestNumber(range.high);
}

std::string presentText(double number)
{
    return render::shortestNumber(number);
}

std::optional<Value> optionValue(const ParameterInfo& parameter, const std::string& text)
{
    if (parameter.isNumeric())
        if (const auto plain = evaluate(text, Unit::none)) return *plain;
    return parseValue(parameter, text);
}

std::string whatItTakes(const ParameterInfo& parameter, const std::string& typed)
{
    if (parameter.kind == Kind::choice) return "one of " + joined(parameter.choices);
    if (parameter.kind == Kind::toggle) return "on or off";
    if (parameter.kind == Kind::color) return "#rrggbb or r,g,b";
    if (parameter.kind == Kind::direction) return "x,y,z";
    const bool isPlain = typed.empty() || evaluate(typed, Unit::none);
    if (!isPlain) return rangeText(rangeOf(parameter, parameter.unit));
    return rangeText(rangeOf(parameter)) + behindNumber(info(parameter.unit).storedSymbol);
}

}  // namespace vitrine
