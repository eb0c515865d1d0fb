#include "render/scene/gltf_materials.h"

#include "render/failure.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

float unit(double x)
{
    return static_cast<float>(std::clamp(x, 0.0, 1.0));
}

AlphaMode alphaModeOf(const std::string& name)
{
    if (name == "MASK") return AlphaMode::mask;
    return name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

double emissiveStrength(const tinygltf::Material& m)
{
    const auto extension = m.extensions.find("KHR_materials_emissive_strength");
    if (extension == m.extensions.end() || !extension->second.Has("emissiveStrength")) return 1;
    const tinygltf::Value& value = extension->second.Get("emissiveStrength");
    const double strength = value.IsNumber() ? value.GetNumberAsDouble() : 1;
    return std::isfinite(strength) ? std::clamp(strength, 0.0, 1e6) : 1;
}

/// Coordinates of the file's first and second set, unchanged.
constexpr MapPlaces plainPlaces{MapPlace{0}, MapPlace{1}};

/// Returns a member that is a finite number, else `otherwise`.
double numberIn(const tinygltf::Value& object, const char* key, double otherwise)
{
    const tinygltf::Value& value = object.Get(key);
    const double number = value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
    return std::isfinite(number) ? number : otherwise;
}

glm::dvec2 pairIn(const tinygltf::Value& object, const char* key, const glm::dvec2& otherwise)
{
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsArray() || value.ArrayLen() != 2 || !value.Get(0).IsNumber() || !value.Get(1).IsNumber())
        return otherwise;
    const glm::dvec2 pair(value.Get(0).GetNumberAsDouble(), value.Get(1).GetNumberAsDouble());
    return std::isfinite(pair.x) && std::isfinite(pair.y) ? pair : otherwise;
}

std::string named(const std::string& name, std::size_t i)
{
    return name.empty() ? std::to_string(i) : name;
}

}  // namespace

glm::vec2 MapPlace::at(const glm::vec2& uv) const
{
    if (isPlain()) return uv;
    // Rotates counter-clockwise in coordinates whose v points down, as the examples of the extension do.
    const glm::dvec2 scaled = scale * glm::dvec2(uv);
    const double c = std::cos(rotation), s = std::sin(rotation);
    return glm::vec2(offset + glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x));
}

void Warnings::add(const Message& sentence)
{
    constexpr std::size_t most = 100;
    if (list_.size() >= most || std::find(list_.begin(), list_.end(), sentence) != list_.end()) return;
    list_.push_back(sentence);
}

GltfMaterials::GltfMaterials(const tinygltf::Model& model, const JsonDocument& document, const GltfLimits& limits,
                             const std::function<bool()>& canceled, Warnings& warnings)
    : model_(model), document_(document), limits_(limits), canceled_(canceled), warnings_(warnings)
{
}

std::shared_ptr<const Material> GltfMaterials::material(int i)
{
    std::shared_ptr<const Material>& material = materials_[i];
    if (!material) {
        const auto index = static_cast<std::size_t>(std::max(i, 0));
        MapPlaces& places = places_[i] = plainPlaces;
        material = std::make_shared<const Material>(i < 0 ? Material{} : convert(model_.materials[index], places));
    }
    return material;
}

Material GltfMaterials::convert(const tinygltf::Material& m, MapPlaces& places)
{
    const auto& pbr = m.pbrMetallicRoughness;
    Material out;
    out.name = m.name;
    if (pbr.baseColorFactor.size() == 4) {
        const auto& c = pbr.baseColorFactor;
        out.baseColor = glm::vec4(unit(c[0]), unit(c[1]), unit(c[2]), unit(c[3]));
    }
    out.metalness = unit(pbr.metallicFactor);
    out.roughness = unit(pbr.roughnessFactor);
    out.normalScale = static_cast<float>(m.normalTexture.scale);
    out.occlusionStrength = unit(m.occlusionTexture.strength);
    if (m.emissiveFactor.size() == 3) {
        const auto strength = static_cast<float>(emissiveStrength(m));
        out.emissive =
            strength * glm::vec3(unit(m.emissiveFactor[0]), unit(m.emissiveFactor[1]), unit(m.emissiveFactor[2]));
    }
    out.alphaMode = alphaModeOf(m.alphaMode);
    out.alphaCutoff = unit(m.alphaCutoff);
    out.doubleSided = m.doubleSided;
    out.unlit = m.extensions.contains("KHR_materials_unlit");
    const Message user = m.name.empty() ? message("material without a name") : message("material {1}", m.name);
    out.baseColorMap = texture(pbr.baseColorTexture.index, Content::color, user);
    out.metallicRoughnessMap = texture(pbr.metallicRoughnessTexture.index, Content::data, user);
    out.normalMap = texture(m.normalTexture.index, Content::data, user);
    out.occlusionMap = texture(m.occlusionTexture.index, Content::data, user);
    out.emissiveMap = texture(m.emissiveTexture.index, Content::color, user);
    place(m, user, out, places);
    return out;
}

MapPlace GltfMaterials::placeOf(int texCoord, const tinygltf::ExtensionMap& extensions, const Message& user)
{
    MapPlace place{texCoord};
    const auto extension = extensions.find("KHR_texture_transform");
    if (extension != extensions.end() && extension->second.IsObject()) {
        const tinygltf::Value& transform = extension->second;
        place.offset = pairIn(transform, "offset", place.offset);
        place.scale = pairIn(transform, "scale", place.scale);
        place.rotation = numberIn(transform, "rotation", 0);
        place.set = static_cast<int>(std::clamp(numberIn(transform, "texCoord", texCoord), 0.0, 1e6));
    }
    if (place.set > 1) {
        warnings_.add(
            message("A texture of {1} uses texture coordinates after the second set; the first set is used.", user));
        place.set = 0;
    }
    return place;
}

/// Assigns the maps to at most two places, that of the normal map first, because tangents belong to it.
void GltfMaterials::place(const tinygltf::Material& m, const Message& user, Material& out, MapPlaces& places)
{
    bool normalOnExtra = false;
    std::size_t count = 0;
    const auto assign = [&](const auto& info, const std::shared_ptr<const Texture>& map, bool& onExtra) {
        if (!map) return;
        const MapPlace place = placeOf(info.texCoord, info.extensions, user);
        const auto* const end = places.begin() + count;
        const auto* found = std::find(static_cast<const MapPlace*>(places.begin()), end, place);
        if (found == end && count == places.size()) {
            warnings_.add(message(
                "The textures of {1} have more than two different transforms; the third one uses the first.", user));
            found = places.begin();
        } else if (found == end) {
            places.at(count++) = place;
        }
        onExtra = found != places.begin();
    };
    const auto& pbr = m.pbrMetallicRoughness;
    assign(m.normalTexture, out.normalMap, normalOnExtra);
    assign(pbr.baseColorTexture, out.baseColorMap, out.onExtra.baseColor);
    assign(pbr.metallicRoughnessTexture, out.metallicRoughnessMap, out.onExtra.metallicRoughness);
    assign(m.occlusionTexture, out.occlusionMap, out.onExtra.occlusion);
    assign(m.emissiveTexture, out.emissiveMap, out.onExtra.emissive);
}

GltfMaterials::Sampling GltfMaterials::samplingOf(const tinygltf::Texture& t, const Message& user)
{
    Sampling sampling;
    if (t.sampler < 0) return sampling;
    const tinygltf::Sampler& s = model_.samplers[static_cast<std::size_t>(t.sampler)];
    sampling.repeat = s.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    if (s.wrapS != s.wrapT)
        warnings_.add(message("A texture of {1} wraps differently along u and v; both wrap as u does.", user));
    if (s.wrapS == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT)
        warnings_.add(message("Mirrored repeat is not supported; textures repeat."));
    const int minify = s.minFilter;
    sampling.magnifyNearest = s.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    sampling.mipmaps = minify != TINYGLTF_TEXTURE_FILTER_NEAREST && minify != TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampling.nearestLevel = minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                            minify == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST;
    sampling.minifyNearest = minify == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                             minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                             minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
    return sampling;
}

std::shared_ptr<const Texture> GltfMaterials::texture(int index, Content content, const Message& user)
{
    if (index < 0) return nullptr;
    const tinygltf::Texture& t = model_.textures[static_cast<std::size_t>(index)];
    if (t.source < 0) {
        warnings_.add(message("A texture of {1} has no picture of a known kind and is left out.", user));
        return nullptr;
    }
    const TextureKey key{t.source, content, samplingOf(t, user)};
    const auto known = textures_.find(key);
    if (known != textures_.end()) return known->second;
    return textures_[key] = picture(key);
}

std::string_view GltfMaterials::bytesOf(const tinygltf::Image& image) const
{
    if (image.bufferView < 0) return {reinterpret_cast<const char*>(image.image.data()), image.image.size()};
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(image.bufferView)];
    const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    return {reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength};
}

std::shared_ptr<const Texture> GltfMaterials::picture(const TextureKey& key)
{
    const auto& [index, content, sampling] = key;
    if (canceled_ && canceled_()) throw document_.failure({}, message("loading was canceled."));
    const tinygltf::Image& image = model_.images[static_cast<std::size_t>(index)];
    const Message shown =
        message("picture {1} of {2}",
                named(image.uri.empty() ? image.name : image.uri, static_cast<std::size_t>(index)), document_.name());
    const std::string_view bytes = bytesOf(image);
    if (bytes.empty()) {
        warnings_.add(message("The {1} is missing and is left out.", shown));
        return nullptr;
    }
    try {
        ImageLimits limits;
        limits.decodedBytes = limits_.textureBytes - textureBytes_;  // The limit is checked before anything is decoded.
        const auto texture = textureFromBytes(bytes, shown.english(),
                                              {.sRgb = content == Content::color,
                                               .repeat = sampling.repeat,
                                               .mipmaps = sampling.mipmaps,
                                               .obeysFile = false},
                                              limits);
        texture->magnifyNearest = sampling.magnifyNearest;
        texture->minifyNearest = sampling.minifyNearest;
        texture->nearestLevel = sampling.nearestLevel;
        textureBytes_ +=
            std::min<std::uint64_t>(texture->bytes.size() + 4 * texture->floats.size(), limits.decodedBytes);
        return texture;
    } catch (const Failure& failure) {
        warnings_.add(message("It is left out: {1}", failure.message()));
        return nullptr;
    }
}

}  // namespace vitrine::render
