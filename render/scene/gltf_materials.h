#pragma once

#include "render/files/strict_json.h"
#include "render/scene/gltf_limits.h"
#include "render/scene/mesh.h"
#include "render/scene/tinygltf.h"

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

/// Materials and pictures of a validated file, each converted once.
class GltfMaterials {
public:
    GltfMaterials(const tinygltf::Model&, const JsonDocument&, const GltfLimits&, const std::function<bool()>& canceled,
                  Warnings&);

    /// Material `i`, or glTF's default material for -1.
    [[nodiscard]] std::shared_ptr<const Material> material(int i);

private:
    enum class Content : unsigned char { color, data };
    /// Sampler state of a picture; the members are those of `Texture`.
    struct Sampling {
        bool repeat = true, mipmaps = true, magnifyNearest = false, minifyNearest = false, nearestLevel = false;
        auto operator<=>(const Sampling&) const = default;
    };
    using TextureKey = std::tuple<int, Content, Sampling>;  // The first element is the index of the image.

    Material convert(const tinygltf::Material&);
    [[nodiscard]] Sampling samplingOf(const tinygltf::Texture&, const Message& user);
    std::shared_ptr<const Texture> texture(int index, int texCoord, Content, const Message& user);
    std::shared_ptr<const Texture> picture(const TextureKey&);
    [[nodiscard]] std::string_view bytesOf(const tinygltf::Image&) const;

    const tinygltf::Model& model_;
    const JsonDocument& document_;
    const GltfLimits& limits_;
    const std::function<bool()>& canceled_;
    Warnings& warnings_;
    std::map<int, std::shared_ptr<const Material>> materials_;
    std::map<TextureKey, std::shared_ptr<const Texture>> textures_;
    std::uint64_t textureBytes_ = 0;
};

}  // namespace vitrine::render
