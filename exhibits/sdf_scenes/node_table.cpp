// Converts the numbers of a node to parameters of a table and back into the text.

#include "exhibits/framework/table/value_text.h"
#include "exhibits/sdf_scenes/record_kinds.h"
#include "exhibits/sdf_scenes/scene_edit.h"
#include "exhibits/sdf_scenes/scene_tree.h"
#include "render/failure.h"

#include <algorithm>
#include <cctype>

namespace vitrine::scenes {
namespace {

constexpr const char* materialParameter = "material";

/// Returns the value of a node at a path; nullopt if there is none.
std::optional<std::uint32_t> objectAt(const render::JsonText& json, std::string_view path)
{
    const auto value = json.at(path);
    const bool isNode =
        value && json.value(*value).type == render::JsonSpan::Type::object && json.member(*value, "kind");
    return isNode ? value : std::nullopt;
}

const NodeKind* kindAt(const render::JsonText& json, std::uint32_t value)
{
    const auto word = json.member(value, "kind");
    return word && json.value(*word).type == render::JsonSpan::Type::string ? findKind(json.string(*word)) : nullptr;
}

std::vector<std::string> materialNames(const render::JsonText& json)
{
    std::vector<std::string> names{"from parent"};
    if (const auto materials = json.member(0, "materials"))
        for (const std::uint32_t value : json.children(*materials)) names.push_back(json.key(value));
    return names;
}

void addParametersOf(const std::vector<Field>& fields, std::vector<NodeParameter>& rows)
{
    for (const Field& field : fields) {
        const bool whole = numbersOf(field.type) == 1 || field.type == FieldType::direction;
        for (std::size_t i = 0; i < (whole ? 1 : numbersOf(field.type)); ++i) rows.push_back({&field, i, whole});
    }
}

std::string parameterName(const MadeTable& table, const NodeParameter& row)
{
    std::string name(row.field->name);
    if (!row.whole) name += "XYZ"[row.component];
    while (table.find(name)) name += "2";
    return name;
}

void addRow(MadeTable& table, const NodeParameter& row)
{
    const Field& field = *row.field;
    const std::string name = parameterName(table, row);
    const double initial = field.initial[row.component];
    const bool isSize = field.unit == Unit::meter && field.low > 0;
    const Range range =
        Range{field.low, field.high, isSize ? Scale::logarithmic : Scale::linear}.soft(field.softLow, field.softHigh);
    switch (field.type) {
    case FieldType::toggle: table.toggle(name, initial != 0, field.help); break;
    case FieldType::choice: {
        const std::vector<std::string> names(field.choices.begin(), field.choices.end());
        table.choice(name, static_cast<int>(initial), names, field.help);
        break;
    }
    case FieldType::count:
    case FieldType::counts: table.count(name, static_cast<int>(initial), range, field.help); break;
    case FieldType::direction:
        table.direction(name, {field.initial[0], field.initial[1], field.initial[2]}, field.help);
        break;
    default: table.real(name, initial, field.unit, range, field.help);
    }
}

/// Numbers of a field, as written in the file or computed from expressions; lists those that are computed.
class FieldNumbers {
public:
    FieldNumbers(const Scene& scene, const std::vector<double>& numbers, std::string_view path, std::uint32_t value)
        : scene_(scene), json_(*scene.files.front().text), numbers_(numbers), value_(value), node_(nodeAt(scene, path))
    {
    }

    double at(const Field& field, std::size_t component)
    {
        const auto member = json_.member(value_, field.name);
        if (!member) return field.initial[component];
        std::uint32_t one = *member;
        if (json_.value(one).type == render::JsonSpan::Type::array) {
            const std::vector<std::uint32_t> parts = json_.children(one);
            if (component >= parts.size()) return field.initial[component];
            one = parts[component];
        }
        switch (json_.value(one).type) {
        case render::JsonSpan::Type::number: return stored(json_.number(one), field.unit);
        case render::JsonSpan::Type::boolean: return json_.boolean(one) ? 1 : 0;
        default: break;
        }
        if (field.type == FieldType::choice) {
            const auto word = std::find(field.choices.begin(), field.choices.end(), json_.string(one));
            return word == field.choices.end() ? field.initial[0] : static_cast<double>(word - field.choices.begin());
        }
        computed += (computed.empty() ? "" : ", ") + std::string(field.name);
        if (numbersOf(field.type) > 1) computed += std::string(" ") + "xyz"[component];
        return computedAt(field, component);
    }

    std::string computed;

private:
    [[nodiscard]] double computedAt(const Field& field, std::size_t component) const
    {
        if (node_ == noIndex) return field.initial[component];
        const Node& node = scene_.nodes[node_];
        const std::vector<Field>& places = placeFields();
        const std::uint32_t at[] = {node.translate, node.rotate, node.scale};
        for (std::size_t i = 0; i < places.size(); ++i)
            if (&places[i] == &field) return at[i] == noIndex ? field.initial[component] : numbers_[at[i] + component];
        return numbers_[node.numbers + node.kind->numberOf(field.name) + component];
    }

    const Scene& scene_;
    const render::JsonText& json_;
    const std::vector<double>& numbers_;
    std::uint32_t value_, node_;
};

double materialIndex(const render::JsonText& json, std::uint32_t value, const std::vector<std::string>& names)
{
    const auto material = json.member(value, materialParameter);
    if (!material || json.value(*material).type != render::JsonSpan::Type::string) return 0;
    const auto found = std::find(names.begin() + 1, names.end(), json.string(*material));
    return found == names.end() ? 0 : static_cast<double>(found - names.begin());
}

}  // namespace

std::vector<NodeParameter> parametersOfNode(const Scene& scene, std::string_view path)
{
    std::vector<NodeParameter> rows;
    const render::JsonText& json = *scene.files.front().text;
    const auto value = objectAt(json, path);
    if (!value) return rows;
    if (const NodeKind* kind = kindAt(json, *value)) addParametersOf(kind->fields, rows);
    addParametersOf(placeFields(), rows);
    rows.push_back({});
    return rows;
}

std::optional<TreeParameters> nodeParameters(const Scene& scene, const std::vector<double>& numbers,
                                             std::string_view path)
{
    const render::JsonText& json = *scene.files.front().text;
    const auto value = objectAt(json, path);
    if (!value) return std::nullopt;
    const std::vector<NodeParameter> rows = parametersOfNode(scene, path);
    const std::vector<std::string> materials = materialNames(json);
    auto table = std::make_shared<MadeTable>();
    std::string heading = json.string(*json.member(*value, "kind"));
    heading.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(heading.front())));
    table->group(heading);
    for (const NodeParameter& row : rows) {
        if (row.field == &placeFields().front() && row.component == 0) table->group("Place");
        if (!row.field) table->group("Material");
        if (row.field)
            addRow(*table, row);
        else
            table->choice(materialParameter, 0, materials,
                          "Material of the shape and of everything in it that sets no other.");
    }
    TreeParameters made{ParameterValues(std::shared_ptr<const Parameters>(table)), {}};
    FieldNumbers fields(scene, numbers, path, *value);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const NodeParameter& row = rows[i];
        if (!row.field)
            made.values.setParameter(i, materialIndex(json, *value, materials));
        else if (row.field->type == FieldType::direction)
            made.values.setParameter(
                i, glm::dvec3(fields.at(*row.field, 0), fields.at(*row.field, 1), fields.at(*row.field, 2)));
        else
            made.values.setParameter(i, fields.at(*row.field, row.component));
    }
    if (!fields.computed.empty())
        made.note = "Expressions: " + fields.computed + ". Moving a slider replaces the expression by a number.";
    return made;
}

std::string textWithParameter(const Scene& scene, std::string_view path, std::size_t index, const Value& value)
{
    const std::vector<NodeParameter> rows = parametersOfNode(scene, path);
    if (index >= rows.size())
        throw Failure(ErrorKind::check, "Cannot change the value: the node no longer has it. Select another node.");
    const render::JsonText& json = *scene.files.front().text;
    const SceneEdit edit(json.text());
    const NodeParameter& row = rows[index];
    if (!row.field) {
        const std::vector<std::string> names = materialNames(json);
        const auto chosen = static_cast<std::size_t>(std::get<double>(value));
        return edit.withMaterial(path, chosen == 0 ? std::string() : names.at(chosen)).text;
    }
    if (const auto* direction = std::get_if<glm::dvec3>(&value))
        return edit.withNumbers(path, *row.field, {direction->x, direction->y, direction->z}).text;
    return edit.withNumber(path, *row.field, row.component, std::get<double>(value)).text;
}

std::string textWithPlace(const Scene& scene, std::string_view path, const TreePlace& before, const TreePlace& after)
{
    std::string text = scene.files.front().text->text();
    const glm::dvec3 old[] = {before.translate, before.rotate, before.scale};
    const glm::dvec3 now[] = {after.translate, after.rotate, after.scale};
    for (std::size_t i = 0; i < placeFields().size(); ++i) {
        const Field& field = placeFields()[i];
        for (int axis = 0; axis < 3; ++axis)
            if (old[i][axis] != now[i][axis])
                text = SceneEdit(text)
                           .withNumber(path, field, static_cast<std::size_t>(axis),
                                       std::clamp(now[i][axis], field.low, field.high))
                           .text;
    }
    return text;
}

}  // namespace vitrine::scenes
