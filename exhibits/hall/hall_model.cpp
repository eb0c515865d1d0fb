#include "exhibits/hall/hall_model.h"

#include "exhibits/hall/wall_frame.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/plan/frame_plan.h"
#include "render/scene/gltf.h"
#include "render/scene/mesh_shading.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <future>
#include <map>

namespace vitrine::hall {
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

/// Adds tangents. The hall's file names no textures, so the loader made none, but its normal maps need them.
render::MeshInstance withTangents(render::MeshInstance part, const HallMaterial& material)
{
    if (!material.hasNormalMap) return part;
    auto mesh = std::make_shared<render::Mesh>(*part.mesh);
    render::makeTangents(*mesh);
    part.mesh = mesh;
    return part;
}

std::shared_ptr<const std::vector<glm::vec3>> sampledCorners(std::span<const render::MeshInstance> parts)
{
    auto corners = std::make_shared<std::vector<glm::vec3>>();
    for (const render::MeshInstance& part : parts) {
        if (isFloor(part)) continue;
        const std::vector<std::uint32_t>& indices = part.mesh->indices;
        for (std::size_t i = 0; i < indices.size(); i += 3 * render::Pass::trianglesPerSample)
            corners->push_back(part.modelFromPart * glm::dvec4(part.mesh->vertices[indices[i]].position, 1));
    }
    return corners;
}

Json readAsset(const char* relative)
{
    return render::readJson(render::asset(relative)).root();
}

}  // namespace

bool isFloor(const render::MeshInstance& part)
{
    return part.material && part.material->name == "terrazzo";
}

HallModel::HallModel()
{
    std::future<render::Model> geometry =
        std::async(std::launch::async, [] { return render::loadGltf(render::asset("models/hall.glb")); });
    try {
        surfaces_ = std::make_unique<const HallSurfaces>();
        addFrames();
    } catch (const Json::exception& error) {
        throw Failure(ErrorKind::file,
                      "assets/models/materials.json, frames.json or hall_light.json: " + std::string(error.what()) +
                          "; reinstall the program, or write them anew with the scripts beside them.");
    }
    const render::Model model = geometry.get();
    sortParts(model);
    samples_ = sampledCorners(walls_);
    sortMarkers(model);
    furniture_ = furnitureOf(*this);
    for (auto& [number, place] : places_) {
        place.clothShapes = shapesOf(*this, place.cloth);
        place.standShapes = shapesOf(*this, place.stand);
    }
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
            auto material = std::make_shared<render::Material>(surfaces_->untextured(materialName).material);
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
            walls_.push_back(
                withTangents(part, surfaces_->untextured(part.material ? part.material->name : std::string())));
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

const Place* HallModel::place(int number) const
{
    const auto found = places_.find(number);
    return found == places_.end() ? nullptr : &found->second;
}

}  // namespace vitrine::hall
