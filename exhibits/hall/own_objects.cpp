// The user's own objects: placement, plinths and passes.
#include "exhibits/hall/hall_scene.h"

#include "exhibits/hall/plinth.h"
#include "exhibits/hall/walk.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "render/failure.h"
#include "render/scene/gltf_animation.h"
#include "render/scene/held_bytes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::hall {
namespace {

using render::Draw;
using render::MeshInstance;
using render::Pass;

constexpr const char* plinthMaterial = "travertine";
constexpr double narrowestPlinth = 0.18, widestPlinth = 0.9;  ///< Half the width, meters.

render::AssetStore::Made<render::Model> readModel(const std::string& path)
{
    const render::AnimatedModel file = render::AnimatedModel::load(path);
    auto model = std::make_shared<render::Model>(file.posed(-1, 0));
    if (!file.animations().empty())
        model->warnings.push_back(message("Animations are not played in the hall; the model stands still."));
    if (const Message why = render::whyNothingIsSeen(path, model->bounds); !why.empty())
        throw Failure(ErrorKind::file, why);
    const std::uint64_t bytes = heldBytes(*model);
    return {std::move(model), bytes};
}

/// Returns meters per unit of the model.
double scaleOf(const render::Model& model, double largestSide)
{
    const glm::dvec3 extent = 2.0 * model.bounds.halfSize();
    return largestSide / std::max({extent.x, extent.y, extent.z, 1e-9});
}

/// Returns half the width in meters of the plinth below an object: a little wider than the object.
double plinthHalfWidth(const render::Model& model, double largestSide)
{
    const glm::dvec3 half = model.bounds.halfSize() * scaleOf(model, largestSide);
    return std::clamp(std::max(half.x, half.z) + 0.08, narrowestPlinth, widestPlinth);
}

/// Returns half the width and the height of an object's own plinth in meters; none if it has no plinth. They are
/// rounded to millimeters, so a plinth that grows slowly is not remade for every frame.
std::optional<glm::dvec2> plinthSize(const OwnObjectParameters& rows, const ParameterValues& values,
                                     const render::Model& model)
{
    if (values[rows.modelStand] != ObjectStand::ownPlinth) return std::nullopt;
    const glm::dvec2 size(plinthHalfWidth(model, values[rows.modelSize]), values[rows.modelPlinthHeight]);
    return glm::round(1000.0 * size) / 1000.0;
}

std::shared_ptr<const render::Mesh> plinthFor(const OwnObjectParameters& rows, const ParameterValues& values,
                                              const render::Model& model, render::AssetStore& assets)
{
    const std::optional<glm::dvec2> size = plinthSize(rows, values, model);
    if (!size) return nullptr;
    const std::string key = std::to_string(size->x) + ';' + std::to_string(size->y);
    return assets.made<render::Mesh>("hall.plinth", key, [&] { return makePlinth(size->x, size->y); }).value;
}

/// Returns the transform of the object's base: the top of the free plinth or of its own plinth, or the floor.
glm::dmat4 worldFromStand(const HallModel& hall, const OwnObjectParameters& rows, const ParameterValues& values,
                          const render::Model& model)
{
    if (values[rows.modelStand] == ObjectStand::freePlinth) {
        const Place* free = hall.place(freePlinthPlace);
        return free ? free->worldFromPlace : glm::dmat4(1);
    }
    const double top = plinthSize(rows, values, model).value_or(glm::dvec2(0)).y;
    const glm::dvec2 at = standingPlace(hall.colliders(), {values[rows.modelAcross], values[rows.modelAlong]},
                                        plinthHalfWidth(model, values[rows.modelSize]));
    return glm::translate(glm::dmat4(1), glm::dvec3(at.x, top, at.y));
}

/// Returns upright boxes around the object, as it is rotated, and around its plinth. The box of an object that fills
/// the hall covers only its center, or it would trap the walking user.
std::vector<Collider> collidersOf(const render::Box& turned, const glm::dmat4& worldFromTurned,
                                  const std::optional<glm::dvec2>& plinth)
{
    constexpr double widest = 1.2;
    const glm::dvec3 half = glm::min(turned.halfSize(), glm::dvec3(widest, 100, widest));
    std::vector<Collider> made{
        {glm::translate(glm::dmat4(1), -turned.center()) * glm::inverse(worldFromTurned), half, false}};
    if (plinth) {
        const glm::dvec3 middle(worldFromTurned[3].x, plinth->y / 2, worldFromTurned[3].z);
        made.push_back({glm::translate(glm::dmat4(1), -middle), {plinth->x, plinth->y / 2, plinth->x}, false});
    }
    return made;
}

/// Returns an object at the position of its parameters.
OwnObject standing(const HallModel& hall, std::size_t which, const OwnObjectParameters& rows,
                   const ParameterValues& values, const PreparedObject& prepared)
{
    const render::Model& model = *prepared.model;
    const render::Box& box = model.bounds;
    const glm::dmat4 worldFromTurned =
        glm::rotate(worldFromStand(hall, rows, values, model), values[rows.modelRotation], glm::dvec3(0, 1, 0));
    // The lowest point of the object touches the center of its base.
    const glm::dmat4 turnedFromModel =
        glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(scaleOf(model, values[rows.modelSize]))),
                       -glm::dvec3(box.center().x, box.low.y, box.center().z));
    OwnObject object{which, prepared.model, worldFromTurned * turnedFromModel, {}};
    object.box = box.transformed(object.worldFromModel);
    object.colliders = collidersOf(box.transformed(turnedFromModel), worldFromTurned, plinthSize(rows, values, model));
    if (prepared.plinth) {
        static const auto stone = std::make_shared<const render::Material>(render::Material{.name = plinthMaterial});
        const glm::dvec3 foot(worldFromTurned[3].x, 0, worldFromTurned[3].z);
        object.plinth = MeshInstance{"plinth", prepared.plinth, stone, glm::translate(glm::dmat4(1), foot)};
    }
    return object;
}

void planOwnObject(const HallScene& scene, const OwnObject& object, const SceneLighting& light,
                   const Channels& channels, render::FramePlan& plan)
{
    const bool onFreePlinth = scene.values[scene.table.objects[object.which].modelStand] == ObjectStand::freePlinth;
    Pass pass = surfacePass(
        ownPassName(object.which),
        onFreePlinth ? "an object stands on the free plinth" : "an object of the visitor's stands here", light,
        channels,
        {"BASE_COLOR_MAP", "VERTEX_COLOR", "NORMAL_MAP", "ORM_MAP", "OCCLUSION_MAP", "EMISSIVE_MAP", "ALPHA_MASK"});
    pass.shaded.within = object.box;
    pass.state.cull = render::Cull::none;
    if (isMirror(object)) light.mirrorWorks(pass);
    for (const MeshInstance& part : object.model->parts)
        if (part.material) addMaterialDefines(*part.material, pass.shader.defines);
    pass.depthOnly.reset();  // Alpha-masked textures cut holes into its depth.
    Pass blended = pass;
    blended.name += "/blended";
    blended.phase = render::PassPhase::transparent;
    blended.state.blend = render::Blend::alpha;
    blended.state.depthWrite = false;
    blended.colors.resize(1);
    std::erase_if(blended.shader.defines, [](const std::string& define) { return define.starts_with("WRITE_"); });
    blended.shader.defines.emplace_back("BLENDED");
    std::vector<TranslucentPart> translucent;
    for (const MeshInstance& part : object.model->parts) {
        const render::Material& material = part.material ? *part.material : redPaint();
        const glm::dmat4 place = object.worldFromModel * part.modelFromPart;
        Draw draw = surfaceDraw(part.mesh, place, material);
        if (material.alphaMode == render::AlphaMode::blend)
            translucent.push_back({std::move(draw), part.mesh->bounds.transformed(place), material.doubleSided});
        else
            pass.draws.push_back(std::move(draw));
    }
    blended.draws = farToNear(translucent, plan.view.eye);
    for (const Message& warning : object.model->warnings) plan.warn(pass.name, warning.english());
    if (!pass.draws.empty()) plan.add(std::move(pass));
    if (!blended.draws.empty())
        plan.add(std::move(blended));
    else
        plan.skip(blended.name, "nothing of the visitor's object is translucent");
}

/// Returns why an object has nothing to draw.
std::string whyNone(const HallScene& scene, std::size_t which)
{
    const OwnObjectParameters& rows = scene.table.objects[which];
    if (!scene.values[rows.model].empty()) return "its file has not been read";
    return which == 0 ? "the free plinth is empty" : "no file is chosen for it";
}

}  // namespace

bool isMirror(const OwnObject& object)
{
    return std::any_of(object.model->parts.begin(), object.model->parts.end(), [](const MeshInstance& part) {
        return part.material && static_cast<double>(part.material->roughness) < mirrorRoughness;
    });
}

std::string ownPassName(std::size_t which)
{
    return which == 0 ? "hall/visitor" : "hall/visitor/" + std::to_string(which + 1);
}

std::array<PreparedObject, mostOwnObjects> preparedObjects(const HallTable& table, const ParameterValues& values,
                                                           render::AssetStore& assets, render::Hash& files,
                                                           const ToldUnreadable& unreadable)
{
    std::array<PreparedObject, mostOwnObjects> made;
    for (std::size_t which = 0; which < mostOwnObjects; ++which) {
        const OwnObjectParameters& rows = table.objects[which];
        const std::string path = values[rows.model];
        if (path.empty()) continue;
        const render::Asset<render::Model> found = assets.get<render::Model>("hall.model", path, readModel);
        if (!found.failure.empty()) unreadable(which, found.failure);
        files.addValue(found.id);
        if (found.value) made.at(which) = {found.value, plinthFor(rows, values, *found.value, assets)};
    }
    return made;
}

std::vector<OwnObject> objectsAt(const HallModel& hall, const HallTable& table, const ParameterValues& values,
                                 const std::array<PreparedObject, mostOwnObjects>& prepared)
{
    std::vector<OwnObject> all;
    for (std::size_t which = 0; which < mostOwnObjects; ++which)
        if (prepared.at(which).model)
            all.push_back(standing(hall, which, table.objects[which], values, prepared.at(which)));
    return all;
}

void planOwnObjects(const HallScene& scene, const SceneLighting& light, const Channels& channels,
                    render::FramePlan& plan)
{
    // Objects are drawn from far to near, so translucent parts are blended over what is behind them.
    std::vector<const OwnObject*> farFirst;
    for (const OwnObject& object : scene.objects) farFirst.push_back(&object);
    std::stable_sort(farFirst.begin(), farFirst.end(), [&](const OwnObject* a, const OwnObject* b) {
        return glm::distance(a->box.center(), plan.view.eye) > glm::distance(b->box.center(), plan.view.eye);
    });
    for (std::size_t which = 0; which < mostOwnObjects; ++which)
        if (std::none_of(farFirst.begin(), farFirst.end(), [&](const OwnObject* o) { return o->which == which; }))
            plan.skip(ownPassName(which), whyNone(scene, which));
    for (const OwnObject* object : farFirst) {
        const std::string why = plan.runEverything ? std::string() : whyHidden(scene.model, object->box, plan.view);
        if (why.empty())
            planOwnObject(scene, *object, light, channels, plan);
        else
            plan.skip(ownPassName(object->which), why);
    }
}

std::vector<StandingShape> ownShapes(const HallScene& scene)
{
    std::vector<StandingShape> shapes;
    for (const OwnObject& object : scene.objects) {
        const std::vector<MeshInstance>& parts = object.model->parts;
        if (object.plinth)
            shapes.push_back(moved(
                standingBox(object.plinth->mesh->bounds, scene.model.surfaces().untextured(plinthMaterial).meanColor),
                object.plinth->modelFromPart));
        if (parts.empty()) continue;
        glm::dvec3 color(0);
        for (const MeshInstance& part : parts)
            color += glm::dvec3(part.material ? part.material->baseColor : glm::vec4(0.5F)) /
                     static_cast<double>(parts.size());
        shapes.push_back(moved(standingBox(object.model->bounds, color), object.worldFromModel));
    }
    return shapes;
}

}  // namespace vitrine::hall
