#include "exhibits/framework/table/derive.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/value_text.h"
#include "render/glsl/std140.h"
#include "render/text/joined.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <set>

namespace vitrine::derive {
namespace {

std::string_view glslType(Kind kind)
{
    switch (kind) {
    case Kind::real: return "float";
    case Kind::count:
    case Kind::choice: return "int";
    case Kind::toggle: return "bool";
    case Kind::color:
    case Kind::direction: return "vec3";
    case Kind::file:
    case Kind::text: return "";
    }
    return "";
}

std::string rangeText(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count:
        return formatValue(parameter, parameter.range.low) + " to " + formatValue(parameter, parameter.range.high);
    case Kind::toggle: return "on, off";
    case Kind::choice: return joined(parameter.choices);
    case Kind::color: return "any color";
    case Kind::direction: return "any direction";
    case Kind::file: return "a file";
    case Kind::text: return "a text";
    }
    return {};
}

/// Converts to camel case: "oldGold" for "old gold", "sunSDisk" for "sun's disk".
std::string camelCase(std::string_view text)
{
    std::string name;
    bool begins = false;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) == 0) {
            begins = !name.empty();
            continue;
        }
        name += static_cast<char>(begins ? std::toupper(u) : u);
        begins = false;
    }
    return name;
}

}  // namespace

std::string enumerators(const Parameters& table)
{
    std::string text;
    std::set<std::string> names;
    for (const ParameterInfo& parameter : table.rows())
        for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
            const std::string name = std::string(parameter.name) + '_' + camelCase(parameter.choices[i]);
            if (names.insert(name).second) text += "const int " + name + " = " + std::to_string(i) + ";\n";
        }
    return text;
}

std::string uniformBlock(const Parameters& table)
{
    std::string fields;
    for (const ParameterInfo& parameter : table.rows())
        if (!parameter.isWritten())
            fields += "    " + std::string(glslType(parameter.kind)) + ' ' + std::string(parameter.name) + ";\n";
    if (fields.empty()) return {};
    return enumerators(table) + "layout(std140, binding = " + std::to_string(BLOCK_PARAMETERS) +
           ") uniform Parameters {\n" + fields + "} parameters;\n";
}

render::Bytes uniformBytes(const ParameterValues& values)
{
    render::Std140Writer block;
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        if (row.isWritten()) continue;
        if (const auto* v = std::get_if<glm::dvec3>(&values.row(i)))
            block.put(glm::vec3(*v));
        else if (row.kind == Kind::real)
            block.put(static_cast<float>(std::get<double>(values.row(i))));
        else
            block.put(static_cast<std::int32_t>(std::get<double>(values.row(i))));
    }
    return block.take();
}

std::string manualTable(const Parameters& table)
{
    std::string text = "| parameter | initial | range | unit | what it does |\n|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const ParameterInfo& row = table.rows()[i];
        std::string unit(info(row.unit).symbol);
        text += "| `" + std::string(row.name) + "` | " + formatValue(row, row.initial) + " | " + rangeText(row) +
                " | " + unit + " | " + std::string(row.help);
        if (row.qualityReference)
            text += (row.exactByMeaning ? " *Quality: exact at " : " *Quality: finest at ") +
                    formatValue(row, *row.qualityReference) + ".*";
        if (row.actsWhen) text += " *Acts when " + actsWhen(table, i) + ".*";
        text += " |\n";
    }
    return text;
}

std::vector<double> sweep(const ParameterInfo& parameter, int points)
{
    std::vector<double> values;
    const auto [low, high, scale, softLow, softHigh] = parameter.range;
    switch (parameter.kind) {
    case Kind::toggle: return {0, 1};
    case Kind::choice:
        for (std::size_t i = 0; i < parameter.choices.size(); ++i) values.push_back(static_cast<double>(i));
        return values;
    case Kind::real:
    case Kind::count: break;
    default: return {};
    }
    values.push_back(std::get<double>(parameter.initial));
    for (int i = 0; i < points; ++i) {
        const double t = points > 1 ? static_cast<double>(i) / (points - 1) : 0.0;
        const double x = i == points - 1 && points > 1 ? softHigh
                         : scale == Scale::logarithmic ? softLow * std::pow(softHigh / softLow, t)
                                                       : softLow + (softHigh - softLow) * t;
        values.push_back(parameter.kind == Kind::count ? std::round(x) : x);
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

void addToKey(render::Hash& key, const ParameterValues& values)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const Value& value = values.row(i);
        if (const auto* x = std::get_if<double>(&value))
            key.addValue(*x);
        else if (const auto* v = std::get_if<glm::dvec3>(&value))
            key.addValue(*v);
        else
            key.add(std::get<std::string>(value)).addValue('\n');
    }
}

std::string keyOf(const ParameterValues& values, std::span<const std::size_t> rows)
{
    std::string key;
    const auto add = [&key](double x) { key += '=' + std::to_string(std::bit_cast<std::uint64_t>(x)); };
    for (const std::size_t row : rows) {
        key += ';' + std::string(values.rows()[row].name);
        const Value& value = values.row(row);
        if (const auto* x = std::get_if<double>(&value))
            add(*x);
        else if (const auto* v = std::get_if<glm::dvec3>(&value))
            for (int i = 0; i < 3; ++i) add((*v)[i]);
        else
            key += '=' + std::get<std::string>(value);
    }
    return key;
}

std::string keyOf(const ParameterValues& values, std::initializer_list<std::size_t> rows)
{
    return keyOf(values, std::span(rows.begin(), rows.size()));
}

std::string keyOf(const ParameterValues& values, Parameters::Group group)
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (values.rows()[i].group == group.title) rows.push_back(i);
    return keyOf(values, rows);
}

}  // namespace vitrine::derive
