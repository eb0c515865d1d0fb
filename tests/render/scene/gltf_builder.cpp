#include "tests/render/scene/gltf_builder.h"

#include "tests/support/image_bytes.h"

#include <cstring>

namespace vitrine::test {

using render::Json;

GltfBuilder::GltfBuilder()
{
    json =
        Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                           "accessors": [], "bufferViews": []})");
}

int GltfBuilder::view(std::string_view bytes)
{
    json["bufferViews"].push_back({{"buffer", 0U}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}});
    bin += bytes;
    bin.resize((bin.size() + 3) / 4 * 4);
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::floats(const std::vector<float>& values, const std::string& type)
{
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    json["accessors"].push_back(
        {{"bufferView", view(bytes)}, {"componentType", 5126}, {"count", values.size() / components}, {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfBuilder::indices(const std::vector<std::uint16_t>& values)
{
    std::string bytes(values.size() * sizeof(std::uint16_t), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    json["accessors"].push_back(
        {{"bufferView", view(bytes)}, {"componentType", 5123}, {"count", values.size()}, {"type", "SCALAR"}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfBuilder::triangle()
{
    Json attributes;
    attributes["POSITION"] = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    attributes["TEXCOORD_0"] = floats({0, 1, 1, 1, 0, 0}, "VEC2");
    Json primitive;
    primitive["attributes"] = attributes;
    primitive["indices"] = indices({0, 1, 2});
    Json mesh;
    mesh["name"] = "triangle";
    mesh["primitives"] = Json::array({primitive});
    json["meshes"].push_back(mesh);
    return static_cast<int>(json["meshes"].size()) - 1;
}

int GltfBuilder::node(Json node)
{
    json["nodes"].push_back(std::move(node));
    const int index = static_cast<int>(json["nodes"].size()) - 1;
    json["scenes"][0]["nodes"].push_back(index);
    return index;
}

Json GltfBuilder::complete() const
{
    Json all = json;
    if (!all.contains("buffers") && !bin.empty()) all["buffers"] = Json::array({Json{{"byteLength", bin.size()}}});
    for (const char* key : {"nodes", "meshes", "accessors", "bufferViews"}) {
        if (all.contains(key) && all[key].empty()) all.erase(key);
    }
    return all;
}

std::string GltfBuilder::glb() const
{
    return glbOf(complete().dump(), bin);
}

std::string GltfBuilder::text() const
{
    Json all = complete();
    all["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bin);
    return all.dump(1);
}

std::string glbOf(std::string json, std::string bin, const std::vector<std::pair<std::string, std::string>>& further)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4, '\0');
    std::string chunks = littleEndian32(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
    if (!bin.empty()) chunks += littleEndian32(static_cast<std::uint32_t>(bin.size())) + std::string("BIN\0", 4) + bin;
    for (const auto& [type, bytes] : further)
        chunks += littleEndian32(static_cast<std::uint32_t>(bytes.size())) + type + bytes;
    return "glTF" + littleEndian32(2) + littleEndian32(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace vitrine::test
