#include "exhibits/framework/table/value_schema.h"

#include <cmath>

namespace vitrine {

using render::Json;

namespace {

/// Returns an end of a range, rounded away from its inside to six digits unless it is exact with six. People write
/// such numbers, and reading takes them for the end.
double roundEnd(double end, bool isHigh)
{
    if (end == 0 || !std::isfinite(end)) return end;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(end))) - 5), units = end / unit;
    if (std::abs(units - std::round(units)) < 1e-6) return end;
    const double outward = isHigh ? std::ceil(units) : std::floor(units);
    return unit < 1 ? outward / std::round(1 / unit) : outward * unit;
}

}  // namespace

Json valueSchema(const ParameterInfo& parameter)
{
    Json words = Json::array();
    for (const Word& word : parameter.words) words.push_back(std::string(word.text));
    Json json = Json::object();
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count:
        json["type"] = parameter.kind == Kind::real ? "number" : "integer";
        json["minimum"] = roundEnd(parameter.range.low, false);
        json["maximum"] = roundEnd(parameter.range.high, true);
        if (words.empty()) return json;
        return {{"anyOf", Json::array({json, {{"enum", words}}})}};
    case Kind::toggle: return {{"type", "boolean"}};
    case Kind::choice:
        for (const std::string_view choice : parameter.choices) words.push_back(std::string(choice));
        return {{"enum", words}};
    case Kind::color:
    case Kind::direction: {
        const Json each{{"type", "number"}};
        return {{"type", "array"}, {"items", each}, {"minItems", 3}, {"maxItems", 3}};
    }
    case Kind::file:
    case Kind::text: break;
    }
    if (!parameter.several) return {{"type", "string"}};
    return {{"type", "array"}, {"items", Json{{"type", "string"}, {"minLength", 1}}}};
}

void describe(Json& schema, const ParameterInfo& parameter)
{
    schema["title"] = label(parameter);
    schema["description"] = std::string(parameter.help);
    if (const std::string_view unit = info(parameter.unit).storedSymbol; !unit.empty())
        schema["x-unit"] = std::string(unit);
}

}  // namespace vitrine
