#include "exhibits/framework/table/value_text.h"

#include "exhibits/framework/table/expression.h"
#include "render/files/number_text.h"
#include "render/image/srgb.h"
#include "render/text/trimmed.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace vitrine {
namespace {

std::string lower(std::string_view text)
{
    std::string out(text);
    for (char& c : out) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return out;
}

std::string_view withoutBlanks(std::string_view text)
{
    return render::trimmed(text, " \t");
}

std::optional<Value> parseToggle(std::string_view text)
{
    const std::string word = lower(text);
    if (word == "on" || word == "true" || word == "yes" || word == "1") return 1.0;
    if (word == "off" || word == "false" || word == "no" || word == "0") return 0.0;
    return std::nullopt;
}

std::optional<Value> parseChoice(const ParameterInfo& parameter, std::string_view text)
{
    const auto exact = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    const auto found = exact != parameter.choices.end()
                           ? exact
                           : std::find_if(parameter.choices.begin(), parameter.choices.end(),
                                          [&](std::string_view name) { return lower(name) == lower(text); });
    if (found == parameter.choices.end()) return std::nullopt;
    return static_cast<double>(found - parameter.choices.begin());
}

std::optional<Value> parseHexColor(std::string_view digits)
{
    if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
    const std::size_t each = digits.size() / 3;
    glm::dvec3 color(0);
    for (int i = 0; i < 3; ++i) {
        const std::string_view part = digits.substr(static_cast<std::size_t>(i) * each, each);
        unsigned code = 0;
        const std::from_chars_result end = std::from_chars(part.data(), part.data() + part.size(), code, 16);
        if (end.ec != std::errc() || end.ptr != part.data() + part.size()) return std::nullopt;
        color[i] = render::linearFromSrgb((each == 1 ? 17 * code : code) / 255.0);
    }
    return color;
}

/// Parses "17:30" or "17:30:15" as hours; nullopt if it is not a time of day.
std::optional<double> parseClock(std::string_view text)
{
    double hours = 0;
    double each = 1;
    for (int part = 0; part < 3; ++part, each /= 60) {
        const std::size_t colon = std::min(text.find(':'), text.size());
        int number = 0;
        const std::from_chars_result end = std::from_chars(text.data(), text.data() + colon, number);
        if (end.ec != std::errc() || end.ptr != text.data() + colon || number < 0 || number >= (part == 0 ? 25 : 60))
            return std::nullopt;
        hours += number * each;
        if (colon == text.size()) return part > 0 ? std::optional(hours) : std::nullopt;
        text.remove_prefix(colon + 1);
    }
    return std::nullopt;
}

std::optional<glm::dvec3> parseThree(std::string_view text)
{
    glm::dvec3 v(0);
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
        const std::optional<double> x = evaluate(text.substr(0, comma), Unit::none);
        if (!x) return std::nullopt;
        v[i] = *x;
        if (i < 2) text.remove_prefix(comma + 1);
    }
    return v;
}

template <typename Number> std::string digits(Number x, int count)
{
    std::array<char, 64> text{};
    const std::to_chars_result end =
        std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, count);
    return std::string(text.data(), end.ptr);
}

/// Returns the text with the fewest digits, in the displayed unit, that `evaluate` converts to exactly `value`.
std::string formatNumber(double value, Unit unit)
{
    const double inUnit = shown(value, unit);
    for (int count = 1; std::isfinite(inUnit) && count <= 17; ++count) {
        std::string text = digits(inUnit, count);
        if (text.find('e') != std::string::npos) text = render::shortestNumber(*render::parseNumber(text));
        if (evaluate(text, unit) == value) return text;
    }
    // The value lies between two doubles of the displayed unit: more digits are needed.
    const long double exact = static_cast<long double>(value) * static_cast<long double>(info(unit).shownPerStored);
    for (int count = 17; count <= 24; ++count) {
        const std::string text = digits(exact, count);
        if (evaluate(text, unit) == value) return text;
    }
    std::string text = render::shortestNumber(value);
    return (text += ' ') += info(unit).storedSymbol;
}

std::string formatThree(const glm::dvec3& v)
{
    std::string text = render::shortestNumber(v.x);
    (text += ',') += render::shortestNumber(v.y);
    return (text += ',') += render::shortestNumber(v.z);
}

}  // namespace

std::optional<Value> parseValue(const ParameterInfo& parameter, std::string_view text)
{
    if (parameter.isWritten()) return std::string(text);
    text = withoutBlanks(text);
    switch (parameter.kind) {
    case Kind::toggle: return parseToggle(text);
    case Kind::choice: return parseChoice(parameter, text);
    case Kind::color: {
        if (const std::optional<Value> color = parseHexColor(text.substr(text.starts_with('#') ? 1 : 0))) return color;
        if (const std::optional<glm::dvec3> color = parseThree(text)) return *color;
        return std::nullopt;
    }
    case Kind::direction: {
        if (const std::optional<glm::dvec3> direction = parseThree(text)) return nearestLegal(parameter, *direction);
        return std::nullopt;
    }
    default: {
        for (const Word& word : parameter.words)
            if (lower(text) == lower(word.text)) return word.value;
        if (parameter.unit == Unit::hour && text.find(':') != std::string_view::npos)
            return parseClock(text) ? std::optional<Value>(*parseClock(text)) : std::nullopt;
        if (const std::optional<double> x = evaluate(text, parameter.unit)) return *x;
        return std::nullopt;
    }
    }
}

std::string formatValue(const ParameterInfo& parameter, const Value& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* three = std::get_if<glm::dvec3>(&value)) return formatThree(*three);
    const double x = std::get<double>(value);
    if (parameter.kind == Kind::toggle) return x != 0 ? "on" : "off";
    if (parameter.kind == Kind::choice) return std::string(parameter.choices[static_cast<std::size_t>(x)]);
    if (x < parameter.range.low || x > parameter.range.high)
        if (const Word* word = parameter.wordFor(x)) return std::string(word->text);
    return formatNumber(x, parameter.unit);
}

}  // namespace vitrine
