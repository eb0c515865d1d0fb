#include "render/scene/gltf_schema.h"

#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace vitrine::render {
namespace {

enum class Kind : unsigned char { index, size, number, text, truth, object, array };
enum class Need : unsigned char { optional, required };

struct Rule {
    std::string_view path;  ///< "[]" stands for each element of an array, "{}" for each member of an object.
    Kind kind;
    Need need = Need::optional;
};

/// Sorted from the outside in: when a rule passes through a member, its type was checked before.
constexpr Rule rules[] = {
    {"asset", Kind::object, Need::required},
    {"asset.version", Kind::text, Need::required},
    {"extensionsUsed", Kind::array},
    {"extensionsUsed[]", Kind::text},
    {"extensionsRequired", Kind::array},
    {"extensionsRequired[]", Kind::text},
    {"scene", Kind::index},
    {"scenes", Kind::array},
    {"scenes[]", Kind::object},
    {"scenes[].nodes", Kind::array},
    {"scenes[].nodes[]", Kind::index},
    {"nodes", Kind::array},
    {"nodes[]", Kind::object},
    {"nodes[].name", Kind::text},
    {"nodes[].mesh", Kind::index},
    {"nodes[].children", Kind::array},
    {"nodes[].children[]", Kind::index},
    {"nodes[].matrix", Kind::array},
    {"nodes[].matrix[]", Kind::number},
    {"nodes[].translation", Kind::array},
    {"nodes[].translation[]", Kind::number},
    {"nodes[].rotation", Kind::array},
    {"nodes[].rotation[]", Kind::number},
    {"nodes[].scale", Kind::array},
    {"nodes[].scale[]", Kind::number},
    {"meshes", Kind::array},
    {"meshes[]", Kind::object},
    {"meshes[].name", Kind::text},
    {"meshes[].primitives", Kind::array, Need::required},
    {"meshes[].primitives[]", Kind::object},
    {"meshes[].primitives[].attributes", Kind::object, Need::required},
    {"meshes[].primitives[].attributes{}", Kind::index},
    {"meshes[].primitives[].indices", Kind::index},
    {"meshes[].primitives[].material", Kind::index},
    {"meshes[].primitives[].mode", Kind::index},
    {"meshes[].primitives[].targets", Kind::array},
    {"meshes[].primitives[].extensions", Kind::object},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression", Kind::object},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.bufferView", Kind::index, Need::required},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.attributes", Kind::object, Need::required},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.attributes{}", Kind::index},
    {"accessors", Kind::array},
    {"accessors[]", Kind::object},
    {"accessors[].bufferView", Kind::index},
    {"accessors[].byteOffset", Kind::size},
    {"accessors[].componentType", Kind::index, Need::required},
    {"accessors[].normalized", Kind::truth},
    {"accessors[].count", Kind::size, Need::required},
    {"accessors[].type", Kind::text, Need::required},
    {"accessors[].sparse", Kind::object},
    {"accessors[].sparse.count", Kind::index, Need::required},
    {"accessors[].sparse.indices", Kind::object, Need::required},
    {"accessors[].sparse.indices.bufferView", Kind::index, Need::required},
    {"accessors[].sparse.indices.byteOffset", Kind::index},
    {"accessors[].sparse.indices.componentType", Kind::index, Need::required},
    {"accessors[].sparse.values", Kind::object, Need::required},
    {"accessors[].sparse.values.bufferView", Kind::index, Need::required},
    {"accessors[].sparse.values.byteOffset", Kind::index},
    {"bufferViews", Kind::array},
    {"bufferViews[]", Kind::object},
    {"bufferViews[].buffer", Kind::index, Need::required},
    {"bufferViews[].byteOffset", Kind::size},
    {"bufferViews[].byteLength", Kind::size, Need::required},
    {"bufferViews[].byteStride", Kind::size},
    {"bufferViews[].extensions", Kind::object},
    {"bufferViews[].extensions.EXT_meshopt_compression", Kind::object},
    {"bufferViews[].extensions.EXT_meshopt_compression.buffer", Kind::index, Need::required},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteOffset", Kind::size},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteLength", Kind::size, Need::required},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteStride", Kind::size, Need::required},
    {"bufferViews[].extensions.EXT_meshopt_compression.count", Kind::size, Need::required},
    {"bufferViews[].extensions.EXT_meshopt_compression.mode", Kind::text, Need::required},
    {"bufferViews[].extensions.EXT_meshopt_compression.filter", Kind::text},
    {"buffers", Kind::array},
    {"buffers[]", Kind::object},
    {"buffers[].byteLength", Kind::size, Need::required},
    {"buffers[].uri", Kind::text},
    {"buffers[].extensions", Kind::object},
    {"buffers[].extensions.EXT_meshopt_compression", Kind::object},
    {"buffers[].extensions.EXT_meshopt_compression.fallback", Kind::truth},
    {"images", Kind::array},
    {"images[]", Kind::object},
    {"images[].name", Kind::text},
    {"images[].uri", Kind::text},
    {"images[].bufferView", Kind::index},
    {"textures", Kind::array},
    {"textures[]", Kind::object},
    {"textures[].source", Kind::index},
    {"textures[].sampler", Kind::index},
    {"samplers", Kind::array},
    {"samplers[]", Kind::object},
    {"samplers[].minFilter", Kind::index},
    {"samplers[].wrapS", Kind::index},
    {"samplers[].wrapT", Kind::index},
    {"materials", Kind::array},
    {"materials[]", Kind::object},
    {"materials[].name", Kind::text},
    {"materials[].alphaMode", Kind::text},
    {"materials[].alphaCutoff", Kind::number},
    {"materials[].doubleSided", Kind::truth},
    {"materials[].emissiveFactor", Kind::array},
    {"materials[].emissiveFactor[]", Kind::number},
    {"materials[].normalTexture", Kind::object},
    {"materials[].normalTexture.index", Kind::index, Need::required},
    {"materials[].normalTexture.texCoord", Kind::index},
    {"materials[].normalTexture.scale", Kind::number},
    {"materials[].occlusionTexture", Kind::object},
    {"materials[].occlusionTexture.index", Kind::index, Need::required},
    {"materials[].occlusionTexture.texCoord", Kind::index},
    {"materials[].occlusionTexture.strength", Kind::number},
    {"materials[].emissiveTexture", Kind::object},
    {"materials[].emissiveTexture.index", Kind::index, Need::required},
    {"materials[].emissiveTexture.texCoord", Kind::index},
    {"materials[].pbrMetallicRoughness", Kind::object},
    {"materials[].pbrMetallicRoughness.baseColorFactor", Kind::array},
    {"materials[].pbrMetallicRoughness.baseColorFactor[]", Kind::number},
    {"materials[].pbrMetallicRoughness.metallicFactor", Kind::number},
    {"materials[].pbrMetallicRoughness.roughnessFactor", Kind::number},
    {"materials[].pbrMetallicRoughness.baseColorTexture", Kind::object},
    {"materials[].pbrMetallicRoughness.baseColorTexture.index", Kind::index, Need::required},
    {"materials[].pbrMetallicRoughness.baseColorTexture.texCoord", Kind::index},
    {"materials[].pbrMetallicRoughness.metallicRoughnessTexture", Kind::object},
    {"materials[].pbrMetallicRoughness.metallicRoughnessTexture.index", Kind::index, Need::required},
    {"materials[].pbrMetallicRoughness.metallicRoughnessTexture.texCoord", Kind::index},
};

Message nameOf(Kind kind)
{
    switch (kind) {
    case Kind::index: return message("a whole number from 0 to 2147483647");
    case Kind::size: return message("a whole number from 0 up");
    case Kind::number: return message("a number");
    case Kind::text: return message("text");
    case Kind::truth: return message("true or false");
    case Kind::object: return message("an object");
    case Kind::array: return message("an array");
    }
    return {};
}

bool isOf(const Json& json, Kind kind)
{
    switch (kind) {
    // Fits tinygltf's int.
    case Kind::index: return json.is_number_unsigned() && json.get<std::uint64_t>() <= 2147483647;
    case Kind::size: return json.is_number_unsigned();
    case Kind::number: return json.is_number();
    case Kind::text: return json.is_string();
    case Kind::truth: return json.is_boolean();
    case Kind::object: return json.is_object();
    case Kind::array: return json.is_array();
    }
    return false;
}

class Checker {
public:
    explicit Checker(const JsonDocument& document) : document_(document) {}

    void check(const Rule& rule)
    {
        rule_ = &rule;
        walk(document_.root(), rule.path, {});
    }

private:
    /// Applies the rule. `rest` is the unmatched remainder of the rule's path, `path` the location of `json`.
    void walk(const Json& json, std::string_view rest, const std::string& path) const
    {
        if (rest.empty()) {
            if (!isOf(json, rule_->kind))
                throw document_.failure(path, message("this must be {1}; export the file again.", nameOf(rule_->kind)));
        } else if (rest.starts_with("[]")) {
            for (std::size_t i = 0; i < json.size(); ++i)
                walk(json[i], rest.substr(2), path + "[" + std::to_string(i) + "]");
        } else if (rest.starts_with("{}")) {
            for (const auto& [key, value] : json.items()) walk(value, rest.substr(2), path + "." + key);
        } else {
            if (rest.front() == '.') rest.remove_prefix(1);
            const std::size_t end = std::min({rest.find('.'), rest.find('['), rest.find('{'), rest.size()});
            const std::string key(rest.substr(0, end));
            const auto at = json.find(key);
            const std::string next = path.empty() ? key : path + "." + key;
            if (at != json.end())
                walk(*at, rest.substr(end), next);
            else if (end == rest.size() && rule_->need == Need::required)
                throw document_.failure(next, message("this is required and missing; export the file again."));
        }
    }

    const JsonDocument& document_;
    const Rule* rule_ = nullptr;
};

}  // namespace

void checkGltfSchema(const JsonDocument& document)
{
    Checker checker(document);
    for (const Rule& rule : rules) checker.check(rule);
}

void makeWholeNumbersIntegers(Json& json)
{
    if (json.is_number_float()) {
        constexpr double exact = 9007199254740992.0;  // Up to this value a double represents every whole number.
        const double x = json.get<double>();
        if (std::trunc(x) != x || std::abs(x) >= exact || std::signbit(x)) return;
        json = static_cast<std::uint64_t>(x);
    } else if (json.is_structured()) {
        for (Json& inner : json) makeWholeNumbersIntegers(inner);
    }
}

const Json& arrayAt(const JsonDocument& document, const char* key)
{
    static const Json none = Json::array();
    const auto at = document.root().find(key);
    return at == document.root().end() ? none : *at;
}

std::string elementPath(const char* array, std::size_t i, const char* key)
{
    std::string path = array;
    ((path += '[') += std::to_string(i)) += ']';
    if (*key != '\0') (path += '.') += key;
    return path;
}

}  // namespace vitrine::render
