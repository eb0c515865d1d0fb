#include "exhibits/sdf_scenes/source_scene.h"

#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/source_shapes.h"

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {
namespace {

using render::Json;
using JsonType = render::JsonSpan::Type;

/// Key of a list of combinations, and the corresponding operation.
constexpr std::pair<std::string_view, const char*> combinations[] = {
    {"intersections", "intersection"}, {"unions", "union"}, {"subtractions", "subtraction"}};

/// Returns a sky with the colors of one of the three cube maps.
Json skyOf(const std::string& cubemap)
{
    if (cubemap == "lycksele")
        return {{"kind", "sky"},
                {"zenith", {0.3, 0.5, 0.85}},
                {"horizon", {0.75, 0.8, 0.85}},
                {"ground", {0.2, 0.25, 0.15}}};
    if (cubemap == "yokohama")
        return {{"kind", "sky"},
                {"zenith", {0.05, 0.08, 0.2}},
                {"horizon", {0.5, 0.4, 0.45}},
                {"ground", {0.1, 0.1, 0.15}}};
    if (cubemap == "interstellar")
        return {{"kind", "sky"},
                {"zenith", {0.02, 0.02, 0.06}},
                {"horizon", {0.15, 0.08, 0.2}},
                {"ground", {0.02, 0.02, 0.04}}};
    return {{"kind", "sky"}, {"zenith", {0, 0, 0}}, {"horizon", {0, 0, 0}}, {"ground", {0, 0, 0}}};
}

class SourceReader {
public:
    SourceReader(const render::JsonText& json, Findings& findings, const std::set<std::uint32_t>& without)
        : json_(json), findings_(findings), without_(without)
    {
    }

    std::optional<ConvertedScene> convert();

private:
    bool isType(std::uint32_t value, JsonType type, const char* what);
    std::vector<std::uint32_t> list(std::uint32_t object, std::string_view key);
    SourceNumbers numbers(std::uint32_t object, const std::vector<SourceKey>& keys,
                          std::vector<std::string_view> others, const std::string& what);
    std::string word(std::uint32_t object, std::string_view key);
    void readCamera();
    void readMaterials();
    void readShapes();
    void readCombinations(std::string_view key, const char* operation);
    void readNoise();
    void addShape(std::uint32_t value, const SourceKind&, std::vector<std::string_view> others, Json& into,
                  const std::string& path);
    void addMaterial(std::uint32_t value, Json& node);

    const render::JsonText& json_;
    Findings& findings_;
    const std::set<std::uint32_t>& without_;
    Json scene_;
    Json children_ = Json::array();
    std::vector<MadeFrom> parts_;
    std::vector<std::string> materials_;
    glm::dvec3 eye_{0};
};

bool SourceReader::isType(std::uint32_t value, JsonType type, const char* what)
{
    if (json_.value(value).type == type) return true;
    findings_.add(json_, value, std::string("this must be ") + what);
    return false;
}

/// Returns the elements of an array; empty if it is missing.
std::vector<std::uint32_t> SourceReader::list(std::uint32_t object, std::string_view key)
{
    const std::optional<std::uint32_t> value = json_.member(object, key);
    if (!value || !isType(*value, JsonType::array, "an array: [ ... ]")) return {};
    return json_.children(*value);
}

std::string SourceReader::word(std::uint32_t object, std::string_view key)
{
    const std::optional<std::uint32_t> value = json_.member(object, key);
    return value && isType(*value, JsonType::string, "a text in quotes") ? json_.string(*value) : std::string();
}

SourceNumbers SourceReader::numbers(std::uint32_t object, const std::vector<SourceKey>& keys,
                                    std::vector<std::string_view> others, const std::string& what)
{
    SourceNumbers found;
    for (const SourceKey& key : keys) found[std::string(key.name)] = {};
    if (!isType(object, JsonType::object, "an object: { ... }")) return found;
    std::vector<std::string> known(others.begin(), others.end());
    for (const SourceKey& key : keys) {
        known.emplace_back(key.name);
        const std::optional<std::uint32_t> value = json_.member(object, key.name);
        if (!value) {
            if (key.needed) findings_.add(json_, object, what + " needs a \"" + std::string(key.name) + '"');
            continue;
        }
        const bool isArray = json_.value(*value).type == JsonType::array;
        const std::vector<std::uint32_t> parts = isArray ? json_.children(*value) : std::vector<std::uint32_t>{*value};
        if (parts.size() != static_cast<std::size_t>(key.numbers) || isArray != (key.numbers > 1)) {
            findings_.add(json_, *value,
                          "this must be " + (key.numbers > 1 ? "an array of " + std::to_string(key.numbers) + " numbers"
                                                             : std::string("a number")));
            continue;
        }
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (isType(parts[i], JsonType::number, "a number"))
                found[std::string(key.name)][i] = json_.number(parts[i]);
    }
    for (const std::uint32_t child : json_.children(object))
        if (const std::string key = json_.key(child); std::find(known.begin(), known.end(), key) == known.end())
            findings_.add(json_, child, unknownWord(key, "key of " + what, known));
    return found;
}

void SourceReader::readCamera()
{
    const std::optional<std::uint32_t> camera = json_.member(0, "camera");
    if (!camera) {
        findings_.add(json_, 0, "a scene of the reference needs a \"camera\"");
        return;
    }
    const SourceNumbers n = numbers(*camera, {{"position", 3}, {"target", 3}, {"up", 3}, {"fov"}}, {}, "a camera");
    const auto arrayOf = [&](const char* key) { return Json(n.find(std::string_view(key))->second); };
    // The reference's pictures are square, so its horizontal angle is the vertical one.
    scene_["camera"] = {{"position", arrayOf("position")},
                        {"target", arrayOf("target")},
                        {"up", arrayOf("up")},
                        {"fieldOfView", n.find("fov")->second[0]}};
    parts_.push_back({"camera", *camera});
    const std::array<double, 3>& eye = n.find("position")->second;
    eye_ = {eye[0], eye[1], eye[2]};
}

void SourceReader::readMaterials()
{
    Json materials = Json::object();
    for (const std::uint32_t value : list(0, "materials")) {
        const SourceNumbers n =
            numbers(value, {{"color", 3}, {"ambient"}, {"diffuse"}, {"specular"}, {"shininess"}, {"mirror"}}, {"name"},
                    "a material");
        const std::string name = word(value, "name");
        const auto number = [&](const char* key) { return n.find(std::string_view(key))->second[0]; };
        materials[name] = {{"model", "phong"},
                           {"color", n.find("color")->second},
                           {"ambient", number("ambient")},
                           {"diffuse", number("diffuse")},
                           {"specular", number("specular")},
                           {"shininess", std::max(number("shininess"), 1.0)},  // 0 would mean no highlight.
                           {"mirror", number("mirror")}};
        parts_.push_back({"materials." + name, value});
        materials_.push_back(name);
    }
    if (!materials.empty()) scene_["materials"] = std::move(materials);
    Json lights = Json::array();
    for (const std::uint32_t value : list(0, "lights")) {
        const SourceNumbers n = numbers(value, {{"position", 3}, {"color", 3}}, {}, "a light");
        parts_.push_back({"lights[" + std::to_string(lights.size()) + ']', value});
        lights.push_back(
            {{"kind", "point"}, {"position", n.find("position")->second}, {"color", n.find("color")->second}});
    }
    if (!lights.empty()) scene_["lights"] = std::move(lights);
}

void SourceReader::addMaterial(std::uint32_t value, Json& node)
{
    const std::string material = word(value, "material");
    if (material.empty()) return;
    if (std::find(materials_.begin(), materials_.end(), material) == materials_.end())
        findings_.add(json_, *json_.member(value, "material"), unknownWord(material, "material", materials_));
    node["material"] = material;
}

void SourceReader::addShape(std::uint32_t value, const SourceKind& kind, std::vector<std::string_view> others,
                            Json& into, const std::string& path)
{
    if (without_.contains(value)) return;
    const std::size_t before = findings_.count();
    const SourceNumbers n = numbers(value, kind.keys, std::move(others), "a " + std::string(kind.type));
    if (findings_.count() != before) return;
    try {
        Json node = kind.node(n, eye_);
        addMaterial(value, node);
        parts_.push_back({path + '[' + std::to_string(into.size()) + ']', value, true});
        into.push_back(std::move(node));
    } catch (const std::string& fault) {
        findings_.addOfShape(json_, value, fault);
    }
}

void SourceReader::readShapes()
{
    const std::optional<std::uint32_t> primitives = json_.member(0, "primitives");
    if (!primitives || !isType(*primitives, JsonType::object, "an object: { ... }")) return;
    std::vector<std::string> known;
    for (const SourceKind& kind : sourceKinds()) {
        known.emplace_back(kind.list);
        for (const std::uint32_t value : list(*primitives, kind.list))
            addShape(value, kind, {"material"}, children_, "root.children");
    }
    for (const std::uint32_t child : json_.children(*primitives))
        if (const std::string key = json_.key(child); std::find(known.begin(), known.end(), key) == known.end())
            findings_.add(json_, child, unknownWord(key, "list of primitives", known));
}

void SourceReader::readCombinations(std::string_view key, const char* operation)
{
    for (const std::uint32_t value : list(0, key)) {
        const SourceNumbers n = numbers(value, {{"smooth_factor", 1, false}}, {"material", "shapes"}, "a combination");
        const std::vector<std::uint32_t> shapes = list(value, "shapes");
        if (shapes.size() != 2) {
            findings_.add(json_, value, "a combination needs two \"shapes\"");
            continue;
        }
        const std::string path = "root.children[" + std::to_string(children_.size()) + ']';
        Json node = {{"kind", operation}, {"blend", "quadratic"}, {"blendWidth", n.find("smooth_factor")->second[0]}};
        addMaterial(value, node);
        Json both = Json::array();
        const bool hasFirst = !without_.contains(shapes[0]), hasSecond = !without_.contains(shapes[1]);
        // In the reference, the first one is subtracted from the second.
        const bool holds = operation == std::string_view("union")         ? hasFirst || hasSecond
                           : operation == std::string_view("subtraction") ? hasSecond
                                                                          : hasFirst && hasSecond;
        if (!holds) continue;
        const bool swapped = std::string_view(operation) == "subtraction";
        for (const std::uint32_t shape : {shapes[swapped ? 1 : 0], shapes[swapped ? 0 : 1]}) {
            const std::string type = word(shape, "type");
            const auto kind = std::find_if(sourceKinds().begin(), sourceKinds().end(),
                                           [&](const SourceKind& k) { return k.type == type; });
            std::vector<std::string> known;
            for (const SourceKind& k : sourceKinds()) known.emplace_back(k.type);
            if (kind == sourceKinds().end())
                findings_.add(json_, shape, unknownWord(type, "type of shape", known));
            else
                addShape(shape, *kind, {"type"}, both, path + ".children");
        }
        node["children"] = std::move(both);
        parts_.push_back({path, value});
        children_.push_back(std::move(node));
    }
}

/// Converts scenes for which the reference has shaders of their own: value noise as a solid, as waves and as clouds.
void SourceReader::readNoise()
{
    const std::optional<std::uint32_t> fractal = json_.member(0, "fbm");
    const std::string name = scene_.value("name", "");
    scene_["look"] = Json::object();
    scene_["materials"] = {{"noise", {{"model", "pbr"}, {"color", {0.5, 0.85, 0.6}}, {"roughness", 0.6}}}};
    if (name.find("Waves") != std::string::npos) {
        const Json noise = {{"kind", "displace"},
                            {"amplitude", 0.25},
                            {"frequency", 0.4},
                            {"octaves", 5},
                            {"shift", {0, "0.5 * t", "0.5 * t"}},
                            {"child", {{"kind", "plane"}, {"height", -0.2}}}};
        children_.push_back(noise);
        return;
    }
    // The reference's noise is 0 to 1, here it is -1 to 1, and its octaves begin with one half: 0.3 and 0.35 there.
    Json noise = {{"kind", "noise"},
                  {"level", fractal ? -0.53 : -0.4},
                  {"frequency", 1},
                  {"octaves", fractal ? 5 : 1},
                  {"shift", {0, 0, "1.3 * t"}},
                  {"material", "noise"}};
    if (name.find("Clouds") != std::string::npos) {
        noise["level"] = -0.35;
        noise["octaves"] = 5;
        noise["frequency"] = 0.5;
        children_.push_back({{"kind", "intersection"},
                             {"blend", "quadratic"},
                             {"blendWidth", 1},
                             {"children", {noise, {{"kind", "box"}, {"size", {200, 3, 200}}}}}});
        return;
    }
    children_.push_back(
        {{"kind", "subtraction"}, {"blendWidth", 0.6}, {"children", {noise, {{"kind", "sphere"}, {"radius", 1.5}}}}});
}

std::optional<ConvertedScene> SourceReader::convert()
{
    std::vector<std::string_view> keys{"name", "camera", "materials", "lights", "cubemap", "primitives"};
    for (const auto& [list, operation] : combinations) keys.push_back(list);
    scene_ = {{"format", sceneFormat}, {"version", sceneVersion}};
    const SourceNumbers n = numbers(0, {{"soft_shadows_factor", 1, false}, {"is_noise", 1, false}, {"fbm", 1, false}},
                                    keys, "a scene of the reference");
    if (const std::string name = word(0, "name"); !name.empty()) scene_["name"] = name;
    readCamera();
    readMaterials();
    const std::string cubemap = word(0, "cubemap");
    const std::vector<std::string> cubemaps{"lycksele", "yokohama", "interstellar"};
    if (!cubemap.empty() && std::find(cubemaps.begin(), cubemaps.end(), cubemap) == cubemaps.end())
        findings_.add(json_, *json_.member(0, "cubemap"), unknownWord(cubemap, "cube map of the reference", cubemaps));
    scene_["environment"] = skyOf(cubemap);
    scene_["look"] = {{"asInTheReference", true}, {"softShadows", n.find("soft_shadows_factor")->second[0]}};
    readShapes();
    for (const auto& [list, operation] : combinations) readCombinations(list, operation);
    if (n.find("is_noise")->second[0] != 0) readNoise();
    if (children_.empty() && findings_.empty())
        findings_.add(json_, 0, "this scene has no shapes; give it some under \"primitives\"");
    if (!findings_.empty()) return std::nullopt;
    scene_["root"] = {{"kind", "union"}, {"children", std::move(children_)}};
    return ConvertedScene{render::writeJson(scene_), std::move(parts_)};
}

}  // namespace

bool isSourceScene(const render::JsonText& json)
{
    if (json.member(0, "format")) return false;
    const bool isCombined = std::any_of(std::begin(combinations), std::end(combinations),
                                        [&](const auto& c) { return json.member(0, c.first).has_value(); });
    return isCombined || json.member(0, "primitives") || json.member(0, "is_noise");
}

std::optional<ConvertedScene> convertSourceScene(const render::JsonText& json, Findings& findings,
                                                 const std::set<std::uint32_t>& without)
{
    return SourceReader(json, findings, without).convert();
}

}  // namespace vitrine::scenes
