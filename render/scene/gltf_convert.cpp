#include "render/scene/gltf_convert.h"

#include "render/scene/gltf_accessor.h"
#include "render/scene/gltf_guard.h"
#include "render/scene/gltf_materials.h"
#include "render/scene/gltf_pose.h"
#include "render/scene/mesh_shading.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace vitrine::render {

glm::dmat4 nodeTransform(const tinygltf::Node& node)
{
    if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
    glm::dmat4 transform(1);
    if (!node.translation.empty()) transform[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1);
    if (!node.rotation.empty()) {
        const auto& r = node.rotation;
        const glm::dquat q(r[3], r[0], r[1], r[2]);
        const double length = glm::length(q);
        if (length > 0) transform *= glm::mat4_cast(q / length);
    }
    if (!node.scale.empty()) {
        for (int axis = 0; axis < 3; ++axis) transform[axis] *= node.scale[static_cast<std::size_t>(axis)];
    }
    return transform;
}

namespace {

bool isFinite(const glm::dmat4& m)
{
    const double* first = glm::value_ptr(m);
    return std::all_of(first, first + 16, [](double x) { return std::isfinite(x); });
}

/// Adds the names of all extensions used anywhere in a document. Extras of other programs are skipped.
void addExtensions(const Json& json, std::set<std::string>& names)
{
    if (json.is_array())
        for (const Json& each : json) addExtensions(each, names);
    if (!json.is_object()) return;
    for (const auto& [key, value] : json.items()) {
        if (key == "extras") continue;
        if (key == "extensions" && value.is_object())
            for (const auto& [name, settings] : value.items()) names.insert(name);
        addExtensions(value, names);
    }
}

/// Converts strips and fans to triangles.
std::vector<std::uint32_t> triangulated(std::vector<std::uint32_t> in, int mode)
{
    if (mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) {
        in.resize(in.size() / 3 * 3);
        return in;
    }
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i + 2 < in.size(); ++i) {
        const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
        const bool odd = i % 2 == 1;
        const std::array<std::size_t, 3> corner =
            strip ? std::array<std::size_t, 3>{i, i + (odd ? 2U : 1U), i + (odd ? 1U : 2U)}
                  : std::array<std::size_t, 3>{i + 1, i + 2, 0};
        for (const std::size_t c : corner) out.push_back(in[c]);
    }
    return out;
}

class Converter {
public:
    Converter(const tinygltf::Model& gltf, const JsonDocument& document, const GltfLimits& limits,
              const std::function<bool()>& canceled, const GltfPose* pose)
        : gltf_(gltf), document_(document), canceled_(canceled), pose_(pose), warnings_(out_.warnings),
          materials_(gltf, document, limits, canceled, warnings_)
    {
    }

    Model convert()
    {
        warnAboutTheRest();
        struct Visit {
            int node;
            glm::dmat4 modelFromParent;
        };
        std::vector<Visit> open;
        const std::vector<int> roots = rootNodes();
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, glm::dmat4(1)});
        while (!open.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            const tinygltf::Node& node = gltf_.nodes[static_cast<std::size_t>(visit.node)];
            const glm::dmat4 modelFromNode = visit.modelFromParent * nodeTransform(node);
            if (!isFinite(modelFromNode)) {
                throw document_.failure("nodes[" + std::to_string(visit.node) + "]",
                                        message("its transform overflows; export the file again."));
            }
            add(visit.node, modelFromNode);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
                open.push_back({*child, modelFromNode});
        }
        return std::move(out_);
    }

private:
    std::vector<int> rootNodes() const
    {
        if (!gltf_.scenes.empty()) {
            const std::vector<int>& listed =
                gltf_.scenes[static_cast<std::size_t>(std::max(gltf_.defaultScene, 0))].nodes;
            return listed;
        }
        std::vector<bool> isChild(gltf_.nodes.size(), false);
        for (const tinygltf::Node& node : gltf_.nodes) {
            for (const int child : node.children) isChild[static_cast<std::size_t>(child)] = true;
        }
        std::vector<int> roots;
        for (std::size_t i = 0; i < isChild.size(); ++i) {
            if (!isChild[i]) roots.push_back(static_cast<int>(i));
        }
        return roots;
    }

    void warnAboutTheRest()
    {
        const auto has = [this](const char* array) { return document_.root().contains(array); };
        if (has("animations") && !pose_)
            warnings_.add(message("Animations are not supported; the model stands still."));
        if (has("skins") && !pose_) warnings_.add(message("Skins are not supported; meshes keep their rest pose."));
        if (has("cameras")) warnings_.add(message("Cameras are not supported; their nodes become markers."));
        if (gltf_.scenes.size() > 1) warnings_.add(message("Only the default scene is shown."));
        // Extensions that the file uses without listing them count, too: their effect is missing all the same.
        std::set<std::string> extensions(gltf_.extensionsUsed.begin(), gltf_.extensionsUsed.end());
        addExtensions(document_.root(), extensions);
        for (const std::string& name : extensions) {
            if (isDrawnExtension(name)) continue;
            warnings_.add(message("The extension {1} is not supported and was ignored.", name));
        }
    }

    void add(int index, const glm::dmat4& placed)
    {
        const tinygltf::Node& node = gltf_.nodes[static_cast<std::size_t>(index)];
        // A skinned mesh is placed by its joints alone.
        const glm::dmat4 modelFromNode = pose_ && pose_->isSkinned(index) ? glm::dmat4(1) : placed;
        if (node.mesh < 0) {
            out_.markers.push_back({node.name, modelFromNode});
            return;
        }
        const auto& primitives = gltf_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            MeshInstance part;
            part.name = node.name;
            part.material = materials_.material(primitives[p].material);
            part.mesh = mesh(index, p, *part.material);
            if (!part.mesh) continue;
            part.modelFromPart = modelFromNode;
            part.mirrored = glm::determinant(glm::dmat3(modelFromNode)) < 0;
            const Box box = part.mesh->bounds.transformed(modelFromNode);
            out_.bounds.include(box.low);
            out_.bounds.include(box.high);
            out_.parts.push_back(std::move(part));
        }
    }

    /// Returns primitive `p` of a node's mesh; null if it has no triangles. Each is converted once, or once per node if
    /// that deforms it.
    std::shared_ptr<const Mesh> mesh(int node, std::size_t p, const Material& material)
    {
        const int m = gltf_.nodes[static_cast<std::size_t>(node)].mesh;
        const bool deformed = pose_ && pose_->deforms(node);
        const auto key = std::tuple(m, p, deformed ? node : -1);
        const auto known = meshes_.find(key);
        if (known != meshes_.end()) return known->second;
        if (canceled_ && canceled_()) throw document_.failure({}, message("loading was canceled."));
        const tinygltf::Mesh& source = gltf_.meshes[static_cast<std::size_t>(m)];
        const std::string path = "meshes[" + std::to_string(m) + "].primitives[" + std::to_string(p) + "]";
        return meshes_[key] = convertPrimitive(source.primitives[p], source.name, path, material, deformed ? node : -1);
    }

    std::shared_ptr<const Mesh> convertPrimitive(const tinygltf::Primitive& primitive, const std::string& name,
                                                 const std::string& path, const Material& material, int deformedBy)
    {
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            warnings_.add(message("Lines and points are not supported and were left out of mesh {1}.", name));
            return nullptr;
        }
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) {
            warnings_.add(message("Mesh {1} has a part without positions, which was left out.", name));
            return nullptr;
        }
        if (!primitive.targets.empty() && !pose_)
            warnings_.add(message("Morph targets are not supported; mesh {1} keeps its first shape.", name));

        auto mesh = std::make_shared<Mesh>();
        mesh->name = name;
        mesh->vertices.resize(gltf_.accessors[static_cast<std::size_t>(position->second)].count);
        const bool hasNormals = primitive.attributes.contains("NORMAL");
        const bool hasTangents = primitive.attributes.contains("TANGENT");
        const MapPlaces& places = materials_.places(primitive.material);
        const bool hasUv = primitive.attributes.contains("TEXCOORD_" + std::to_string(places.front().set));
        for (const auto& [attribute, accessor] : primitive.attributes) {
            readAttribute(*mesh, attribute, accessor, path + ".attributes." + attribute);
        }
        placeCoordinates(*mesh, places);
        if (deformedBy >= 0) pose_->deform(*mesh, gltf_, primitive, deformedBy);
        if (primitive.indices >= 0) {
            mesh->indices = readIndices(gltf_, primitive.indices);
        } else {
            mesh->indices.resize(mesh->vertices.size());
            for (std::size_t i = 0; i < mesh->indices.size(); ++i) mesh->indices[i] = static_cast<std::uint32_t>(i);
        }
        mesh->indices = triangulated(std::move(mesh->indices), mode);
        if (mesh->indices.empty()) return nullptr;
        keepUsedVertices(*mesh);
        if (!hasNormals) makeFlatNormals(*mesh);
        if (material.normalMap && !hasUv)
            warnings_.add(message("Mesh {1} has a normal map but no texture coordinates.", name));
        if (material.normalMap && hasUv && (!hasTangents || !hasNormals)) makeTangents(*mesh);
        for (const Vertex& vertex : mesh->vertices) mesh->bounds.include(glm::dvec3(vertex.position));
        return mesh;
    }

    /// Replaces the two sets of texture coordinates of the file by those of the material's maps.
    static void placeCoordinates(Mesh& mesh, const MapPlaces& places)
    {
        if (places[0] == MapPlace{0} && places[1] == MapPlace{1}) return;
        for (Vertex& vertex : mesh.vertices) {
            const std::array<glm::vec2, 2> sets{vertex.uv, vertex.extra};
            vertex.uv = places[0].at(sets.at(static_cast<std::size_t>(places[0].set)));
            vertex.extra = places[1].at(sets.at(static_cast<std::size_t>(places[1].set)));
        }
    }

    void readAttribute(Mesh& mesh, const std::string& attribute, int accessor, const std::string& path)
    {
        constexpr std::array<std::pair<const char*, int>, 5> known = {
            {{"POSITION", 3}, {"NORMAL", 3}, {"TANGENT", 4}, {"TEXCOORD_0", 2}, {"TEXCOORD_1", 2}}};
        const auto entry =
            std::find_if(known.begin(), known.end(), [&](const auto& k) { return attribute == k.first; });
        if (attribute == "COLOR_0") {
            readColors(mesh, accessor, path);
            return;
        }
        if (entry == known.end()) {
            const std::size_t number = attribute.find('_') + 1;
            const bool ofSkin = attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_");
            const bool drawn = ofSkin && GltfPose::takesSet(attribute.substr(number));
            if (!drawn) warnings_.add(message("The vertex attribute {1} is not supported and was ignored.", attribute));
            return;
        }
        const auto components = static_cast<std::size_t>(entry->second);
        if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(
                gltf_.accessors[static_cast<std::size_t>(accessor)].type)) != entry->second) {
            throw document_.failure(path, message("this must have {1} components; export the file again.", components));
        }
        const std::vector<float> values = finiteFloats(accessor, path);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
            store(mesh.vertices[i], attribute, values.data() + i * components);
    }

    std::vector<float> finiteFloats(int accessor, const std::string& path) const
    {
        std::vector<float> values = readFloats(gltf_, accessor);
        if (!std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); })) {
            throw document_.failure(path, message("one of its values is not a finite number; export the file again."));
        }
        return values;
    }

    /// Reads three or four components, floats or integers. Integers are divided by their largest value, even if the
    /// file omits `normalized`.
    void readColors(Mesh& mesh, int accessor, const std::string& path)
    {
        const tinygltf::Accessor& from = gltf_.accessors[static_cast<std::size_t>(accessor)];
        const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(from.type));
        if (components != 3 && components != 4)
            throw document_.failure(path, message("this must have 3 or 4 components; export the file again."));
        float largest = 1;
        if (!from.normalized && from.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) largest = 255;
        if (!from.normalized && from.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) largest = 65535;
        const std::vector<float> values = finiteFloats(accessor, path);
        const auto step = static_cast<std::size_t>(components);
        mesh.colors.reserve(mesh.vertices.size());
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const float* x = values.data() + i * step;
            const glm::vec4 color(x[0], x[1], x[2], step == 4 ? x[3] : largest);
            mesh.colors.push_back(glm::clamp(color / largest, 0.0F, 1.0F));
        }
    }

    static void store(Vertex& vertex, const std::string& attribute, const float* x)
    {
        if (attribute == "POSITION")
            vertex.position = glm::make_vec3(x);
        else if (attribute == "NORMAL")
            vertex.normal = unit(glm::make_vec3(x), glm::vec3(0, 1, 0));
        else if (attribute == "TANGENT")
            vertex.tangent = glm::vec4(unit(glm::make_vec3(x), glm::vec3(1, 0, 0)), x[3] < 0 ? -1.0F : 1.0F);
        else if (attribute == "TEXCOORD_0")
            vertex.uv = glm::make_vec2(x);
        else
            vertex.extra = glm::make_vec2(x);
    }

    /// Returns `v` at unit length, unchanged if it already is; `fallback` if its length is 0.
    static glm::vec3 unit(const glm::vec3& v, const glm::vec3& fallback)
    {
        const double length = glm::length(glm::dvec3(v));
        if (length < 1e-20) return fallback;
        return std::abs(length - 1) < 1e-6 ? v : glm::vec3(glm::dvec3(v) / length);
    }

    const tinygltf::Model& gltf_;
    const JsonDocument& document_;
    const std::function<bool()>& canceled_;
    const GltfPose* pose_;
    Model out_;
    Warnings warnings_;
    GltfMaterials materials_;
    std::map<std::tuple<int, std::size_t, int>, std::shared_ptr<const Mesh>> meshes_;
};

}  // namespace

Model convertGltf(const tinygltf::Model& gltf, const JsonDocument& document, const GltfLimits& limits,
                  const std::function<bool()>& canceled, const GltfPose* pose)
{
    return Converter(gltf, document, limits, canceled, pose).convert();
}

}  // namespace vitrine::render
