#include "exhibits/sdf_scenes/mesh_text.h"
#include "exhibits/sdf_scenes/scene_mesh.h"
#include "render/files/strict_json.h"
#include "render/image/srgb.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

namespace vitrine::scenes {
namespace {

static_assert(std::endian::native == std::endian::little, "the three formats are little-endian");

template <typename T> void put(std::string& bytes, const T& value)
{
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

void put(std::string& bytes, const glm::vec3& v)
{
    for (int i = 0; i < 3; ++i) put(bytes, v[i]);
}

/// Triangles of one color, or with several: indices of their corners.
struct ColorGroup {
    std::optional<glm::vec3> color;  ///< Unset: the corners have different colors.
    std::vector<std::uint32_t> indices;
};

/// Groups triangles by color, with a last group for triangles of several colors. Many programs show colors of materials
/// but not of vertices.
std::vector<ColorGroup> groupsByColor(const SceneMesh& mesh)
{
    constexpr std::size_t mostColors = 64;
    const auto codes = [](const glm::vec3& c) {
        const glm::ivec3 code(glm::round(c * 255.0F));
        return std::array<int, 3>{code.x, code.y, code.z};
    };
    std::map<std::array<int, 3>, std::size_t> known;
    std::vector<ColorGroup> groups;
    ColorGroup mixed;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto colorAt = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].color; };
        const auto code = codes(colorAt(0));
        ColorGroup* group = &mixed;
        if (codes(colorAt(1)) == code && codes(colorAt(2)) == code) {
            const auto found = known.find(code);
            if (found != known.end()) {
                group = &groups[found->second];
            } else if (groups.size() < mostColors) {
                known[code] = groups.size();
                group = &groups.emplace_back(ColorGroup{colorAt(0), {}});
            }
        }
        for (std::size_t k = 0; k < 3; ++k) group->indices.push_back(mesh.indices[i + k]);
    }
    if (!mixed.indices.empty() || groups.empty()) groups.push_back(std::move(mixed));
    return groups;
}

/// Returns the lowest and highest coordinates of a mesh; zeros for one without vertices.
std::pair<glm::vec3, glm::vec3> extremesOf(const SceneMesh& mesh)
{
    glm::vec3 low(0), high(0);
    if (!mesh.vertices.empty()) low = high = mesh.vertices.front().position;
    for (const MeshVertex& v : mesh.vertices) {
        low = glm::min(low, v.position);
        high = glm::max(high, v.position);
    }
    return {low, high};
}

bool hasVertexColors(const std::vector<ColorGroup>& groups)
{
    return !groups.back().color;
}

/// Returns the JSON of a glTF file. Its binary part holds positions, normals, colors (four of 16 bits, if triangles
/// have several) and the indices of all groups.
std::string gltfJson(const SceneMesh& mesh, const std::vector<ColorGroup>& groups, const std::string& name)
{
    using render::Json;
    const std::size_t n = mesh.vertices.size();
    const auto [low, high] = extremesOf(mesh);
    constexpr int arrayBuffer = 34962, elementBuffer = 34963, float32 = 5126, uint16 = 5123, uint32 = 5125;
    const auto view = [](std::size_t offset, std::size_t length, int target) {
        return Json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}};
    };
    const auto accessor = [](int bufferView, int type, std::size_t count, const char* shape) {
        return Json{{"bufferView", bufferView}, {"componentType", type}, {"count", count}, {"type", shape}};
    };
    Json positions = accessor(0, float32, n, "VEC3");
    positions["min"] = Json::array({low.x, low.y, low.z});
    positions["max"] = Json::array({high.x, high.y, high.z});
    Json colors = accessor(2, uint16, n, "VEC4");
    colors["normalized"] = true;
    const bool ofVertices = hasVertexColors(groups);
    Json accessors = Json::array({positions, accessor(1, float32, n, "VEC3")});
    Json views = Json::array({view(0, 12 * n, arrayBuffer), view(12 * n, 12 * n, arrayBuffer)});
    if (ofVertices) {
        accessors.push_back(std::move(colors));
        views.push_back(view(24 * n, 8 * n, arrayBuffer));
    }
    const std::size_t indicesAt = (ofVertices ? 32 : 24) * n;
    const int indexView = ofVertices ? 3 : 2;
    Json materials = Json::array(), primitives = Json::array();
    std::size_t indices = 0;
    for (const ColorGroup& group : groups) {
        Json indexAccessor = accessor(indexView, uint32, group.indices.size(), "SCALAR");
        indexAccessor["byteOffset"] = 4 * indices;
        indices += group.indices.size();
        Json attributes{{"POSITION", 0}, {"NORMAL", 1}};
        Json surface{{"metallicFactor", 0}, {"roughnessFactor", 0.5}};
        if (group.color)
            surface["baseColorFactor"] = Json::array({group.color->x, group.color->y, group.color->z, 1});
        else
            attributes["COLOR_0"] = 2;
        primitives.push_back(
            Json{{"attributes", attributes}, {"indices", accessors.size()}, {"material", materials.size()}});
        accessors.push_back(std::move(indexAccessor));
        materials.push_back(Json{{"pbrMetallicRoughness", surface}});
    }
    views.push_back(view(indicesAt, 4 * indices, elementBuffer));
    const Json root{
        {"asset", Json{{"version", "2.0"}, {"generator", std::string("Vitrine ").append(render::programVersion())}}},
        {"scene", 0},
        {"scenes", Json::array({Json{{"nodes", Json::array({0})}}})},
        {"nodes", Json::array({Json{{"name", name}, {"mesh", 0}}})},
        {"materials", std::move(materials)},
        {"meshes", Json::array({Json{{"name", name}, {"primitives", std::move(primitives)}}})},
        {"accessors", std::move(accessors)},
        {"bufferViews", std::move(views)},
        {"buffers", Json::array({Json{{"byteLength", indicesAt + 4 * indices}}})}};
    std::string json = root.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return json;
}

std::string glbFile(const SceneMesh& mesh, const std::string& name)
{
    const std::vector<ColorGroup> groups = groupsByColor(mesh);
    const std::string json = gltfJson(mesh, groups, name);
    const bool ofVertices = hasVertexColors(groups);
    const std::size_t binary = (ofVertices ? 32 : 24) * mesh.vertices.size() + 4 * mesh.indices.size();
    std::string bytes;
    bytes.reserve(28 + json.size() + binary);
    bytes += "glTF";
    put(bytes, std::uint32_t{2});
    put(bytes, static_cast<std::uint32_t>(28 + json.size() + binary));
    put(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    put(bytes, static_cast<std::uint32_t>(binary));
    bytes.append("BIN\0", 4);
    for (const MeshVertex& v : mesh.vertices) put(bytes, v.position);
    for (const MeshVertex& v : mesh.vertices) put(bytes, v.normal);
    for (const MeshVertex& v : mesh.vertices) {
        if (!ofVertices) break;
        for (int i = 0; i < 3; ++i)
            put(bytes, static_cast<std::uint16_t>(std::lround(65535 * std::clamp(v.color[i], 0.0F, 1.0F))));
        put(bytes, std::uint16_t{65535});
    }
    for (const ColorGroup& group : groups)
        for (const std::uint32_t i : group.indices) put(bytes, i);
    return bytes;
}

std::string stlFile(const SceneMesh& mesh, const std::string& name)
{
    std::string bytes = "binary STL, millimeters: " + name;
    bytes.resize(80, ' ');
    bytes.reserve(84 + mesh.indices.size() / 3 * 50);
    put(bytes, static_cast<std::uint32_t>(mesh.indices.size() / 3));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return 1000.0F * mesh.vertices[mesh.indices[i + k]].position; };
        const glm::vec3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        const float length = glm::length(across);
        put(bytes, length > 0 ? across / length : glm::vec3(0));
        for (std::size_t k = 0; k < 3; ++k) put(bytes, corner(k));
        put(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string plyFile(const SceneMesh& mesh, const std::string& name)
{
    std::string comment = name;
    std::replace_if(
        comment.begin(), comment.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment meters: " + comment + "\nelement vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face " +
        std::to_string(mesh.indices.size() / 3) + "\nproperty list uchar int vertex_indices\nend_header\n";
    bytes.reserve(bytes.size() + 27 * mesh.vertices.size() + 13 * mesh.indices.size() / 3);
    for (const MeshVertex& v : mesh.vertices) {
        put(bytes, v.position);
        put(bytes, v.normal);
        for (int i = 0; i < 3; ++i) put(bytes, render::srgb8FromLinear(v.color[i]));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (i % 3 == 0) put(bytes, std::uint8_t{3});
        put(bytes, mesh.indices[i]);
    }
    return bytes;
}

}  // namespace

std::optional<MeshFormat> meshFormat(const std::string& file)
{
    const std::size_t dot = file.rfind('.');
    std::string end = dot == std::string::npos ? "" : file.substr(dot + 1);
    std::transform(end.begin(), end.end(), end.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const auto* found = std::find(meshEndings.begin(), meshEndings.end(), end);
    if (found == meshEndings.end()) return std::nullopt;
    return static_cast<MeshFormat>(found - meshEndings.begin());
}

std::string meshFile(const SceneMesh& mesh, MeshFormat format, const std::string& name)
{
    switch (format) {
    case MeshFormat::glb: return glbFile(mesh, name);
    case MeshFormat::stl: return stlFile(mesh, name);
    case MeshFormat::ply: return plyFile(mesh, name);
    case MeshFormat::obj: return objFile(mesh, name);
    case MeshFormat::threeMf: return threeMfFile(mesh, name);
    }
    return {};
}

}  // namespace vitrine::scenes
