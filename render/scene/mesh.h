#pragma once

#include "render/image/texture.h"
#include "render/text/message.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// Axis-aligned box; empty while low > high.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    [[nodiscard]] glm::dvec3 center() const { return 0.5 * (low + high); }
    [[nodiscard]] glm::dvec3 halfSize() const { return 0.5 * (high - low); }
    /// Returns whether the box contains `p`; its faces count as inside.
    [[nodiscard]] bool contains(const glm::dvec3& p) const { return glm::clamp(p, low, high) == p; }
    void include(const glm::dvec3& p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    /// Returns the part that both boxes contain; empty if there is none.
    [[nodiscard]] Box intersection(const Box& other) const
    {
        return {glm::max(low, other.low), glm::min(high, other.high)};
    }
    /// Returns the distance from `p` to the farthest corner.
    [[nodiscard]] double farthest(const glm::dvec3& p) const
    {
        return glm::length(glm::max(glm::abs(low - p), glm::abs(high - p)));
    }
    /// Returns the smallest axis-aligned box that contains the transformed box.
    [[nodiscard]] Box transformed(const glm::dmat4& transform) const;
};

/// The single vertex layout of all shaders. Locations 0 to 4, in this order.
struct Vertex {
    glm::vec3 position{0};
    glm::vec3 normal{0, 1, 0};
    glm::vec4 tangent{1, 0, 0, 1};  ///< w is the sign of the bitangent.
    glm::vec2 uv{0};                ///< TEXCOORD_0.
    /// Two numbers whose meaning depends on the mesh's shader. For glTF: TEXCOORD_1, the coordinates of a lightmap, or
    /// those of the maps of `Material::onExtra`. For a skin under fur: its curvature and a height.
    glm::vec2 extra{0};
};

/// Indexed triangles, counter-clockwise seen from the front. Must not change once shared: the renderer uploads a mesh
/// once and finds it by address.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    Box bounds;
    /// Linear Rec. 709 color and opacity of each vertex, at location 5. Empty: white.
    std::vector<glm::vec4> colors = {};
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// Metallic-roughness material of glTF 2.0; factors are linear.
struct Material {
    std::string name;
    glm::vec4 baseColor{1};
    float metalness = 1;
    float roughness = 1;
    float normalScale = 1;
    float occlusionStrength = 1;
    glm::vec3 emissive{0};
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false;
    bool unlit = false;  ///< KHR_materials_unlit: shows its base color without any light.
    /// Maps that are read at `Vertex::extra` instead of `Vertex::uv`. The normal map is always read at `uv`.
    struct {
        bool baseColor = false, metallicRoughness = false, occlusion = false, emissive = false;

        [[nodiscard]] bool any() const { return baseColor || metallicRoughness || occlusion || emissive; }
    } onExtra;
    std::shared_ptr<const Texture> baseColorMap, metallicRoughnessMap, normalMap, occlusionMap, emissiveMap;
    /// Normal (x, y), roughness and occlusion in one texture. Not in glTF: it replaces the maps of these, and the
    /// metalness has no map.
    std::shared_ptr<const Texture> surfaceMap;
};

/// A mesh with its transform and material. `mirrored` is true if the transform flips orientation (negative
/// determinant).
struct MeshInstance {
    std::string name;  ///< Name of the node.
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Material> material;
    glm::dmat4 modelFromPart{1};
    bool mirrored = false;
};

/// A node without a mesh: a marker that a program reads by name.
struct Marker {
    std::string name;
    glm::dmat4 modelFromMarker{1};
};

/// A loaded glTF scene, flattened.
struct Model {
    std::vector<MeshInstance> parts;
    std::vector<Marker> markers;
    Box bounds;                     ///< Bounds of all parts, in model space.
    std::vector<Message> warnings;  ///< Features of the file that this program does not support, a sentence each.
};

}  // namespace vitrine::render
