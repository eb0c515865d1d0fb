#include "exhibits/kit/surface_draw.h"

#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

std::shared_ptr<const render::Texture> pixel(std::string name, std::vector<std::uint8_t> rgba)
{
    auto texture = std::make_shared<render::Texture>();
    texture->name = std::move(name);
    texture->width = texture->height = 1;
    texture->bytes = std::move(rgba);
    texture->mipmaps = false;
    return texture;
}

const std::shared_ptr<const render::Texture>& orNeutral(const std::shared_ptr<const render::Texture>& map, int unit)
{
    static const auto white = pixel("white", {255, 255, 255, 255});
    static const auto flat = pixel("flat normal", {128, 128, 255, 255});
    if (map) return map;
    return unit == UNIT_NORMAL ? flat : white;
}

}  // namespace

glm::dmat3 normalMatrix(const glm::dmat3& m)
{
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double largest = std::max({glm::length(cofactors[0]), glm::length(cofactors[1]), glm::length(cofactors[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return glm::dmat3(1);
    return cofactors * ((glm::determinant(m) < 0 ? -1 : 1) / largest);
}

bool isMirrored(const glm::dmat4& worldFromModel)
{
    return glm::determinant(glm::dmat3(worldFromModel)) < 0;
}

SurfaceObject surfaceObject(const glm::dmat4& worldFromModel, const render::Material& material, double textureTile)
{
    SurfaceObject object;
    object.worldFromModel = glm::mat4(worldFromModel);
    object.worldFromModelNormals = glm::mat4(glm::dmat4(normalMatrix(glm::dmat3(worldFromModel))));
    object.baseColor = material.baseColor;
    const auto& onExtra = material.onExtra;
    const bool packedOcclusion = material.occlusionMap && material.occlusionMap == material.metallicRoughnessMap &&
                                 onExtra.occlusion == onExtra.metallicRoughness;
    object.occlusionStrength = packedOcclusion || material.surfaceMap ? material.occlusionStrength : 0.0F;
    object.ownOcclusionStrength = material.occlusionMap && !packedOcclusion ? material.occlusionStrength : 0.0F;
    object.metalness = material.metalness;
    object.roughness = material.roughness;
    object.specular = 0.5F;
    object.normalScale = std::clamp(material.normalScale, -100.0F, 100.0F);
    object.emissive = material.emissive;
    object.alphaCutoff = material.alphaMode == render::AlphaMode::mask ? material.alphaCutoff : -1.0F;
    object.textureRepeats = static_cast<float>(1 / textureTile);
    object.secondUv = (onExtra.baseColor ? mapBaseColor : 0) | (onExtra.metallicRoughness ? mapRoughness : 0) |
                      (onExtra.occlusion ? mapOcclusion : 0) | (onExtra.emissive ? mapEmissive : 0);
    object.unlit = material.unlit;
    return object;
}

void addMaterialDefines(const render::Material& material, std::vector<std::string>& defines)
{
    const auto add = [&](bool wanted, const char* define) {
        if (wanted && std::find(defines.begin(), defines.end(), define) == defines.end()) defines.emplace_back(define);
    };
    add(material.onExtra.any(), "SECOND_UV");
    add(material.unlit, "UNLIT");
}

render::Draw surfaceDraw(std::shared_ptr<const render::Mesh> mesh, const glm::dmat4& worldFromModel,
                         const render::Material& material, double textureTile)
{
    render::Draw draw;
    draw.mesh = std::move(mesh);
    draw.mirrored = isMirrored(worldFromModel);
    draw.object = render::std140Bytes(surfaceObject(worldFromModel, material, textureTile));
    draw.inputs = {
        {UNIT_BASE_COLOR, orNeutral(material.baseColorMap, UNIT_BASE_COLOR)},
        {UNIT_NORMAL, orNeutral(material.surfaceMap ? material.surfaceMap : material.normalMap, UNIT_NORMAL)},
        {UNIT_ORM, orNeutral(material.metallicRoughnessMap, UNIT_ORM)},
        {UNIT_EMISSIVE, orNeutral(material.emissiveMap, UNIT_EMISSIVE)},
        {UNIT_OCCLUSION, orNeutral(material.occlusionMap, UNIT_OCCLUSION)}};
    return draw;
}

std::vector<render::Draw> farToNear(const std::vector<TranslucentPart>& parts, const glm::dvec3& eye)
{
    struct Face {
        double distance;
        render::Draw draw;
    };
    std::vector<Face> faces;
    for (const TranslucentPart& part : parts) {
        const glm::dvec3 nearest = glm::clamp(eye, part.box.low, part.box.high);
        if (part.doubleSided) {
            faces.push_back({part.box.farthest(eye), part.draw});
            faces.back().draw.cull = render::Cull::front;
        }
        faces.push_back({glm::distance(nearest, eye), part.draw});
        faces.back().draw.cull = render::Cull::back;
    }
    std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.distance > b.distance; });
    std::vector<render::Draw> draws;
    draws.reserve(faces.size());
    for (Face& face : faces) draws.push_back(std::move(face.draw));
    return draws;
}

std::shared_ptr<const render::Mesh> domeMesh()
{
    static const std::shared_ptr<const render::Mesh> dome = [] {
        constexpr int around = 32;
        constexpr int up = 10;
        auto mesh = std::make_shared<render::Mesh>();
        mesh->name = "button";
        for (int j = 0; j <= up; ++j) {
            for (int i = 0; i <= around; ++i) {
                const double phi = 2 * std::numbers::pi * i / around;
                const double theta = 0.5 * std::numbers::pi * j / up;
                const glm::vec3 p(std::cos(phi) * std::cos(theta), std::sin(theta), std::sin(phi) * std::cos(theta));
                mesh->vertices.push_back({p, p, {1, 0, 0, 1}, {}, {}});
            }
        }
        for (std::uint32_t j = 0; j < up; ++j) {
            for (std::uint32_t i = 0; i < around; ++i) {
                const std::uint32_t a = j * (around + 1) + i;
                const std::uint32_t b = a + around + 1;
                mesh->indices.insert(mesh->indices.end(), {a, b, a + 1, a + 1, b, b + 1});
            }
        }
        mesh->bounds = {{-1, 0, -1}, {1, 1, 1}};
        return mesh;
    }();
    return dome;
}

std::shared_ptr<const render::Mesh> boxMesh()
{
    static const std::shared_ptr<const render::Mesh> box = [] {
        auto mesh = std::make_shared<render::Mesh>();
        mesh->name = "box";
        for (int axis = 0; axis < 3; ++axis) {
            for (const float side : {-1.0F, 1.0F}) {
                glm::vec3 n(0), u(0), v(0);
                n[axis] = side;
                u[(axis + 1) % 3] = side;
                v[(axis + 2) % 3] = 1;
                const auto first = static_cast<std::uint32_t>(mesh->vertices.size());
                for (const glm::vec2 c : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
                    mesh->vertices.push_back({n + u * c.x + v * c.y, n, glm::vec4(u, 1), c * 0.5F + 0.5F, {}});
                mesh->indices.insert(mesh->indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
            }
        }
        mesh->bounds = {glm::dvec3(-1), glm::dvec3(1)};
        return mesh;
    }();
    return box;
}

}  // namespace vitrine
