#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/mesh.h"
#include "render/scene/tinygltf.h"

#include <array>
#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace vitrine::render {

/// List of sentences without repetition, at most 100.
class Warnings {
public:
    explicit Warnings(std::vector<Message>& list) : list_(list) {}
    void add(const Message& sentence);

private:
    std::vector<Message>& list_;
};

/// Texture coordinates of a map: a set of the file, and its KHR_texture_transform.
struct MapPlace {
    int set = 0;
    glm::dvec2 offset{0}, scale{1};
    double rotation = 0;  ///< Radians.

    [[nodiscard]] bool isPlain() const { return *this == MapPlace{set}; }
    /// Returns the coordinates for those of the set.
    [[nodiscard]] glm::vec2 at(const glm::vec2& uv) const;
    bool operator==(const MapPlace&) const = default;
};
/// The texture coordinates of a material's maps: those of `Vertex::uv` and those of `Vertex::extra`.
using MapPlaces = std::array<MapPlace, 2>;

/// Materials and pictures of a validated file, each converted once.
class GltfMaterials {
public:
    GltfMaterials(const tinygltf::Model&, const JsonDocument&, const GltfLimits&, const std::function<bool()>& canceled,
                  Warnings&);

    /// Material `i`, or glTF's default material for -1.
    [[nodiscard]] std::shared_ptr<const Material> material(int i);
    /// Texture coordinates that material `i` needs. `material(i)` comes first.
    [[nodiscard]] const MapPlaces& places(int i) const { return places_.at(i); }

private:
    enum class Content : unsigned char { color, data };
    /// Sampler state of a picture; the members are those of `Texture`.
    struct Sampling {
        bool repeat = true, mipmaps = true, magnifyNearest = false, minifyNearest = false, nearestLevel = false;
        auto operator<=>(const Sampling&) const = default;
    };
    using TextureKey = std::tuple<int, Content, Sampling>;  // The first element is the index of the image.

    Material convert(const tinygltf::Material&, MapPlaces&);
    void place(const tinygltf::Material&, const Message& user, Material&, MapPlaces&);
    [[nodiscard]] MapPlace placeOf(int texCoord, const tinygltf::ExtensionMap&, const Message& user);
    [[nodiscard]] Sampling samplingOf(const tinygltf::Texture&, const Message& user);
    std::shared_ptr<const Texture> texture(int index, Content, const Message& user);
    std::shared_ptr<const Texture> picture(const TextureKey&);
    [[nodiscard]] std::string_view bytesOf(const tinygltf::Image&) const;

    const tinygltf::Model& model_;
    const JsonDocument& document_;
    const GltfLimits& limits_;
    const std::function<bool()>& canceled_;
    Warnings& warnings_;
    std::map<int, std::shared_ptr<const Material>> materials_;
    std::map<int, MapPlaces> places_;
    std::map<TextureKey, std::shared_ptr<const Texture>> textures_;
    std::uint64_t textureBytes_ = 0;
};

}  // namespace vitrine::render
