#include "exhibits/sdf_scenes/field_reader.h"

#include "exhibits/framework/table/expression.h"

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {
namespace {

using JsonType = render::JsonSpan::Type;

std::string shownNumber(double si, Unit unit)
{
    const std::string_view symbol = info(unit).symbol;
    return sentenceNumber(shown(si, unit)) + (symbol.empty() ? "" : ' ' + std::string(symbol));
}

bool isWhole(const Field& field)
{
    return field.type == FieldType::count || field.type == FieldType::counts;
}

std::string unitWords(Unit unit)
{
    switch (unit) {
    case Unit::meter: return "a number in meters, or an expression such as \"12 mm\" or \"0.5 + 0.1 * sin(t)\"";
    case Unit::degree: return "a number in degrees, or an expression such as \"90 * t\"";
    default: return "a number, or an expression such as \"0.5 + 0.1 * sin(t)\"";
    }
}

}  // namespace

std::string rangeText(const Field& field)
{
    return shownNumber(field.low, field.unit) + " to " + shownNumber(field.high, field.unit);
}

std::uint32_t FieldReader::initialFields(const std::vector<Field>& fields)
{
    const auto first = static_cast<std::uint32_t>(scene_.numbers.size());
    for (const Field& field : fields)
        for (std::size_t i = 0; i < numbersOf(field.type); ++i) scene_.numbers.push_back({field.initial[i]});
    return first;
}

std::uint32_t FieldReader::readObject(std::uint32_t file, std::uint32_t object, const std::vector<Field>& fields,
                                      const std::vector<std::string_view>& others, const std::string& what)
{
    const std::uint32_t first = initialFields(fields);
    const render::JsonText& json = text(file);
    for (std::uint32_t i = json.value(object).firstChild; i != render::JsonSpan::none; i = json.value(i).next) {
        const std::string key = json.key(i);
        if (std::find(others.begin(), others.end(), key) != others.end()) continue;
        std::uint32_t at = first;
        auto field = fields.begin();
        for (; field != fields.end() && field->name != key; ++field)
            at += static_cast<std::uint32_t>(numbersOf(field->type));
        if (field != fields.end()) {
            readInto(file, i, *field, at);
            continue;
        }
        std::vector<std::string> known;
        for (const Field& f : fields) known.emplace_back(f.name);
        known.insert(known.end(), others.begin(), others.end());
        findings_.add(json, i, unknownWord(key, "key of " + what, known));
    }
    return first;
}

std::uint32_t FieldReader::readField(std::uint32_t file, std::uint32_t value, const Field& field)
{
    const std::uint32_t first = initialFields({field});
    readInto(file, value, field, first);
    return first;
}

std::string FieldReader::readString(std::uint32_t file, std::uint32_t value)
{
    if (text(file).value(value).type == JsonType::string) return text(file).string(value);
    findings_.add(text(file), value, "this must be a text in quotes");
    return {};
}

void FieldReader::readInto(std::uint32_t file, std::uint32_t value, const Field& field, std::uint32_t at)
{
    const render::JsonText& json = text(file);
    const JsonType type = json.value(value).type;
    if (field.type == FieldType::toggle) {
        if (type == JsonType::boolean)
            scene_.numbers[at].value = json.boolean(value) ? 1 : 0;
        else
            findings_.add(json, value, "this must be true or false");
    } else if (field.type == FieldType::choice) {
        const std::vector<std::string> words(field.choices.begin(), field.choices.end());
        const std::string word =
            type == JsonType::string ? json.string(value) : std::string(json.written(value).substr(0, 40));
        const auto found = std::find(words.begin(), words.end(), word);
        if (type == JsonType::string && found != words.end())
            scene_.numbers[at].value = static_cast<double>(found - words.begin());
        else
            findings_.add(json, value, unknownWord(word, std::string(field.name), words));
    } else if (numbersOf(field.type) == 3) {
        if (field.type == FieldType::sizes && (type == JsonType::number || type == JsonType::string)) {
            const Number all = readNumber(file, value, field);
            std::fill_n(scene_.numbers.begin() + at, 3, all);
            return;
        }
        const std::vector<std::uint32_t> parts =
            type == JsonType::array ? json.children(value) : std::vector<std::uint32_t>();
        if (parts.size() != 3) {
            findings_.add(json, value,
                          field.type == FieldType::sizes ? "this must be a number, or three as [x, y, z]"
                                                         : "this must be three numbers: [x, y, z]");
            return;
        }
        for (std::uint32_t i = 0; i < 3; ++i) scene_.numbers[at + i] = readNumber(file, parts[i], field);
        const Number* n = &scene_.numbers[at];
        if (field.type == FieldType::direction && n[0].value == 0 && n[1].value == 0 && n[2].value == 0)
            findings_.add(json, value, "a direction needs a number that is not 0");
    } else {
        scene_.numbers[at] = readNumber(file, value, field);
    }
}

bool FieldReader::isWithin(std::uint32_t file, std::uint32_t value, const Field& field, double x)
{
    if (isWhole(field) && x != std::round(x)) {
        findings_.add(text(file), value, "this must be a whole number, not " + sentenceNumber(x));
        return false;
    }
    if (x >= field.low && x <= field.high) return true;
    findings_.add(text(file), value, "this is " + shownNumber(x, field.unit) + "; give " + rangeText(field));
    return false;
}

Number FieldReader::readNumber(std::uint32_t file, std::uint32_t value, const Field& field)
{
    const JsonType type = text(file).value(value).type;
    if (type == JsonType::string) return readExpression(file, value, field);
    if (type != JsonType::number) {
        findings_.add(text(file), value, "this must be " + unitWords(field.unit));
        return {field.initial[0]};
    }
    const double x = stored(text(file).number(value), field.unit);
    return {isWithin(file, value, field, x) ? x : field.initial[0]};
}

Number FieldReader::readExpression(std::uint32_t file, std::uint32_t value, const Field& field)
{
    const std::string expression = text(file).string(value);
    const std::vector<SceneParameter>& parameters = scene_.files[file].parameters;
    const std::vector<std::string> names = namesIn(expression);
    for (const std::string& name : names) {
        const auto isNamed = [&](const SceneParameter& p) { return p.name == name; };
        if (name == "t" || std::any_of(parameters.begin(), parameters.end(), isNamed)) continue;
        std::vector<std::string> known{"t"};
        for (const SceneParameter& p : parameters) known.push_back(p.name);
        findings_.add(text(file), value, unknownWord(name, "parameter of the scene", known));
        return {field.initial[0]};
    }
    const auto valueOf = [&](std::string_view name) -> std::optional<NamedValue> {
        if (name == "t") return NamedValue{0, Unit::none};
        for (const SceneParameter& p : parameters)
            if (p.name == name) return NamedValue{p.initial, p.unit};
        return std::nullopt;
    };
    const std::optional<double> x = evaluate(expression, field.unit, valueOf);
    if (!x) {
        findings_.add(text(file), value, "this expression gives no number; it must be " + unitWords(field.unit));
        return {field.initial[0]};
    }
    Number number{*x};
    const bool constant = names.empty();
    if (!constant && isWhole(field)) number.value = std::round(*x);
    if (!isWithin(file, value, field, number.value)) return {field.initial[0]};
    if (constant) return number;
    number.expression = static_cast<std::uint32_t>(scene_.expressions.size());
    scene_.expressions.push_back({expression, field.unit, file, field.low, field.high, isWhole(field),
                                  std::find(names.begin(), names.end(), "t") != names.end()});
    return number;
}

}  // namespace vitrine::scenes
