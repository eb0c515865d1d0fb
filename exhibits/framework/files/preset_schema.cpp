#include "exhibits/framework/files/preset_schema.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/table/value_schema.h"

#include <string>

namespace vitrine {
namespace preset_schema {
namespace {

using render::Json;

Json numbers(int count)
{
    return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", count}, {"maxItems", count}};
}

Json cameraSchema()
{
    Json eye = numbers(3), target = numbers(3), shift = numbers(2);
    eye["description"] = "Position in meters.";
    target["description"] = "Point that it looks at, in meters.";
    shift["description"] = "Shift of the picture to the right and up, in half widths and half heights.";
    const Json fov{{"type", "number"}, {"exclusiveMinimum", 0}, {"description", "Vertical field of view in radians."}};
    return {{"type", "object"}, {"properties", {{"eye", eye}, {"target", target}, {"fov", fov}, {"lensShift", shift}}}};
}

Json tagsSchema()
{
    return {{"type", "array"},
            {"items", {{"type", "string"}, {"minLength", 1}, {"maxLength", mostPresetTagBytes}}},
            {"maxItems", mostPresetTags},
            {"uniqueItems", true}};
}

/// Adds the parameters of a subject to a schema's properties, each with its initial value.
void addValues(Json& properties, const std::string& before, const ParameterValues& initial)
{
    for (std::size_t i = 0; i < initial.rows().size(); ++i) {
        const ParameterInfo& parameter = initial.rows()[i];
        Json schema = valueSchema(parameter);
        describe(schema, parameter);
        schema["default"] = jsonFromValue(parameter, initial.row(i));
        properties[before + std::string(parameter.name)] = std::move(schema);
    }
}

/// Returns the schema of a file of a format, with these values.
Json fileSchema(const char* format, const std::string& title, Json values, Json exhibit)
{
    const Json text{{"type", "string"}};
    Json properties{{"format", {{"const", format}}},
                    {"version", {{"const", presetVersion}}},
                    {"app", text},
                    {"exhibit", std::move(exhibit)},
                    {"name", text},
                    {"tags", tagsSchema()},
                    {"values", {{"type", "object"}, {"properties", std::move(values)}}},
                    {"motions", {{"type", "object"}, {"additionalProperties", {{"type", "object"}}}}},
                    {"camera", cameraSchema()}};
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", title},
            {"type", "object"},
            {"properties", std::move(properties)},
            {"required", {"format", "version", "values"}}};
}

}  // namespace
}  // namespace preset_schema

render::Json presetSchema(std::string_view exhibit, const ParameterValues& initial)
{
    render::Json values = render::Json::object();
    preset_schema::addValues(values, {}, initial);
    const std::string name(exhibit);
    return preset_schema::fileSchema("vitrine-preset", "Preset of " + name, std::move(values), {{"const", name}});
}

render::Json exhibitionSchema(const NamedValues& initial)
{
    render::Json values = render::Json::object();
    for (const auto& [name, of] : initial) preset_schema::addValues(values, name + '.', of);
    return preset_schema::fileSchema("vitrine-exhibition", "Settings of the museum", std::move(values),
                                     {{"type", "string"}});
}

}  // namespace vitrine
