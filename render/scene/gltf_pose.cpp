#include "render/scene/gltf_pose.h"

#include "render/scene/gltf_accessor.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vitrine::render {
namespace {

glm::vec3 unitOr(const glm::dvec3& v, const glm::vec3& otherwise)
{
    const double length = glm::length(v);
    return length > 1e-20 && std::isfinite(length) ? glm::vec3(v / length) : otherwise;
}

/// Returns the values of an attribute if there is one value per vertex with this number of components; else empty.
std::vector<float> valuesOf(const tinygltf::Model& gltf, const std::map<std::string, int>& attributes,
                            const std::string& name, std::size_t vertices, std::size_t components)
{
    const auto found = attributes.find(name);
    // Morph targets are not validated elsewhere.
    if (found == attributes.end() || found->second < 0 ||
        static_cast<std::size_t>(found->second) >= gltf.accessors.size())
        return {};
    std::vector<float> values = readFloats(gltf, found->second);
    if (values.size() != vertices * components) return {};
    if (!std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); })) return {};
    return values;
}

void addTarget(Mesh& mesh, const tinygltf::Model& gltf, const std::map<std::string, int>& target, double weight)
{
    const std::size_t n = mesh.vertices.size();
    const std::vector<float> positions = valuesOf(gltf, target, "POSITION", n, 3);
    const std::vector<float> normals = valuesOf(gltf, target, "NORMAL", n, 3);
    for (std::size_t i = 0; i < n; ++i) {
        if (!positions.empty())
            mesh.vertices[i].position += static_cast<float>(weight) * glm::make_vec3(positions.data() + 3 * i);
        if (!normals.empty())
            mesh.vertices[i].normal += static_cast<float>(weight) * glm::make_vec3(normals.data() + 3 * i);
    }
}

/// Four joints per vertex, with their weights.
struct Influences {
    std::vector<float> joints, weights;
};

/// Returns the complete sets: joints with their weights.
std::vector<Influences> influences(const tinygltf::Model& gltf, const std::map<std::string, int>& attributes,
                                   std::size_t vertices)
{
    std::vector<Influences> sets;
    for (const auto& [name, accessor] : attributes) {
        if (!name.starts_with("JOINTS_") || !GltfPose::takesSet(name.substr(7))) continue;
        Influences set{valuesOf(gltf, attributes, name, vertices, 4),
                       valuesOf(gltf, attributes, "WEIGHTS_" + name.substr(7), vertices, 4)};
        if (!set.joints.empty() && !set.weights.empty()) sets.push_back(std::move(set));
    }
    return sets;
}

}  // namespace

void GltfPose::deform(Mesh& mesh, const tinygltf::Model& gltf, const tinygltf::Primitive& primitive, int node) const
{
    const auto at = static_cast<std::size_t>(node);
    const std::vector<double>& weights = weightsOfNode[at];
    for (std::size_t k = 0; k < std::min(weights.size(), primitive.targets.size()); ++k)
        if (weights[k] != 0) addTarget(mesh, gltf, primitive.targets[k], weights[k]);
    for (Vertex& v : mesh.vertices) v.normal = unitOr(glm::dvec3(v.normal), {0, 1, 0});
    const std::vector<glm::dmat4>& joints = jointsOfNode[at];
    const std::size_t n = mesh.vertices.size();
    const std::vector<Influences> sets = influences(gltf, primitive.attributes, n);
    if (joints.empty() || sets.empty()) return;
    for (std::size_t i = 0; i < n; ++i) {
        glm::dmat4 m(0);
        double sum = 0;
        for (const Influences& set : sets)
            for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
                const auto joint = static_cast<std::size_t>(std::max(set.joints[k], 0.0F));
                if (set.weights[k] <= 0 || joint >= joints.size()) continue;
                m += joints[joint] * static_cast<double>(set.weights[k]);
                sum += static_cast<double>(set.weights[k]);
            }
        if (!(sum > 0)) continue;
        m *= 1 / sum;
        Vertex& v = mesh.vertices[i];
        v.position = glm::vec3(m * glm::dvec4(glm::dvec3(v.position), 1));
        const glm::dmat3 linear(m);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        v.normal = unitOr(cofactors * glm::dvec3(v.normal), v.normal);
        v.tangent = glm::vec4(unitOr(linear * glm::dvec3(v.tangent), glm::vec3(v.tangent)), v.tangent.w);
    }
}

}  // namespace vitrine::render
