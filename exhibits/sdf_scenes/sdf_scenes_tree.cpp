// What a visitor does with the scene's tree.

#include "exhibits/framework/file_path.h"
#include "exhibits/framework/preset.h"
#include "exhibits/sdf_scenes/scene_document.h"
#include "exhibits/sdf_scenes/scene_edit.h"
#include "exhibits/sdf_scenes/scene_tree.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "render/failure.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using scenes::EditedScene;
using scenes::SceneEdit;
using scenes::SceneField;

const scenes::NodeKind& kindNamed(const std::string& word)
{
    const scenes::NodeKind* kind = scenes::findKind(word);
    if (!kind) throw Failure(Blame::check, "There is no kind of node \"" + word + "\".");
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
    throw Failure(Blame::check, "This cannot be done.");
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

bool isFinite(const render::Box& box)
{
    const glm::dvec3 size = box.high - box.low;
    return std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
}

}  // namespace

Tree SdfScenes::tree(const ParameterValues& values) const
{
    return scenes::treeOf(*shown(values).scene);
}

std::optional<TreeRows> SdfScenes::rowsOf(const ParameterValues& values, std::string_view node) const
{
    const scenes::ShownScene& scene = shown(values);
    const std::vector<double> numbers = numbersAt(values, 0);
    std::optional<TreeRows> rows = scenes::nodeRows(*scene.scene, numbers, node);
    const std::uint32_t at = scenes::nodeAt(*scene.scene, node);
    if (!rows || at == scenes::none) return rows;
    const std::string without = scenes::placeInScene(scene, numbers, at).without;
    if (!without.empty()) rows->note += (rows->note.empty() ? "" : " ") + without;
    return rows;
}

ParameterValues SdfScenes::withText(const ParameterValues& values, std::string text, render::AssetStore& assets) const
{
    if (text.size() > presetLimits.stringBytes)
        throw Failure(Blame::check, "A scene of more than 1 MB is not edited here; change its file.");
    ParameterValues next = values;
    next.set(table_.document, text);
    const CalledTable called = tableFor(next, assets);
    if (!called.table) throw Failure(Blame::check, called.why);
    std::vector<std::string> notes;
    return next.under(called.table, notes);
}

EditedTree SdfScenes::edited(const ParameterValues& values, const TreeEdit& wanted, render::AssetStore& assets) const
{
    EditedScene made = edit(SceneEdit(documentText(values)), wanted);
    return {withText(values, std::move(made.text), assets), made.path};
}

ParameterValues SdfScenes::withRow(const ParameterValues& values, std::string_view node, std::size_t row,
                                   const Value& value, render::AssetStore& assets) const
{
    return withText(values, scenes::textWithRow(*shown(values).scene, node, row, value), assets);
}

ParameterValues SdfScenes::withPlace(const ParameterValues& values, std::string_view node, const TreePlace& from,
                                     const TreePlace& to, render::AssetStore& assets) const
{
    return withText(values, scenes::textWithPlace(*shown(values).scene, node, from, to), assets);
}

std::string SdfScenes::pick(const ExhibitState& state, const render::Ray& ray) const
{
    const scenes::ShownScene& scene = shown(state.values);
    const SceneRay through = sceneRay(portalAt(state.values, state.time), ray);
    if (!through.throughOpening) return {};
    const SceneField field(scene.program, scene.program->words(numbersAt(state.values, state.time)));
    const double t = scenes::marched(field, through.origin, through.direction, through.start, 1e5);
    if (!std::isfinite(t)) return {};
    const std::uint32_t node = field.sample(through.origin + t * through.direction).node;
    return node == scenes::none ? std::string() : scenes::pathOf(*scene.scene, node);
}

std::optional<TreePlace> SdfScenes::placeOf(const ExhibitState& state, std::string_view node) const
{
    const scenes::Scene& scene = *shown(state.values).scene;
    const std::uint32_t at = scenes::nodeAt(scene, node);
    if (at == scenes::none) return std::nullopt;
    TreePlace place = scenes::placeInScene(shown(state.values), numbersAt(state.values, state.time), at);
    place.exhibitFromParent =
        glm::affineInverse(portalAt(state.values, state.time).workFromExhibit) * place.exhibitFromParent;
    return place;
}

std::shared_ptr<const TreeShape> SdfScenes::shapeOf(const ExhibitState& state, std::string_view node) const
{
    const scenes::Scene& scene = *shown(state.values).scene;
    if (scenes::nodeAt(scene, node) == scenes::none) return nullptr;
    const auto program = std::make_shared<const scenes::SceneProgram>(scenes::onlyNode(scene, node));
    const auto field = std::make_shared<const SceneField>(program, program->words(numbersAt(state.values, state.time)));
    const Portal portal = portalAt(state.values, state.time);
    const render::Box box = field->box();
    auto shape = std::make_shared<TreeShape>();
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    shape->box = {glm::dvec3(-everywhere), glm::dvec3(everywhere)};
    if (isFinite(box) && !box.empty()) shape->box = box.transformed(glm::affineInverse(portal.workFromExhibit));
    shape->isHit = [field, portal, box](const render::Ray& ray) {
        const SceneRay through = sceneRay(portal, ray);
        if (!through.throughOpening || field->program().nodes().empty()) return false;
        const render::Stretch inside = render::insideBox({through.origin, through.direction}, box);
        const double start = std::max(through.start, inside.enter - 1e-6);
        return std::isfinite(
            scenes::marched(*field, through.origin, through.direction, start, std::min(inside.exit + 1e-6, 1e5)));
    };
    return shape;
}

TreeDocument SdfScenes::document(const ParameterValues& values) const
{
    const std::string& named = values[table_.scene];
    const std::string path = filePath(table_.rows()[table_.scene.row], named);
    return {table_.scene.row, table_.document.row, path.empty() ? first_->path.string() : path,
            !path.empty() && path == named};
}

std::string SdfScenes::documentText(const ParameterValues& values) const
{
    return shown(values).scene->files.front().text->text();
}

bool SdfScenes::isDocument(const std::string& text) const
{
    return scenes::isSceneText(text);
}

}  // namespace vitrine
