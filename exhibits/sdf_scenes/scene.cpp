#include "exhibits/sdf_scenes/scene.h"

#include "exhibits/framework/table/expression.h"

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {

Message Finding::text() const
{
    return key.empty() ? message("{1}:{2}:{3}: {4}", file, line, column, Message(sentence))
                       : message("{1}:{2}:{3}: {4}: {5}", file, line, column, key, Message(sentence));
}

Failure Finding::failure() const
{
    return {ErrorKind::file, text(), {file, line, column, key}};
}

bool Scene::animated() const
{
    return std::any_of(expressions.begin(), expressions.end(), [](const NumberExpression& e) { return e.usesTime; });
}

std::vector<double> Scene::numbersAt(double time, const std::vector<double>& given) const
{
    std::vector<double> values(numbers.size());
    std::vector<std::map<std::string, NamedValue, std::less<>>> names(files.size());
    for (std::size_t file = 0; file < files.size() && !expressions.empty(); ++file) {
        names[file]["t"] = {time, Unit::none};
        const std::vector<SceneParameter>& parameters = files[file].parameters;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const SceneParameter& p = parameters[i];
            const double value = file == 0 && i < given.size() ? std::clamp(given[i], p.low, p.high) : p.initial;
            names[file][p.name] = {value, p.unit};
        }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        values[i] = numbers[i].value;
        if (numbers[i].expression == noIndex) continue;
        const NumberExpression& expression = expressions[numbers[i].expression];
        const auto& known = names[expression.file];
        const auto valueOf = [&](std::string_view word) -> std::optional<NamedValue> {
            const auto found = known.find(word);
            return found == known.end() ? std::nullopt : std::optional(found->second);
        };
        if (const std::optional<double> x = evaluate(expression.text, expression.unit, valueOf))
            values[i] = std::clamp(expression.whole ? std::round(*x) : *x, expression.low, expression.high);
    }
    return values;
}

void normalizeDirections(const std::vector<Field>& fields, double* numbers)
{
    for (const Field& field : fields) {
        if (field.type == FieldType::direction) {
            const double length = std::hypot(numbers[0], numbers[1], numbers[2]);
            for (std::size_t i = 0; i < 3; ++i) numbers[i] = length > 0 ? numbers[i] / length : (i == 1 ? 1.0 : 0.0);
        }
        numbers += numbersOf(field.type);
    }
}

}  // namespace vitrine::scenes
