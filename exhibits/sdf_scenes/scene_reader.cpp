#include "exhibits/sdf_scenes/scene_reader.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/parameters.h"
#include "exhibits/sdf_scenes/scene_program.h"
#include "exhibits/sdf_scenes/source_scene.h"
#include "exhibits/sdf_scenes/tree_reader.h"
#include "render/files/read_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace vitrine::scenes {
namespace {

using JsonType = render::JsonSpan::Type;

struct ParameterUnit {
    std::string_view word;
    Unit unit;
};
constexpr std::array<ParameterUnit, 8> parameterUnits = {{{"", Unit::none},
                                                          {"m", Unit::meter},
                                                          {"cm", Unit::centimeter},
                                                          {"mm", Unit::millimeter},
                                                          {"deg", Unit::degree},
                                                          {"s", Unit::second},
                                                          {"Hz", Unit::hertz},
                                                          {"%", Unit::percent}}};

/// Reads all parts of a scene into a scene that it owns.
class SceneReader {
public:
    /// `without`: shapes of a scene of the reference that are left out.
    SceneReader(const IncludedText& included, const SceneLimits& limits, const std::set<std::uint32_t>& without)
        : included_(included), limits_(limits), without_(without), findings_(limits.findings),
          fields_(scene_, findings_)
    {
    }

    ReadScene read(std::string text, const std::string& name, std::vector<Finding> leftOut)
    {
        scene_.leftOut = std::move(leftOut);
        if (const auto file = openText(std::move(text), name)) {
            scene_.materials.push_back(
                {&materialTable().kinds.back(), "", fields_.initialFields(materialTable().kinds.back().fields)});
            addFile(file, "");
            readRecords();
            TreeReader(
                scene_, findings_, names_,
                [this](std::uint32_t from, std::uint32_t value, const std::string& path) {
                    return include(from, value, path);
                },
                limits_)
                .read();
        }
        if (!findings_.empty()) return refused();
        auto whole = std::make_shared<const Scene>(std::move(scene_));
        checkRepeaters(whole);
        if (!findings_.empty()) return refused();
        return {whole, {}};
    }

    /// Valid after reading: the shapes that all findings are about, as values of the converted text; empty if any
    /// finding is about something else.
    [[nodiscard]] const std::vector<std::uint32_t>& faultyShapes() const { return faulty_; }

private:
    ReadScene refused()
    {
        faulty_ = findings_.shapes();
        return {nullptr, findings_.take()};
    }
    std::shared_ptr<const render::JsonText> openText(std::string text, const std::string& name);
    std::uint32_t addFile(std::shared_ptr<const render::JsonText>, const std::string& path);
    std::optional<std::uint32_t> include(std::uint32_t from, std::uint32_t value, const std::string& path);
    void readHead(std::uint32_t file);
    void readParameters(std::uint32_t file, std::uint32_t object);
    SceneParameter readParameter(std::uint32_t file, std::uint32_t object);
    void readMaterials(std::uint32_t file, std::uint32_t object);
    void readRecords();
    Record readRecord(std::uint32_t file, std::uint32_t object, const RecordTable&, const std::string& what);
    Record initialRecord(const RecordTable& table)
    {
        return {&table.kinds.front(), "", fields_.initialFields(table.kinds.front().fields)};
    }
    void checkCamera(std::uint32_t value);
    void checkRepeaters(const std::shared_ptr<const Scene>&);
    bool isObject(std::uint32_t file, std::uint32_t value, const char* what);

    const IncludedText& included_;
    const SceneLimits& limits_;
    const std::set<std::uint32_t>& without_;
    Scene scene_;
    Findings findings_;
    std::vector<std::uint32_t> faulty_;
    FieldReader fields_;
    std::vector<FileNames> names_;
    std::vector<std::string> paths_;                  ///< Path of each file, relative to the scene's folder.
    std::shared_ptr<const render::JsonText> source_;  ///< Text that the first file was converted from.
};

std::shared_ptr<const render::JsonText> SceneReader::openText(std::string text, const std::string& name)
{
    try {
        auto json = std::make_shared<const render::JsonText>(std::move(text), name, limits_.json);
        if (!scene_.files.empty() || !isSourceScene(*json)) return json;
        const std::optional<ConvertedScene> converted = convertSourceScene(*json, findings_, without_);
        if (!converted) return nullptr;
        source_ = json;
        auto made = std::make_shared<const render::JsonText>(converted->text, name, limits_.json);
        findings_.translate(*made, *json, converted->parts);
        return made;
    } catch (const render::JsonFailure& failure) {
        findings_.add(failure);
        return nullptr;
    }
}

bool SceneReader::isObject(std::uint32_t file, std::uint32_t value, const char* what)
{
    const render::JsonText& json = *scene_.files[file].text;
    if (json.value(value).type == JsonType::object) return true;
    findings_.add(json, value, std::string(what) + " must be an object: { ... }");
    return false;
}

std::uint32_t SceneReader::addFile(std::shared_ptr<const render::JsonText> text, const std::string& path)
{
    const auto file = static_cast<std::uint32_t>(scene_.files.size());
    scene_.files.push_back({std::move(text), {}});
    names_.emplace_back();
    paths_.push_back(path);
    readHead(file);
    return file;
}

std::optional<std::uint32_t> SceneReader::include(std::uint32_t from, std::uint32_t value, const std::string& reference)
{
    const render::JsonText& json = *scene_.files[from].text;
    if (const std::string why = render::whyRefused(reference).english(); !why.empty()) {
        findings_.add(json, value, "this file is not opened: " + why + "; name one of the scene's folder or below it");
        return std::nullopt;
    }
    const std::string& here = paths_[from];
    const std::size_t slash = here.rfind('/');
    const std::string path = (slash == std::string::npos ? "" : here.substr(0, slash + 1)) + reference;
    if (const auto known = std::find(paths_.begin(), paths_.end(), path); known != paths_.end())
        return static_cast<std::uint32_t>(known - paths_.begin());
    if (scene_.files.size() >= limits_.files) {
        findings_.add(json, value,
                      "the scene includes more than " + std::to_string(limits_.files) + " files; join some");
        return std::nullopt;
    }
    try {
        if (const auto text = openText(included_(path), path)) return addFile(text, path);
    } catch (const Failure& failure) {
        std::string why = failure.what();
        if (why.ends_with('.')) why.pop_back();
        findings_.add(json, value, why);
    }
    return std::nullopt;
}

/// Reads the members of a file besides its tree, some of which only the scene's own file may have.
void SceneReader::readHead(std::uint32_t file)
{
    const render::JsonText& json = *scene_.files[file].text;
    if (!isObject(file, 0, "a scene")) return;
    static_cast<void>(fields_.readObject(file, 0, {},
                                         {"$schema", "format", "version", "name", "about", "parameters", "materials",
                                          "lights", "environment", "camera", "look", "nodes", "root"},
                                         "a scene"));
    const auto format = json.member(0, "format");
    if (!format || json.written(*format) != '"' + std::string(sceneFormat) + '"')
        findings_.add(json, format.value_or(0),
                      std::string("this is not a scene; a scene begins with \"format\": \"") + sceneFormat + '"');
    const auto version = json.member(0, "version");
    if (!version || json.written(*version) != std::to_string(sceneVersion))
        findings_.add(json, version.value_or(0),
                      "this version is not known; give \"version\": " + std::to_string(sceneVersion));
    for (const char* key : {"name", "about", "$schema"})
        if (const auto value = json.member(0, key)) {
            const std::string words = fields_.readString(file, *value);
            if (file == 0 && key == std::string_view("name")) scene_.name = words;
            if (file == 0 && key == std::string_view("about")) scene_.about = words;
        }
    if (const auto value = json.member(0, "parameters")) readParameters(file, *value);
    if (const auto value = json.member(0, "materials")) readMaterials(file, *value);
    if (const auto value = json.member(0, "nodes"); value && isObject(file, *value, "\"nodes\""))
        for (const std::uint32_t node : json.children(*value)) names_[file].definitions[json.key(node)] = node;
    if (const auto value = json.member(0, "root"))
        names_[file].root = *value;
    else
        findings_.add(json, 0, "this scene has no \"root\"; it is the node that is drawn");
}

void SceneReader::readParameters(std::uint32_t file, std::uint32_t object)
{
    if (!isObject(file, object, "\"parameters\"")) return;
    const render::JsonText& json = *scene_.files[file].text;
    for (const std::uint32_t value : json.children(object)) {
        SceneParameter parameter = readParameter(file, value);
        parameter.name = json.key(value);
        if (!isParameterName(parameter.name))
            findings_.add(json, value, "a parameter's name has letters and digits, a letter first");
        else if (parameter.name == "t" || isExpressionWord(parameter.name))
            findings_.add(json, value, "this name is taken: expressions know it already; choose another");
        scene_.files[file].parameters.push_back(std::move(parameter));
    }
}

SceneParameter SceneReader::readParameter(std::uint32_t file, std::uint32_t object)
{
    SceneParameter parameter;
    if (!isObject(file, object, "a parameter")) return parameter;
    const render::JsonText& json = *scene_.files[file].text;
    static_cast<void>(fields_.readObject(file, object, {}, {"value", "unit", "range", "help"}, "a parameter"));
    if (const auto unit = json.member(object, "unit")) {
        const std::string word = fields_.readString(file, *unit);
        const auto found = std::find_if(parameterUnits.begin(), parameterUnits.end(),
                                        [&](const ParameterUnit& u) { return u.word == word; });
        if (found != parameterUnits.end())
            parameter.unit = found->unit;
        else
            findings_.add(json, *unit, unknownWord(word, "unit", {"m", "cm", "mm", "deg", "s", "Hz", "%"}));
    }
    if (const auto help = json.member(object, "help")) parameter.help = fields_.readString(file, *help);
    const auto numberAt = [&](std::uint32_t value, double low, double high) {
        const Field any{"", FieldType::real, parameter.unit, low, high};
        const std::uint32_t at = fields_.readField(file, value, any);
        const Number number = scene_.numbers[at];
        if (number.expression != noIndex)
            findings_.add(json, value, "a parameter cannot depend on others; give a number");
        return number.value;
    };
    constexpr double most = 1e6;
    if (const auto range = json.member(object, "range")) {
        const bool isPair = json.value(*range).type == JsonType::array && json.children(*range).size() == 2;
        if (isPair) {
            parameter.low = numberAt(json.children(*range)[0], -most, most);
            parameter.high = numberAt(json.children(*range)[1], -most, most);
        }
        if (!isPair || !(parameter.low < parameter.high))
            findings_.add(json, *range, "a range is two numbers, the lower one first: [0, 1]");
    }
    parameter.initial = parameter.low;
    if (const auto value = json.member(object, "value"))
        parameter.initial = numberAt(*value, parameter.low, parameter.high);
    else
        findings_.add(json, object, "this parameter has no \"value\"; give the one it has at first");
    return parameter;
}

Record SceneReader::readRecord(std::uint32_t file, std::uint32_t object, const RecordTable& table,
                               const std::string& what)
{
    Record record;
    record.kind = &table.kinds.front();
    const render::JsonText& json = *scene_.files[file].text;
    std::vector<std::string_view> others;
    if (!isObject(file, object, what.c_str())) return record;
    if (!table.key.empty()) {
        others.push_back(table.key);
        const auto value = json.member(object, table.key);
        const std::string word = value ? fields_.readString(file, *value) : std::string();
        const auto found =
            std::find_if(table.kinds.begin(), table.kinds.end(), [&](const RecordKind& k) { return k.name == word; });
        if (found == table.kinds.end()) {
            std::vector<std::string> known;
            for (const RecordKind& kind : table.kinds) known.emplace_back(kind.name);
            const std::string key(table.key);
            findings_.add(json, value.value_or(object),
                          value ? unknownWord(word, key + " of " + what, known)
                                : what + " needs a \"" + key + "\": " + listed(known));
            return record;
        }
        record.kind = &*found;
    }
    others.insert(others.end(), record.kind->files.begin(), record.kind->files.end());
    record.numbers = fields_.readObject(file, object, record.kind->fields, others, what);
    for (const std::string_view key : record.kind->files) {
        const auto value = json.member(object, key);
        if (!value) {
            findings_.add(json, object, what + " needs a \"" + std::string(key) + "\": the name of a picture");
            continue;
        }
        record.files.push_back(fields_.readString(file, *value));
        if (const std::string why = render::whyRefused(record.files.back()).english(); !why.empty())
            findings_.add(json, *value,
                          "this file is not opened: " + why + "; name one of the scene's folder or below it");
    }
    return record;
}

void SceneReader::readMaterials(std::uint32_t file, std::uint32_t object)
{
    if (!isObject(file, object, "\"materials\"")) return;
    const render::JsonText& json = *scene_.files[file].text;
    for (const std::uint32_t value : json.children(object)) {
        Record material = readRecord(file, value, materialTable(), "a material");
        material.name = json.key(value);
        names_[file].materials[material.name] = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materials.push_back(std::move(material));
    }
}

void SceneReader::readRecords()
{
    const render::JsonText& json = *scene_.files.front().text;
    const auto recordAt = [&](const char* key, const RecordTable& table, const std::string& what) {
        const auto value = json.member(0, key);
        return value ? readRecord(0, *value, table, what) : initialRecord(table);
    };
    scene_.environment = recordAt("environment", environmentTable(), "an environment");
    scene_.camera = recordAt("camera", cameraTable(), "a camera");
    scene_.hasCamera = json.member(0, "camera").has_value();
    scene_.look = recordAt("look", lookTable(), "a look");
    if (const auto camera = json.member(0, "camera"); camera && findings_.empty()) checkCamera(*camera);
    const auto lights = json.member(0, "lights");
    if (!lights) return;
    if (json.value(*lights).type != JsonType::array) {
        findings_.add(json, *lights, "\"lights\" must be an array: [ ... ]");
        return;
    }
    constexpr std::size_t mostLights = 16;
    if (json.children(*lights).size() > mostLights)
        findings_.add(json, *lights, "there are more than 16 lights; leave some out");
    for (const std::uint32_t light : json.children(*lights)) {
        if (findings_.full()) return;
        scene_.lights.push_back(readRecord(0, light, lightTable(), "a light"));
    }
}

void SceneReader::checkCamera(std::uint32_t value)
{
    const render::JsonText& json = *scene_.files.front().text;
    const auto at = [&](std::size_t i) {
        const std::uint32_t first = scene_.camera.numbers + static_cast<std::uint32_t>(3 * i);
        return glm::dvec3(scene_.numbers[first].value, scene_.numbers[first + 1].value,
                          scene_.numbers[first + 2].value);
    };
    const glm::dvec3 ahead = at(1) - at(0);
    if (!(glm::length(ahead) > 1e-6))
        findings_.add(json, value, "position and target are the same point; move one of them");
    else if (glm::length(glm::cross(glm::normalize(ahead), glm::normalize(at(2)))) < 1e-6)
        findings_.add(json, value, "\"up\" points along the view; give another direction");
}

/// Reports repeaters of children that are infinite along the repetition, or so large that too many copies would be
/// evaluated.
void SceneReader::checkRepeaters(const std::shared_ptr<const Scene>& scene)
{
    const SceneProgram program(scene);
    const SceneConstants words = program.words(scene->numbersAt(0));
    for (std::uint32_t i = 0; i < program.nodes().size(); ++i) {
        if (words.asked[i] <= mostCopiesAsked) continue;
        const Node& node = scene->nodes[program.nodes()[i].node];
        findings_.add(
            *scene->files[node.origin.file].text, node.origin.value,
            "the child is so wide that " + sentenceNumber(words.asked[i]) +
                " copies would be evaluated at every point; make it smaller or its copies fewer or farther apart");
    }
}

}  // namespace

ReadScene readScene(const std::string& text, const std::string& name, const IncludedText& included,
                    const SceneLimits& limits)
{
    std::set<std::uint32_t> without;
    std::vector<Finding> leftOut;
    std::optional<ReadScene> first;
    // Each round leaves out at least one more shape.
    for (;;) {
        SceneReader reader(included, limits, without);
        ReadScene read = reader.read(text, name, leftOut);
        const std::vector<std::uint32_t>& faulty = reader.faultyShapes();
        if (read.scene) return read;
        if (!first) first = read;
        if (faulty.empty()) return *first;
        without.insert(faulty.begin(), faulty.end());
        leftOut.insert(leftOut.end(), read.findings.begin(), read.findings.end());
    }
}

ReadScene readSceneFile(const std::filesystem::path& path, const SceneLimits& limits)
{
    const auto included = [&](const std::string& reference) {
        return render::readFileBeneath(path.parent_path(), reference, limits.json.bytes);
    };
    try {
        return readScene(render::readFile(path, limits.json.bytes), path.string(), included, limits);
    } catch (const Failure& failure) {
        return {nullptr, {{path.string(), 1, 1, "", failure.what()}}, false};
    }
}

}  // namespace vitrine::scenes
