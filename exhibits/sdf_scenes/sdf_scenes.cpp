#include "exhibits/sdf_scenes/sdf_scenes.h"

#include "exhibits/framework/files/file_path.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/table_change.h"
#include "exhibits/kit/panorama.h"
#include "exhibits/sdf_scenes/scene_document.h"
#include "exhibits/sdf_scenes/scene_edit.h"
#include "exhibits/sdf_scenes/scene_evaluator.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/scene_tree.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/scene/held_bytes.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_inverse.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace vitrine::scenes {
namespace {

constexpr const char* firstScene = "scenes/dahlia.json";
constexpr int stepsOfList = 3;  ///< Steps of a cell's list, about; it holds what is near.

struct PreparedScene final : PreparedPart {
    std::shared_ptr<const render::Texture> environment;
    std::string note{};           ///< Sentence for the user if the environment is stretched; else empty.
    std::vector<double> numbers;  ///< Numbers of the scene at the prepared time.
    SceneConstants words;         ///< The same numbers in the layout of the field evaluation.
    SceneEvaluator asked;
    SceneEvaluator askedRight;  ///< For the right half if the opening is divided.
};

/// Returns the position of the divider, in meters to the right of the opening's center.
double dividerAt(double share)
{
    return (2 * share - 1) * Portal().halfSize.x;
}

double secondsAt(const SdfScenesTable& t, const ParameterValues& values, double time)
{
    return values[t.moment] + (values[t.animate] && std::isfinite(time) ? time : 0);
}

double orbitAt(const SdfScenesTable& t, const ParameterValues& values, double time)
{
    const double gone = std::isfinite(time) ? values[t.orbitSpeed] * time : 0;
    return std::remainder(values[t.orbit] + gone, 2 * std::numbers::pi);
}

/// Decides which features the shader has, and records the reasons for those that it lacks.
struct ScenePass {
    const SdfScenesTable& t;
    const ParameterValues& values;
    const ShownScene& shown;
    bool reference;
    std::string steps;  ///< Prefix of the names of its steps.
    render::Pass& pass;
    render::FramePlan& plan;

    void define(std::string text) const { pass.shader.defines.push_back(std::move(text)); }

    void add(bool there, const char* text, const char* step, const char* why) const
    {
        if (there)
            define(text);
        else
            plan.skip(steps + step, why);
    }

    void shadows() const
    {
        const SceneShadow method = values[t.shadowMethod];
        const auto any = render::required(!shown.scene->lights.empty(), "the scene has no lights");
        const auto lit =
            render::required(!reference || shown.contents.litInReference, "no material reflects the lights");
        const std::string dark = render::whyZero({any, lit});
        if (dark.empty())
            define("LIGHTS");
        else
            plan.skip(steps + "lights", dark);
        const std::string why =
            render::whyZero({any, lit, render::required(method != SceneShadow::none, "shadows are switched off")});
        if (why.empty())
            define("SHADOWS " +
                   std::to_string(method == SceneShadow::look ? (reference ? 6 : 4) : static_cast<int>(method) - 1));
        else
            plan.skip(steps + "shadows", why);
    }

    void occlusion() const
    {
        SceneOcclusion method = values[t.occlusionMethod];
        if (method == SceneOcclusion::look && !reference) method = SceneOcclusion::taps;
        if (method == SceneOcclusion::none)
            plan.skip(steps + "occlusion", "ambient occlusion is switched off");
        else
            define("OCCLUSION " + std::to_string(static_cast<int>(method)));
    }

    void all() const
    {
        const SceneContents& has = shown.contents;
        if (reference) define("REFERENCE_SHADING");
        shadows();
        occlusion();
        add(reference ? has.mirrorsInReference : has.mirrors, "MIRRORS", "reflections", "nothing in the scene mirrors");
        add(!reference && has.glass, "GLASS", "glass",
            reference ? "the reference has no glass" : "nothing is made of glass");
        add(!reference && has.lamps, "LAMPS", "lamps",
            reference ? "the reference shows no lamps" : "no light of the scene has an area");
        if (has.glows) define("GLOWS");
        if (values[t.heatMap] != SceneHeatMap::none) define("HEAT_MAP");
        if (values[t.heatMap] == SceneHeatMap::shapes) define("COUNT_SHAPES");
    }
};

}  // namespace

SdfScenes::SdfScenes(const std::filesystem::path& first)
{
    try {
        first_ = readShownScene(first.empty() ? render::asset(firstScene) : first);
    } catch (const Failure& failure) {
        whyNotFirst_ = failure.message();
        const std::string sphere = R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "sphere"}})";
        first_ = shownScene(readScene(sphere, "sphere", {}).scene);
    }
}

const ShownScene& SdfScenes::shown(const ParameterValues& values) const
{
    const auto& table = static_cast<const Table&>(values.table());
    return table.shown ? *table.shown : *first_;
}

std::vector<double> SdfScenes::numbersAt(const ParameterValues& values, double time) const
{
    const auto& table = static_cast<const Table&>(values.table());
    std::vector<double> ofScene;
    for (const Real& row : table.ofScene) ofScene.push_back(values[row]);
    const Scene& scene = *shown(values).scene;
    std::vector<double> numbers = scene.numbersAt(secondsAt(table_, values, time), ofScene);
    const SceneLook look = values[table_.look];
    if (look != SceneLook::scene) numbers[scene.look.numbers] = look == SceneLook::reference ? 1 : 0;
    return numbers;
}

Portal SdfScenes::portalAt(const ParameterValues& values, double time, const std::vector<double>& numbers) const
{
    const ShownScene& scene = shown(values);
    return scenePortal(sceneCamera(*scene.scene, numbers, orbitAt(table_, values, time)), scene.toOpening);
}

Portal SdfScenes::portalAt(const ParameterValues& values, double time) const
{
    return portalAt(values, time, numbersAt(values, time));
}

render::Box SdfScenes::bounds(const ParameterValues&) const
{
    return portalBounds({});
}

render::Camera SdfScenes::bestView(const ParameterValues& values) const
{
    return sceneView(sceneCamera(*shown(values).scene, numbersAt(values, 0), 0).fovY);
}

double SdfScenes::nextChange(const ParameterValues& values, double) const
{
    const bool moves = (values[table_.animate] && shown(values).contents.moves) || values[table_.orbitSpeed] != 0;
    return moves ? 0 : std::numeric_limits<double>::infinity();
}

bool SdfScenes::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

Message SdfScenes::whyDisabled(const ParameterValues& values) const
{
    if (shown(values).contents.moves) return {};
    return message("Nothing in this scene moves with time; choose another scene.");
}

std::vector<StudyView> SdfScenes::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    still.set(table_.orbitSpeed, 0.0);
    ParameterValues around = still;
    around.set(table_.orbit, values[table_.orbit] + 0.6);
    render::Camera aside = bestView(values);
    aside.eye += glm::dvec3(0.5, 0.2, 0.1);
    return {{"best view", bestView(values), 0, still},
            {"from the side", aside, 0, still},
            {"from another side", bestView(values), 0, around}};
}

DynamicParameters SdfScenes::dynamicParameters(const ParameterValues& values, render::AssetStore& assets) const
{
    const std::string path = filePath(table_.rows()[table_.scene.row], values[table_.scene]);
    const std::string text = values[table_.document];
    const ParameterInfo& row = table_.rows()[text.empty() ? table_.scene.row : table_.document.row];
    if (path.empty() && text.empty())
        return {{std::shared_ptr<const Parameters>(), &table_},
                whyNotFirst_.empty() ? Message() : unreadableFile(row, title(), whyNotFirst_)};
    const auto reading = readDocument(path.empty() ? first_->path : std::filesystem::path(path), text, assets);
    if (reading->table) return {reading->table, {}};
    return {nullptr, unreadableFile(row, title(), reading->why)};
}

std::vector<std::string> SdfScenes::furtherFiles(const ParameterValues& values) const
{
    const auto& table = static_cast<const Table&>(values.table());
    return table.shown ? filesBeside(*table.shown) : std::vector<std::string>();
}

std::shared_ptr<const PreparedPart> SdfScenes::prepare(const PrepareContext& context) const
{
    if (!context.seen) return nullptr;
    const ShownScene& scene = shown(context.values);
    auto part = std::make_shared<PreparedScene>();
    part->numbers = numbersAt(context.values, context.time);
    part->words = scene.program->words(part->numbers);
    const bool runs = context.values[table_.animate] && scene.contents.moves;
    const SceneRest rest = !context.idle ? SceneRest::nothing : runs ? SceneRest::steady : SceneRest::all;
    part->asked = sceneEvaluator(scene, part->words, context.values[table_.evaluation], rest, context.assets);
    if (context.values[table_.split])
        part->askedRight =
            sceneEvaluator(scene, part->words, context.values[table_.rightEvaluation], rest, context.assets);
    const Record& environment = scene.scene->environment;
    if (environment.files.empty()) return part;
    const std::string path = (scene.path.parent_path() / environment.files.front()).string();
    const auto read = context.assets.get<render::Texture>(
        "sdf_scenes.environment", path,
        [&scene](const std::string&) {
            auto picture = readEnvironment(scene);
            const std::uint64_t bytes = heldBytes(*picture);
            return render::AssetStore::Made<render::Texture>{std::move(picture), bytes};
        },
        scene.pictures);
    part->environment = read.value;
    part->filesId = read.id;
    if (read.value && environment.files.size() == 1) part->note = stretchedSky(*read.value, path);
    if (!read.failure.empty())
        part->unreadable.push_back({"sdf_scenes/environment",
                                    unreadableFile(table_.rows()[table_.scene.row], title(), read.failure),
                                    message("What surrounds the scene is black until it can be read.")});
    return part;
}

void SdfScenes::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const ParameterValues& values = context.values;
    const auto* prepared = static_cast<const PreparedScene*>(context.prepared);
    if (!prepared) {
        plan.skip("sdf_scenes/scene", "it was not prepared");
        return;
    }
    if (!prepared->note.empty()) plan.warn("sdf_scenes/environment", prepared->note);
    Portal portal = portalAt(values, context.time, prepared->numbers);
    if (values[table_.split]) {
        portal.divider = dividerAt(values[table_.divider]);
        portal.side = 1;
        planPart("sdf_scenes/right", rightHalf(table_, values), portal, context, plan);
        portal.side = -1;
    } else {
        plan.skip("sdf_scenes/right", "the picture is not divided");
    }
    planPart("sdf_scenes/scene", values, portal, context, plan);
    for (const Finding& shape : shown(values).scene->leftOut)
        plan.warn("sdf_scenes/shapes", shape.text().english() + " This shape is left out.");
    const std::size_t lights = shown(values).scene->lights.size();
    if (lights > SCENE_MOST_LIGHTS)
        plan.warn("sdf_scenes/lights", "The scene has " + std::to_string(lights) + " lights; the first " +
                                           std::to_string(SCENE_MOST_LIGHTS) + " shine.");
}

void SdfScenes::planPart(const std::string& name, const ParameterValues& values, const Portal& portal,
                         const PlanContext& context, render::FramePlan& plan) const
{
    const std::optional<glm::ivec2> columns = portalColumns(portal, context.worldFromExhibit, plan.view);
    if (columns && columns->x >= columns->y) {
        plan.skip(name, "its half is out of view");
        return;
    }
    const ShownScene& scene = shown(values);
    const auto& prepared = static_cast<const PreparedScene&>(*context.prepared);
    const SceneEvaluator& asked = portal.side > 0 ? prepared.askedRight : prepared.asked;
    const std::string steps = portal.side > 0 ? name + '/' : "sdf_scenes/";
    // Shaders see only the parameters that all scenes have, so that all scenes share one uniform block.
    std::vector<std::string> notes;
    const ParameterValues common = underTable(values, {std::shared_ptr<const Parameters>(), &table_}, notes);
    render::Pass pass = portalPass(name, "in view", common, "sdf_scenes/scene.frag", portal, context);
    pass.columns = columns;
    pass.shader.sources = asked.sources;
    pass.buffers = asked.buffers;
    pass.shader.programFamily = pass.name;
    const bool reference = prepared.numbers[scene.scene->look.numbers] > 0.5;
    ScenePass{table_, values, scene, reference, steps, pass, plan}.all();

    if (!asked.why.empty()) plan.skip(steps + "cells", asked.why);
    if (!asked.folded) plan.skip(steps + "folding", asked.whyNotFolded);
    SceneStage stage = sceneStage(scene, prepared.words, prepared.numbers);
    if (asked.near) {
        setBox(stage, asked.near->box);
        stage.loops = stepsOfList;
    }
    stage.bounces = std::min(stage.bounces, values[table_.bounces]);
    stage.exposure *= static_cast<float>(values[table_.brightness]);
    if (prepared.environment) {
        pass.shader.defines.emplace_back("PANORAMA");
        pass.inputs.push_back({UNIT_EXHIBIT_A, prepared.environment});
    }
    render::Bytes block;
    if (asked.numbersInBlock) block = sceneBlock(prepared.words);
    const render::Bytes around = render::std140Bytes(stage);
    block.insert(block.end(), around.begin(), around.end());
    pass.blocks[BLOCK_EXHIBIT] = std::move(block);
    if (asked.folded) {
        auto specialized = std::make_shared<render::ShaderKey>(pass.shader);
        specialized->sources = asked.folded;
        specialized->about = "with its constant numbers compiled in";
        pass.shader.specialized = std::move(specialized);
    }
    plan.add(std::move(pass));
}

std::vector<DraggedLine> SdfScenes::draggedLines(const ExhibitState& state, const glm::dvec3&) const
{
    if (!state.values[table_.split]) return {};
    const Portal portal;
    const double x = dividerAt(state.values[table_.divider]);
    return {{table_.divider.row, {x, -portal.halfSize.y, -portal.behind}, {x, portal.halfSize.y, -portal.behind}}};
}

double SdfScenes::valueUnder(const ExhibitState&, std::size_t, const render::Ray& ray) const
{
    const Portal portal;
    const double x = ray.at((-portal.behind - ray.origin.z) / std::min(ray.direction.z, -1e-4)).x;
    return std::clamp(0.5 + 0.5 * x / portal.halfSize.x, 0.0, 1.0);
}

namespace {

const NodeKind& kindNamed(const std::string& word)
{
    const NodeKind* kind = findKind(word);
    if (!kind) throw Failure(ErrorKind::check, "There is no kind of node \"" + word + "\".");
    return *kind;
}

EditedScene edit(const SceneEdit& scene, const TreeEdit& wanted)
{
    using enum TreeEdit::What;
    switch (wanted.what) {
    case add: return scene.added(wanted.node, wanted.before, kindNamed(wanted.word));
    case duplicate: return scene.duplicated(wanted.node);
    case remove: return scene.removed(wanted.node);
    case wrap: return scene.wrapped(wanted.node, kindNamed(wanted.word));
    case unwrap: return scene.unwrapped(wanted.node);
    case move: return scene.moved(wanted.node, wanted.parent, wanted.before);
    case rename: return scene.renamed(wanted.node, wanted.word);
    case hide: return scene.hidden(wanted.node, true);
    case show: return scene.hidden(wanted.node, false);
    case solo: return scene.solo(wanted.node);
    case showAll: return scene.allShown();
    case kind: return scene.ofKind(wanted.node, kindNamed(wanted.word));
    }
    throw Failure(ErrorKind::check, "This cannot be done.");
}

/// A ray of the exhibit's own space beyond the opening, in meters of the scene.
struct SceneRay {
    glm::dvec3 origin, direction;  ///< Unit length.
    double start = 0;
    bool throughOpening = false;
};

SceneRay sceneRay(const Portal& portal, const render::Ray& ray)
{
    const glm::dvec3 direction(portal.workFromExhibit * glm::dvec4(ray.direction, 0));
    SceneRay through{glm::dvec3(portal.workFromExhibit * glm::dvec4(ray.origin, 1)), glm::normalize(direction)};
    const double t = (-portal.behind - ray.origin.z) / ray.direction.z;
    const glm::dvec3 at = ray.at(t);
    through.throughOpening =
        ray.direction.z < 0 && t >= 0 && std::abs(at.x) <= portal.halfSize.x && std::abs(at.y) <= portal.halfSize.y;
    through.start = t * glm::length(direction);
    return through;
}

bool hasFiniteSize(const render::Box& box)
{
    const glm::dvec3 size = box.high - box.low;
    return std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
}

}  // namespace

Tree SdfScenes::tree(const ParameterValues& values) const
{
    return treeOf(*shown(values).scene);
}

std::optional<TreeParameters> SdfScenes::parametersOf(const ParameterValues& values, std::string_view node) const
{
    const ShownScene& scene = shown(values);
    const std::vector<double> numbers = numbersAt(values, 0);
    std::optional<TreeParameters> rows = nodeParameters(*scene.scene, numbers, node);
    const std::uint32_t at = nodeAt(*scene.scene, node);
    if (!rows || at == noIndex) return rows;
    const std::string without = placeInScene(scene, numbers, at).without;
    if (!without.empty()) rows->note += (rows->note.empty() ? "" : " ") + without;
    return rows;
}

ParameterValues SdfScenes::withText(const ParameterValues& values, std::string text, render::AssetStore& assets) const
{
    if (text.size() > presetLimits.stringBytes)
        throw Failure(ErrorKind::check, "A scene of more than 1 MB is not edited here; change its file.");
    ParameterValues next = values;
    next.set(table_.document, text);
    const DynamicParameters called = dynamicParameters(next, assets);
    if (!called.table) throw Failure(ErrorKind::check, called.why);
    std::vector<std::string> notes;
    return underTable(next, called.table, notes);
}

EditedTree SdfScenes::edited(const ParameterValues& values, const TreeEdit& wanted, render::AssetStore& assets) const
{
    EditedScene made = edit(SceneEdit(documentText(values)), wanted);
    return {withText(values, std::move(made.text), assets), made.path};
}

ParameterValues SdfScenes::withParameter(const ParameterValues& values, std::string_view node, std::size_t row,
                                         const Value& value, render::AssetStore& assets) const
{
    return withText(values, textWithParameter(*shown(values).scene, node, row, value), assets);
}

ParameterValues SdfScenes::withPlace(const ParameterValues& values, std::string_view node, const TreePlace& from,
                                     const TreePlace& to, render::AssetStore& assets) const
{
    return withText(values, textWithPlace(*shown(values).scene, node, from, to), assets);
}

std::string SdfScenes::pick(const ExhibitState& state, const render::Ray& ray) const
{
    const ShownScene& scene = shown(state.values);
    const SceneRay through = sceneRay(portalAt(state.values, state.time), ray);
    if (!through.throughOpening) return {};
    const SceneField field(scene.program, scene.program->words(numbersAt(state.values, state.time)));
    const double t = marched(field, through.origin, through.direction, through.start, 1e5);
    if (!std::isfinite(t)) return {};
    const std::uint32_t node = field.sample(through.origin + t * through.direction).node;
    return node == noIndex ? std::string() : pathOf(*scene.scene, node);
}

std::optional<TreePlace> SdfScenes::placeOf(const ExhibitState& state, std::string_view node) const
{
    const Scene& scene = *shown(state.values).scene;
    const std::uint32_t at = nodeAt(scene, node);
    if (at == noIndex) return std::nullopt;
    TreePlace place = placeInScene(shown(state.values), numbersAt(state.values, state.time), at);
    place.exhibitFromParent =
        glm::affineInverse(portalAt(state.values, state.time).workFromExhibit) * place.exhibitFromParent;
    return place;
}

std::shared_ptr<const TreeShape> SdfScenes::shapeOf(const ExhibitState& state, std::string_view node) const
{
    const Scene& scene = *shown(state.values).scene;
    if (nodeAt(scene, node) == noIndex) return nullptr;
    const auto program = std::make_shared<const SceneProgram>(onlyNode(scene, node));
    const auto field = std::make_shared<const SceneField>(program, program->words(numbersAt(state.values, state.time)));
    const Portal portal = portalAt(state.values, state.time);
    const render::Box box = field->box();
    auto shape = std::make_shared<TreeShape>();
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    shape->box = {glm::dvec3(-everywhere), glm::dvec3(everywhere)};
    if (hasFiniteSize(box) && !box.empty()) shape->box = box.transformed(glm::affineInverse(portal.workFromExhibit));
    shape->isHit = [field, portal, box](const render::Ray& ray) {
        const SceneRay through = sceneRay(portal, ray);
        if (!through.throughOpening || field->program().nodes().empty()) return false;
        const render::RayInterval inside = render::insideBox({through.origin, through.direction}, box);
        const double start = std::max(through.start, inside.enter - 1e-6);
        return std::isfinite(
            marched(*field, through.origin, through.direction, start, std::min(inside.exit + 1e-6, 1e5)));
    };
    return shape;
}

DocumentPlace SdfScenes::document(const ParameterValues& values) const
{
    const std::string& named = values[table_.scene];
    const std::string path = filePath(table_.rows()[table_.scene.row], named);
    return {table_.scene.row, table_.document.row, path.empty() ? first_->path.string() : path,
            !path.empty() && path == named, "vitrine-scene.json"};
}

std::string SdfScenes::documentText(const ParameterValues& values) const
{
    return shown(values).scene->files.front().text->text();
}

bool SdfScenes::isDocument(const std::string& text) const
{
    return isSceneText(text);
}

}  // namespace vitrine::scenes
