#include "exhibits/ice_cream/ice_cream.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/ice_cream/backdrop_sheet.h"
#include "exhibits/ice_cream/ice_cream_cpu.h"
#include "exhibits/ice_cream/ice_cream_shape.h"
#include "exhibits/ice_cream/sprinkles.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/sdf_passes.h"
#include "render/glsl/std140.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numbers>

namespace vitrine::ice_cream {
namespace {

constexpr double plinthTop = -0.62;  ///< Meters above the center of the niche.
constexpr const char* notBuiltUp = "the build-up has not come so far";
constexpr double behindTheWall = -0.2;  ///< Position in meters of the axis in the niche along z.

/// Returns the transform to exhibit space from the reference's space: turned, scaled, and on its plinth in the niche.
glm::dmat4 standing(const IceCreamTable& t, const ParameterValues& values, double time)
{
    const double turns = values[t.animate] && std::isfinite(time) ? std::fmod(values[t.orbitSpeed] * time, 1.0) : 0;
    const double angle = -values[t.orbitAngle] - turns * 2 * std::numbers::pi;
    const glm::dmat4 placed = glm::translate(glm::dmat4(1), glm::dvec3(0, plinthTop, behindTheWall));
    return glm::scale(glm::rotate(placed, angle, glm::dvec3(0, 1, 0)), glm::dvec3(values[t.size]));
}

/// Returns the values with effects of later stages switched off, as far as parameters of SdfParameters do it.
ParameterValues builtUp(const IceCreamTable& t, const ParameterValues& values, IceCreamStage stage)
{
    ParameterValues now = values;
    // Shadows without a soft edge are unchanged, since parameters of that edge do not act then.
    const bool soft = values[t.shadowMethod] != SdfShadow::none && values[t.shadowMethod] != SdfShadow::hard;
    if (stage < IceCreamStage::classic)
        now.set(t.shadowMethod, SdfShadow::none);
    else if (stage == IceCreamStage::classic && soft)
        now.set(t.shadowMethod, SdfShadow::classic);
    else if (stage == IceCreamStage::improved && soft)
        now.set(t.shadowMethod, SdfShadow::improved);
    if (stage < IceCreamStage::occlusion) now.set(t.ambientOcclusion, false);
    if (stage < IceCreamStage::fog) now.set(t.referenceFog, 0.0);
    return now;
}

struct PreparedSprinkles final : PreparedPart {
    std::shared_ptr<const Sprinkles> sprinkles;
};

/// Writes a number into a block that is already packed into bytes.
template <typename T> void patch(render::Bytes& block, std::string_view field, const T& value)
{
    std::memcpy(block.data() + render::std140Offset<IceCreamShape>(field), &value, sizeof value);
}

}  // namespace

SdfBody IceCream::body(const ParameterValues& values, double time) const
{
    const IceCreamShape shape = iceCreamShape(table_, values, time);
    const auto solids = std::make_shared<glsl::IceCream>();
    copyShape(solids->shape, shape);
    SdfBody body{.values = builtUp(table_, values, static_cast<IceCreamStage>(shape.stage)),
                 .box = boxOf(shape),
                 .distance = [solids](const glm::dvec3& p) { return glsl::IceCream(*solids).iceCreamDistance(p); },
                 .shape = {},
                 .block = render::std140Bytes(shape),
                 .exhibitFromBody = standing(table_, values, time)};
    body.shape.assign(reinterpret_cast<const char*>(body.block.data()), body.block.size());
    // The shape's key does not contain this direction, which changes while the ice cream turns.
    patch(body.block, "towardsHall",
          glm::vec3(glm::normalize(glm::transpose(glm::dmat3(body.exhibitFromBody)) * glm::dvec3(0, 0, 1))));
    body.switchedOff = notBuiltUp;
    body.ownLight = values[table_.lamp];
    if (values[table_.lighting] == IceCreamLighting::reference) {
        // The reference's light is in display values. Divided by any exposure, it has no bound.
        body.ownLight = std::numeric_limits<double>::infinity();
        const glm::dvec3 ambient = values[table_.referenceAmbient].value;
        body.occluded = {std::max({ambient.x, ambient.y, ambient.z}), "the ambient light is black"};
    }
    body.variant =
        "built up to: " + std::string(values.rows()[table_.stage.row].choices[static_cast<std::size_t>(shape.stage)]);
    if (shape.stage < STAGE_FINISHED) body.defines.emplace_back("PIXEL_CENTERS");
    if (values[table_.lighting] == IceCreamLighting::reference) body.defines.emplace_back("REFERENCE_LIGHT");
    return body;
}

std::shared_ptr<const PreparedPart> IceCream::prepareBody(const PrepareContext& context) const
{
    const ParameterValues& values = context.values;
    IceCreamShape shape = iceCreamShape(table_, values, context.time);
    if ((shape.parts >> PART_SPRINKLES & 1) == 0) return nullptr;
    // Sprinkles lie on finished cream, independent of the candies and of what else is shown.
    ParameterValues whole = values;
    whole.set(table_.show, IceCreamParts::all);
    whole.set(table_.buildUp, false);
    whole.set(table_.stage, IceCreamStage::finished);
    shape = iceCreamShape(table_, whole, 0);
    shape.candies = {};
    const SprinkleSettings settings{values[table_.sprinkles], values[table_.sprinkleSeed],
                                    values[table_.sprinkleLength]};
    const render::Bytes bytes = render::std140Bytes(shape);
    std::string key(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    key += derive::keyOf(values, {table_.sprinkles.row, table_.sprinkleSeed.row, table_.sprinkleLength.row});
    auto made = std::make_shared<PreparedSprinkles>();
    made->sprinkles = context.assets
                          .made<Sprinkles>("ice_cream.sprinkles", key,
                                           [&] {
                                               auto all = std::make_shared<Sprinkles>(strewn(shape, settings));
                                               const std::uint64_t held =
                                                   2 * (all->cellBytes->size() + all->endBytes->size());
                                               return render::AssetStore::Made<Sprinkles>{std::move(all), held};
                                           })
                          .value;
    return made;
}

void IceCream::complete(SdfBody& body, const PreparedPart* prepared) const
{
    const auto* part = static_cast<const PreparedSprinkles*>(prepared);
    if (!part || !part->sprinkles || part->sprinkles->all.empty()) return;
    const Sprinkles& s = *part->sprinkles;
    patch(body.block, "gridLow", s.low);
    patch(body.block, "gridCell", s.cell);
    patch(body.block, "gridCells", s.cells);
    body.defines.emplace_back("SPRINKLES");
    body.buffers = {{.binding = UNIT_BUFFER_A, .source = s.cellBytes, .texels = render::Texels::uvec4},
                    {.binding = UNIT_BUFFER_B, .source = s.endBytes, .texels = render::Texels::vec4}};
}

render::Box IceCream::boxOverTime(const ParameterValues& values) const
{
    render::Box box = ice_cream::boxOverTime(table_, values);
    if (values[table_.animate] && values[table_.orbitSpeed] != 0) {
        const double reach = glm::length(
            glm::max(glm::abs(glm::dvec2(box.low.x, box.low.z)), glm::abs(glm::dvec2(box.high.x, box.high.z))));
        box.include({-reach, box.low.y, -reach});
        box.include({reach, box.high.y, reach});
    }
    return box.transformed(standing(table_, values, 0));
}

render::Box IceCream::boundsOf(const ExhibitState& state) const
{
    render::Box box = bounds(state.values);
    if (const render::Box sheet = backdropBox(table_, state.values); sheet.low.x <= sheet.high.x) {
        box.include(sheet.low);
        box.include(sheet.high);
    }
    return box;
}

bool IceCream::isGlass(const ParameterValues& values) const
{
    return values[table_.material] == SdfMaterial::glass && values[table_.lighting] == IceCreamLighting::hall;
}

render::Camera IceCream::bestView(const ParameterValues& values) const
{
    const glm::dmat4 world = standing(table_, values, 0);
    // The reference's first view is closer, since there is a wall behind the eye.
    if (values[table_.lighting] == IceCreamLighting::reference) {
        const double size = values[table_.size];
        const glm::dvec3 foot(world[3]);
        return {foot + size * glm::dvec3(0, 1.5, 2), foot + size * glm::dvec3(0, 0.5, 0), 2 * std::atan(0.5)};
    }
    return {{-0.55, 0.06, 1.42}, {0.01, -0.2, -0.18}, 0.64};
}

double IceCream::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] || values[table_.buildUp] ? 0 : std::numeric_limits<double>::infinity();
}

bool IceCream::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

bool IceCream::surrounds(const ParameterValues& values) const
{
    return values[table_.lighting] == IceCreamLighting::reference && values[table_.ground];
}

std::vector<StudyView> IceCream::studyViews(const ParameterValues& values) const
{
    const render::Camera best = bestView(values);
    ParameterValues reference = values;
    reference.set(table_.lighting, IceCreamLighting::reference);
    reference.set(table_.material, SdfMaterial::opaque);
    // Positions are in the reference's space, whose axis and size are those of the exhibit at rest.
    const glm::dmat4 placed = standing(table_, values, 0);
    const auto from = [&](const glm::dvec3& eye, const glm::dvec3& target, double fovY) {
        return render::Camera{eye, target, fovY}.transformed(placed);
    };
    return {{"best view", best, 0, values},
            {"reference", bestView(reference), 0, reference},
            {"folds of the cream, from near", from({0.1, 1.25, 0.75}, {0, 1.0, 0}, 0.6), 0, values},
            {"the back, from above", from({-0.25, 1.6, -0.9}, {0, 1.0, -0.05}, 0.6), 7.3, values},
            {"the waffle, from below", from({0.25, 0.1, 0.8}, {0, 0.35, 0}, 0.7), 0, values}};
}

void IceCream::planBeside(const SdfScene& scene, render::FramePlan& plan) const
{
    constexpr const char* ground = "ice_cream/ground";
    const ParameterValues& values = scene.body.values;
    const double size = values[table_.size];
    planBackdrop(table_, scene.context, {0, plinthTop - size * iceCreamPlinthHeight, behindTheWall},
                 size * iceCreamPlinthRadius, plan);
    if (stageAt(table_, values, scene.context.time) < IceCreamStage::finished)
        plan.skip("ice_cream/antialiasing", notBuiltUp);
    if (values[table_.lighting] != IceCreamLighting::reference)
        plan.skip(ground, "it stands in the hall's light");
    else if (!values[table_.ground])
        plan.skip(ground, "the ground is switched off");
    else if (!scene.context.alone)
        plan.skip(ground, "it stands in the hall");
    else {
        render::Pass pass = sdfPass(scene, "ground", "it is shown alone in the light of the reference",
                                    "lib/fullscreen.vert", "ice_cream/ground.frag");
        drawSurface(pass, scene.context.channels.withoutCounts());
        scene.context.bindLighting(pass);
        pass.shader.defines.push_back(shadowDefine(scene));
        pass.state.cull = render::Cull::none;
        pass.draws = {sdfDraw(scene, nullptr)};
        if (scene.body.occluded.value <= 0 && !plan.runEverything) {
            ParameterValues needed = values;
            needed.set(table_.ambientOcclusion, false);
            pass.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(needed);
        }
        plan.add(std::move(pass));
    }
}

}  // namespace vitrine::ice_cream
