#include "tests/exhibits/sdf_scenes/scene_schema.h"

#include "exhibits/sdf_scenes/record_kinds.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/files/number_text.h"

#include <cmath>

namespace vitrine::scenes {
namespace {

using render::Json;

/// Returns the value in the unit of files, without the rounding error of the conversion from SI.
double rounded(double si, Unit unit)
{
    const double x = shown(si, unit);
    const double scale = std::pow(10, 9 - std::ceil(std::log10(std::abs(x) + 1)));
    return std::round(x * scale) / scale;
}

Json numberSchema(const Field& field)
{
    if (field.type == FieldType::count || field.type == FieldType::counts)
        return {
            {"anyOf", {{{"type", "integer"}, {"minimum", field.low}, {"maximum", field.high}}, {{"type", "string"}}}}};
    return {{"anyOf",
             {{{"type", "number"},
               {"minimum", rounded(field.low, field.unit)},
               {"maximum", rounded(field.high, field.unit)}},
              {{"type", "string"}}}}};
}

Json threeSchema(const Field& field)
{
    return {{"type", "array"}, {"items", numberSchema(field)}, {"minItems", 3}, {"maxItems", 3}};
}

Json fieldSchema(const Field& field)
{
    Json schema;
    Json initial = rounded(field.initial[0], field.unit);
    switch (field.type) {
    case FieldType::toggle:
        schema = {{"type", "boolean"}};
        initial = field.initial[0] != 0;
        break;
    case FieldType::choice:
        schema["enum"] = Json(field.choices);
        initial = std::string(field.choices[static_cast<std::size_t>(field.initial[0])]);
        break;
    case FieldType::real:
    case FieldType::count: schema = numberSchema(field); break;
    case FieldType::vector:
    case FieldType::counts:
    case FieldType::direction: schema = threeSchema(field); break;
    case FieldType::sizes: schema = {{"anyOf", {threeSchema(field), numberSchema(field)}}}; break;
    }
    if (numbersOf(field.type) == 3) {
        initial = Json::array();
        for (const double x : field.initial) initial.push_back(rounded(x, field.unit));
    }
    const std::string_view symbol = info(field.unit).symbol;
    schema["description"] = std::string(field.help) + (symbol.empty() ? "" : " Unit: " + std::string(symbol) + '.');
    schema["default"] = initial;
    return schema;
}

Json textSchema(const char* description)
{
    return {{"type", "string"}, {"description", description}};
}

Json reference(const std::string& name)
{
    return {{"$ref", "#/$defs/" + name}};
}

/// Returns the schema of an object with exactly these keys.
Json objectSchema(Json properties, Json required, std::string_view description)
{
    Json schema = {
        {"type", "object"}, {"description", std::string(description)}, {"properties", std::move(properties)}};
    if (!required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    return schema;
}

/// Returns the schema of one of several kinds, selected by the word under a key.
Json byKind(const std::string& key, const Json& words, const std::string& prefix)
{
    Json cases = Json::array();
    for (const Json& word : words)
        cases.push_back({{"if", {{"properties", {{key, {{"const", word}}}}}, {"required", {key}}}},
                         {"then", reference(prefix + word.get<std::string>())}});
    return {{"type", "object"}, {"properties", {{key, {{"enum", words}}}}}, {"required", {key}}, {"allOf", cases}};
}

constexpr const char* commonOfNodes[] = {"name", "about", "material", "hidden", "translate", "rotate", "scale"};

/// Adds the members that every node may have.
void addCommon(Json& definitions)
{
    definitions["common.name"] = textSchema("Name to display.");
    definitions["common.about"] = textSchema("Description to display.");
    definitions["common.material"] = textSchema("Name of an entry under \"materials\"; by default that of the parent.");
    definitions["common.hidden"] = {
        {"type", "boolean"}, {"description", "Whether the node is left out."}, {"default", false}};
    for (const Field& field : placeFields()) definitions["common." + std::string(field.name)] = fieldSchema(field);
}

Json nodeProperties(const std::string& kind)
{
    Json properties = {{"kind", {{"const", kind}}}};
    for (const std::string name : commonOfNodes) properties[name] = reference("common." + name);
    return properties;
}

void addNodes(Json& definitions)
{
    Json words = Json::array();
    for (const NodeKind& kind : nodeKinds()) {
        const std::string name(kind.name);
        words.push_back(name);
        Json properties = nodeProperties(name);
        Json required = {"kind"};
        for (const Field& field : kind.fields) properties[std::string(field.name)] = fieldSchema(field);
        if (kind.form == Form::modifier || kind.form == Form::repeater) {
            properties["child"] = reference("node");
            required.push_back("child");
        } else if (kind.form != Form::shape) {
            Json children = {
                {"type", "array"}, {"items", reference("node")}, {"minItems", kind.form == Form::pair ? 2 : 1}};
            if (kind.form == Form::pair) children["maxItems"] = 2;
            properties["children"] = std::move(children);
            required.push_back("children");
        }
        definitions["node." + name] = objectSchema(std::move(properties), std::move(required), kind.help);
    }
    Json instance = nodeProperties("instance");
    instance["of"] = textSchema("Name of an entry under \"nodes\".");
    definitions["node.instance"] = objectSchema(std::move(instance), {"kind", "of"}, "Copy of a node under \"nodes\".");
    Json include = nodeProperties("include");
    include["file"] = textSchema("Path of a scene file in this folder or below it.");
    definitions["node.include"] = objectSchema(std::move(include), {"kind", "file"}, "Root node of another scene.");
    words.push_back("instance");
    words.push_back("include");
    definitions["node"] = byKind("kind", words, "node.");
}

void addRecords(Json& definitions, const std::string& name, const RecordTable& table)
{
    Json words = Json::array();
    const std::string key(table.key);
    for (const RecordKind& kind : table.kinds) {
        Json properties = Json::object();
        Json required = Json::array();
        if (!key.empty()) {
            properties[key] = {{"const", std::string(kind.name)}};
            required.push_back(key);
        }
        for (const Field& field : kind.fields) properties[std::string(field.name)] = fieldSchema(field);
        for (const std::string_view file : kind.files) {
            properties[std::string(file)] = textSchema("Path of a picture in this folder or below it.");
            required.push_back(std::string(file));
        }
        words.push_back(std::string(kind.name));
        const std::string own = key.empty() ? name : name + '.' + std::string(kind.name);
        definitions[own] = objectSchema(std::move(properties), std::move(required), kind.help);
    }
    if (!key.empty()) definitions[name] = byKind(key, words, name + '.');
}

}  // namespace

Json sceneSchema()
{
    const Json plainNumber = {
        {"anyOf", {{{"type", "number"}, {"minimum", -1e6}, {"maximum", 1e6}}, {{"type", "string"}}}}};
    Json definitions = Json::object();
    definitions["parameter"] =
        objectSchema({{"value", plainNumber},
                      {"unit", {{"enum", {"", "m", "cm", "mm", "deg", "s", "Hz", "%"}}}},
                      {"range", {{"type", "array"}, {"items", plainNumber}, {"minItems", 2}, {"maxItems", 2}}},
                      {"help", textSchema("Help text of one sentence.")}},
                     {"value"}, "Parameter that expressions can name; shown as a slider.");
    addRecords(definitions, "material", materialTable());
    addRecords(definitions, "light", lightTable());
    addRecords(definitions, "environment", environmentTable());
    addRecords(definitions, "camera", cameraTable());
    addRecords(definitions, "look", lookTable());
    addCommon(definitions);
    addNodes(definitions);

    const auto named = [](const char* what) {
        return Json{{"type", "object"}, {"additionalProperties", reference(what)}};
    };
    Json schema = objectSchema(
        {{"$schema", {{"type", "string"}}},
         {"format", {{"const", sceneFormat}}},
         {"version", {{"const", sceneVersion}}},
         {"name", textSchema("Name to display.")},
         {"about", textSchema("Description to display.")},
         {"parameters", named("parameter")},
         {"materials", named("material")},
         {"lights", {{"type", "array"}, {"items", reference("light")}, {"maxItems", 16}}},
         {"environment", reference("environment")},
         {"camera", reference("camera")},
         {"look", reference("look")},
         {"nodes", named("node")},
         {"root", reference("node")}},
        {"format", "version", "root"},
        "A scene of shapes. A number may be an expression of t, the time in seconds, and of the parameters.");
    Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Vitrine scene"}};
    whole.update(schema);
    whole["$defs"] = std::move(definitions);
    return whole;
}

}  // namespace vitrine::scenes
