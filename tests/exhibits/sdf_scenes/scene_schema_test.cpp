// The published schema compared with the reader: both refuse the same wrong forms.

#include "tests/exhibits/sdf_scenes/scene_schema.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include "render/files/read_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vitrine {
namespace {

using render::Json;

/// Validates by the keywords of JSON Schema that the scene's schema uses.
bool fits(const Json& value, const Json& schema, const Json& whole);

bool fitsType(const Json& value, const std::string& type)
{
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number() && value.get<double>() == std::floor(value.get<double>());
    return value.is_number();
}

bool fitsObject(const Json& value, const Json& schema, const Json& whole)
{
    for (const Json& key : schema.value("required", Json::array()))
        if (!value.contains(key.get<std::string>())) return false;
    const Json& properties = schema.value("properties", Json::object());
    for (const auto& [key, member] : value.items()) {
        if (properties.contains(key)) {
            if (!fits(member, properties[key], whole)) return false;
        } else if (schema.contains("additionalProperties")) {
            const Json& further = schema["additionalProperties"];
            if (further.is_boolean() ? !further.get<bool>() : !fits(member, further, whole)) return false;
        }
    }
    return true;
}

bool fits(const Json& value, const Json& schema, const Json& whole)
{
    if (schema.contains("$ref")) {
        const std::string name = schema["$ref"].get<std::string>().substr(std::string("#/$defs/").size());
        if (!fits(value, whole["$defs"].at(name), whole)) return false;
    }
    if (schema.contains("type") && !fitsType(value, schema["type"])) return false;
    if (schema.contains("const") && value != schema["const"]) return false;
    if (schema.contains("enum")) {
        bool known = false;
        for (const Json& word : schema["enum"]) known = known || word == value;
        if (!known) return false;
    }
    if (value.is_number()) {
        if (schema.contains("minimum") && value.get<double>() < schema["minimum"].get<double>()) return false;
        if (schema.contains("maximum") && value.get<double>() > schema["maximum"].get<double>()) return false;
    }
    if (value.is_array()) {
        if (schema.contains("minItems") && value.size() < schema["minItems"].get<std::size_t>()) return false;
        if (schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>()) return false;
        if (schema.contains("items"))
            for (const Json& item : value)
                if (!fits(item, schema["items"], whole)) return false;
    }
    if (value.is_object() && !fitsObject(value, schema, whole)) return false;
    if (schema.contains("anyOf")) {
        bool any = false;
        for (const Json& choice : schema["anyOf"]) any = any || fits(value, choice, whole);
        if (!any) return false;
    }
    for (const Json& part : schema.value("allOf", Json::array())) {
        if (part.contains("if") && !fits(value, part["if"], whole)) continue;
        if (!fits(value, part.contains("then") ? part["then"] : part, whole)) return false;
    }
    return true;
}

bool schemaTakes(const std::string& text)
{
    static const Json schema = scenes::sceneSchema();
    return fits(Json::parse(text), schema, schema);
}

bool readerTakes(const std::string& text)
{
    return test::readText(text).scene != nullptr;
}

/// Returns the schema as text with a line for each described element.
std::string written(const Json& value, std::size_t depth = 0)
{
    std::string flat = value.dump();
    const bool hasParts =
        std::any_of(value.begin(), value.end(), [](const Json& part) { return part.is_object() && !part.empty(); });
    if (!value.is_object() || !hasParts || flat.size() <= 110) return flat;
    std::string text;
    for (const auto& [key, part] : value.items())
        text += (text.empty() ? "{\n" : ",\n") + std::string(2 * depth + 2, ' ') + Json(key).dump() + ": " +
                written(part, depth + 1);
    return text + '\n' + std::string(2 * depth, ' ') + '}';
}

TEST(SceneSchema, IsTheFileThatEditorsUse)
{
    const std::filesystem::path path = std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes/scene.schema.json";
    const std::string made = written(scenes::sceneSchema()) + '\n';
    const std::string there = std::filesystem::exists(path) ? render::readFile(path, 4U << 20U) : std::string();
    if (made == there) return;
    const std::filesystem::path beside = std::filesystem::temp_directory_path() / "scene.schema.json";
    std::ofstream(beside) << made;
    ADD_FAILURE() << path << " is not what the tables say; " << beside << " is";
}

TEST(SceneSchema, TakesEveryKindOfNodeThatTheReaderTakes)
{
    test::Random random(31);
    for (int i = 0; i < 1000; ++i) {
        const std::string text = test::sceneText(test::randomTree(random, 3));
        ASSERT_TRUE(schemaTakes(text)) << text;
    }
}

/// Returns values that are wrong in one way each, for a field.
std::vector<std::string> wrongValues(const scenes::Field& field)
{
    using scenes::FieldType;
    if (field.type == FieldType::toggle) return {"1", "\"true\"", "null"};
    if (field.type == FieldType::choice) return {"\"other\"", "0", "[]"};
    const std::string beyond = std::to_string(shown(field.high, field.unit) * 1.01 + 1);
    std::vector<std::string> wrong{"true", "null", "{}", "[1, 2]", "[1, 2, 3, 4]"};
    if (numbersOf(field.type) == 3) {
        wrong.push_back('[' + beyond + ", " + beyond + ", " + beyond + ']');
        wrong.emplace_back("[true, false, true]");
    } else {
        wrong.push_back(beyond);
        wrong.emplace_back("[1, 1, 1]");
    }
    if (field.type == FieldType::count) wrong.emplace_back("1.5");
    if (field.type == FieldType::vector || field.type == FieldType::direction) wrong.emplace_back("1");
    return wrong;
}

TEST(SceneSchema, RefusesWhatTheReaderRefusesByItsForm)
{
    test::Random random(32);
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        std::string children;
        if (kind.form == scenes::Form::modifier || kind.form == scenes::Form::repeater)
            children = R"(, "child": {"kind": "sphere"})";
        else if (kind.form != scenes::Form::shape)
            children = R"(, "children": [{"kind": "sphere"}, {"kind": "box"}])";
        const std::string start = "{\"kind\": \"" + std::string(kind.name) + '"';
        const std::string plain = test::sceneText(start + children + '}');
        EXPECT_TRUE(schemaTakes(plain)) << plain;
        EXPECT_TRUE(readerTakes(plain)) << plain << test::findingsText(test::readText(plain));
        std::vector<std::string> wrong{", \"raduis\": 1", ", \"name\": 7",  ", \"hidden\": 0",
                                       ", \"rotate\": 3", ", \"scale\": 0", ", \"translate\": [1, 2]"};
        for (const scenes::Field& field : kind.fields)
            for (const std::string& value : wrongValues(field))
                wrong.push_back(", \"" + std::string(field.name) + "\": " + value);
        for (const std::string& member : wrong) {
            const std::string text = test::sceneText(start + children + member + '}');
            EXPECT_FALSE(schemaTakes(text)) << text;
            EXPECT_FALSE(readerTakes(text)) << text;
        }
        if (children.empty()) continue;
        EXPECT_FALSE(schemaTakes(test::sceneText(start + '}')));
        EXPECT_FALSE(readerTakes(test::sceneText(start + '}')));
    }
}

TEST(SceneSchema, AgreesOnEverythingBesideTheNodes)
{
    const std::string ball = R"({"kind": "sphere"})";
    const char* const right[] = {
        R"("lights": [{"kind": "point"}, {"kind": "sun"}, {"kind": "area", "width": 2}],)",
        R"("environment": {"kind": "panorama", "file": "a.hdr", "rotation": 30},)",
        R"("environment": {"kind": "faces", "right": "a", "left": "b", "top": "c", "bottom": "d", "front": "e", "back": "f"},)",
        R"("camera": {"fieldOfView": "30 deg"}, "look": {"bounces": 4, "asInTheReference": true},)",
        R"("parameters": {"size": {"value": 1, "unit": "m", "range": [0, 2], "help": "Of it."}},)",
        R"("nodes": {"part": {"kind": "box"}}, "name": "A", "about": "B", "$schema": "c",)"};
    const char* const wrong[] = {R"("lights": {},)",
                                 R"("lights": [{"kind": "lamp"}],)",
                                 R"("lights": [{"position": [0, 1, 0]}],)",
                                 R"("environment": {"kind": "panorama"},)",
                                 R"("environment": {"kind": "sky", "file": "a.hdr"},)",
                                 R"("camera": {"fieldOfView": 0},)",
                                 R"("look": {"bounces": 5},)",
                                 R"("look": {"bounce": 1},)",
                                 R"("materials": {"a": {"model": "phong", "roughness": 1}},)",
                                 R"("materials": {"a": {"color": [1, 1, 1]}},)",
                                 R"("materials": [],)",
                                 R"("parameters": {"size": {"unit": "m"}},)",
                                 R"("parameters": {"size": {"value": 1, "unit": "yard"}},)",
                                 R"("parameters": {"size": {"value": 1, "range": [1]}},)",
                                 R"("name": 3,)",
                                 R"("nodes": [],)",
                                 R"("node": {},)"};
    for (const char* head : right) {
        EXPECT_TRUE(schemaTakes(test::sceneText(ball, head))) << head;
        EXPECT_TRUE(readerTakes(test::sceneText(ball, head)))
            << head << test::findingsText(test::readText(test::sceneText(ball, head)));
    }
    for (const char* head : wrong) {
        EXPECT_FALSE(schemaTakes(test::sceneText(ball, head))) << head;
        EXPECT_FALSE(readerTakes(test::sceneText(ball, head))) << head;
    }
}

}  // namespace
}  // namespace vitrine
