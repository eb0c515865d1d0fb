#include "exhibits/hall/hall_model.h"

#include "exhibits/hall/wall_frame.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/scene/gltf.h"
#include "render/scene/mesh_shading.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <future>
#include <map>

namespace vitrine {
namespace {

using render::Json;

const render::Box unitBox{glm::dvec3(-1), glm::dvec3(1)};

/// Returns the number in a name such as "cloth_7" or "plaque_free" for the prefix "cloth_" or "plaque_".
std::optional<int> placeNumber(const std::string& name, const std::string& prefix)
{
    if (name.rfind(prefix, 0) != 0) return std::nullopt;
    const std::string rest = name.substr(prefix.size());
    if (rest.rfind("free", 0) == 0) return freePlinthPlace;
    int number = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
    return number >= 1 && number < freePlinthPlace ? std::optional(number) : std::nullopt;
}

glm::dvec3 axisScale(const glm::dmat4& m)
{
    return {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
}

/// Returns the rotation and translation of a transform, without its scale.
glm::dmat4 rigid(const glm::dmat4& m)
{
    const glm::dvec3 s = glm::max(axisScale(m), glm::dvec3(1e-12));
    return {m[0] / s.x, m[1] / s.y, m[2] / s.z, m[3]};
}

using TextureInTheMaking = std::future<std::shared_ptr<const render::Texture>>;

/// Reads a texture on another thread: textures are most of the loading time of the hall.
TextureInTheMaking map(const Json& row, const char* key, bool sRgb)
{
    const auto file = row.find(key);
    if (file == row.end() || !file->is_string()) return {};
    return std::async(std::launch::async, [path = render::asset("models/" + file->get<std::string>()), sRgb] {
        return render::loadTexture(path, sRgb, true);
    });
}

std::shared_ptr<const render::Texture> made(TextureInTheMaking& texture)
{
    return texture.valid() ? texture.get() : nullptr;
}

/// Adds tangents. The hall's file names no textures, so the loader made none, but its normal maps need them.
render::MeshInstance withTangents(render::MeshInstance part, const HallMaterial& material)
{
    if (!material.material.normalMap) return part;
    auto mesh = std::make_shared<render::Mesh>(*part.mesh);
    render::makeTangents(*mesh);
    part.mesh = mesh;
    return part;
}

Json readAsset(const char* relative)
{
    return render::readJson(render::asset(relative)).root();
}

}  // namespace

HallModel::HallModel()
{
    std::future<render::Model> geometry =
        std::async(std::launch::async, [] { return render::loadGltf(render::asset("models/hall.glb")); });
    try {
        std::future<void> lightmaps = std::async(std::launch::async, [this] { readLightmaps(); });
        readMaterials();
        lightmaps.get();
        addFrames();
    } catch (const Json::exception& error) {
        throw Failure(
            ErrorKind::file,
            "assets/models/materials.json, frames.json, hall_light.json, hall_bounce.json or hall_lamps.json: " +
                std::string(error.what()) +
                "; reinstall the program, or write them anew with the scripts beside them.");
    }
    const render::Model model = geometry.get();
    sortParts(model);
    sortMarkers(model);
    furniture_ = furnitureOf(*this);
    for (auto& [number, place] : places_) {
        place.clothShapes = shapesOf(*this, place.cloth);
        place.standShapes = shapesOf(*this, place.stand);
    }
}

void HallModel::readMaterials()
{
    const Json table = readAsset("models/materials.json");
    struct Maps {
        TextureInTheMaking baseColor, normal, metallicRoughness;
    };
    std::map<std::string, Maps> maps;
    for (const auto& [name, row] : table.items()) {
        HallMaterial entry;
        entry.tile = row.value("tile", 1.0);
        entry.material.name = name;
        entry.material.metalness = row.value("metalness", 0.0F);
        entry.material.roughness = row.value("roughness", 0.7F);
        if (const auto color = row.find("baseColor"); color != row.end())
            entry.material.baseColor = {(*color)[0].get<float>(), (*color)[1].get<float>(), (*color)[2].get<float>(),
                                        1.0F};
        const Json& mean = row.at("mean").at("baseColor");
        entry.meanColor = {mean[0].get<double>(), mean[1].get<double>(), mean[2].get<double>()};
        maps[name] = {map(row, "color", true), map(row, "normal", false), map(row, "orm", false)};
        materials_.emplace(name, std::move(entry));
    }
    for (auto& [name, making] : maps) {
        render::Material& material = materials_.at(name).material;
        material.baseColorMap = made(making.baseColor);
        material.normalMap = made(making.normal);
        material.metallicRoughnessMap = made(making.metallicRoughness);
    }
}

void HallModel::readLightmaps()
{
    const Json table = readAsset("models/hall_light.json");
    auto picture = std::make_shared<render::Texture>(
        *render::loadTexture(render::asset("models/" + table.at("sky").at("file").get<std::string>()), false, false));
    picture->mipmaps = false;
    skyLightmap_ = picture;
    skyLightmapScale_ = table.at("sky").at("scale").get<double>();
    sunTransfer_ = SunTransfer(readAsset("models/hall_bounce.json"));
    lampLight_ = LampLight(readAsset("models/hall_lamps.json"));
}

void HallModel::addFrames()
{
    const Json frames = readAsset("models/frames.json");
    for (const Json& json : frames) {
        const int number = json.at("place").get<int>();
        const auto position = json.at("position").get<std::array<double, 3>>();
        WallFrame frame;
        frame.opening = {json.at("width").get<double>(), json.at("height").get<double>()};
        const glm::dmat4 worldFromFrame =
            glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(position[0], position[1], position[2])),
                        glm::radians(json.at("degrees").get<double>()), glm::dvec3(0, 1, 0));
        Place& place = places_[number];
        place.worldFromPlace = worldFromFrame;
        place.worldFromPlaque = worldFromFrame * plaqueBeside(frame);
        const auto part = [&](std::shared_ptr<const render::Mesh> mesh, const char* materialName) {
            auto material = std::make_shared<render::Material>(this->material(materialName).material);
            return render::MeshInstance{"frame_" + std::to_string(number), std::move(mesh), std::move(material),
                                        worldFromFrame};
        };
        const render::MeshInstance border = part(frameMesh(frame), "bronze"), panel = part(panelMesh(frame), "dark");
        place.stand = {border};
        place.cloth = {border, panel};
    }
}

void HallModel::sortParts(const render::Model& model)
{
    for (const render::MeshInstance& part : model.parts) {
        if (const auto n = placeNumber(part.name, "cloth_"))
            places_[*n].cloth.push_back(part);
        else if (const auto m = placeNumber(part.name, "stand_"))
            places_[*m].stand.push_back(part);
        else if (const auto h = placeNumber(part.name, "hanging_"))
            places_[*h].hanging.push_back(part);
        else if (part.name.rfind("hall_", 0) == 0) {
            walls_.push_back(withTangents(part, material(part.material ? part.material->name : std::string())));
            const render::Box box = part.mesh->bounds.transformed(part.modelFromPart);
            bounds_.include(box.low);
            bounds_.include(box.high);
        }
    }
}

void HallModel::sortMarkers(const render::Model& model)
{
    for (const render::Marker& marker : model.markers) {
        const glm::dmat4& m = marker.modelFromMarker;
        if (const auto n = placeNumber(marker.name, "place_"))
            places_[*n].worldFromPlace = rigid(m);
        else if (const auto p = placeNumber(marker.name, "plaque_"))
            places_[*p].worldFromPlaque = rigid(m);
        else if (const auto b = placeNumber(marker.name, "button_"))
            places_[*b].worldFromButton = rigid(m);
        else if (marker.name.rfind("opening_", 0) == 0)
            openings_.push_back(unitBox.transformed(m));
        else if (marker.name == "room")
            room_ = unitBox.transformed(m);
        else if (marker.name == "probe")
            probe_ = glm::dvec3(m[3]);
        else if (marker.name == "probe_room")
            probeRoom_ = unitBox.transformed(m);
        else if (marker.name.rfind("collider_box_", 0) == 0)
            colliders_.push_back({glm::inverse(rigid(m)), axisScale(m), false});
        else if (marker.name.rfind("collider_cylinder_", 0) == 0)
            colliders_.push_back({glm::inverse(rigid(m)), axisScale(m), true});
        else if (marker.name.rfind("occluder_", 0) == 0)
            occluders_.push_back({glm::dvec3(m[3]), glm::dvec3(m[0]), glm::dvec3(m[1])});
    }
    for (auto& [number, place] : places_) place.number = number;
    if (openings_.empty() || room_.empty() || !probe_ || probeRoom_.empty())
        throw Failure(
            ErrorKind::file,
            "assets/models/hall.glb: it has no nodes \"opening_...\", \"room\", \"probe\" and \"probe_room\"; "
            "reinstall the program, or make it anew with assets/models/hall.py.");
}

const HallMaterial& HallModel::material(const std::string& name) const
{
    const auto found = materials_.find(name);
    static const HallMaterial plain;
    return found == materials_.end() ? plain : found->second;
}

const Place* HallModel::place(int number) const
{
    const auto found = places_.find(number);
    return found == places_.end() ? nullptr : &found->second;
}

}  // namespace vitrine
