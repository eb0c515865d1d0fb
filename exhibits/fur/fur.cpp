#include "exhibits/fur/fur.h"

#include "exhibits/framework/derive.h"
#include "exhibits/fur/coat.h"
#include "exhibits/fur/coat_mesh.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using render::Attachment;
using render::Load;
using render::Pass;

constexpr const char* foundImage = "fur.found";
constexpr const char* tintedImage = "fur.tinted";
constexpr const char* names[furBodyCount] = {"ball", "roll", "ring"};

}  // namespace

struct Fur::Wardrobe {
    std::shared_ptr<const render::Mesh> skins[furBodyCount] = {ballSkin(ballRadius, 8), rollSkin(rollRadius, rollHalfLength, 26), ringSkin(ringRadius, ringTube, 40)};
    std::shared_ptr<const render::Mesh> fins[furBodyCount];
};

Fur::Fur() : wardrobe_(std::make_unique<Wardrobe>()) {}

Fur::~Fur() = default;

render::Box Fur::bounds(const ParameterValues&) const
{
    return {{-pitRadius, 0, -pitRadius}, {pitRadius, 1.5, pitRadius}};
}

render::Camera Fur::bestView(const ParameterValues&) const
{
    return {{-0.35, 1.55, 2.75}, {0.05, 0.32, 0.1}, 0.66};
}

double Fur::nextChange(const ParameterValues& values, double) const
{
    return values[table_.wind] > 0 && values[table_.gustiness] > 0 ? 0 : std::numeric_limits<double>::infinity();
}

namespace {

FurStates restStates(const FurTable& table, const ParameterValues& values)
{
    FurStates states;
    const glm::dvec3 places[furBodyCount] = {{-0.62, 0, -0.30}, {0.60, 0, -0.38}, {0.22, 0, 0.66}};
    const double yaw[furBodyCount] = {0, -0.5, 0.2};
    for (int i = 0; i < furBodyCount; ++i) {
        FurState& state = states[static_cast<std::size_t>(i)];
        state.position = places[i] + glm::dvec3(0, colliderRadius(table, values, i, 1), 0);
        state.turn = glm::angleAxis(yaw[i], glm::dvec3(0, 1, 0));
        state.pull = {0, -0.25, 0};
        if (values[table.byHand]) {
            state.pull = {values[table.handX], values[table.handY], values[table.handZ]};
            state.lag = glm::angleAxis(values[table.handTurn], glm::dvec3(0, 0, 1));
        }
    }
    return states;
}

}  // namespace

void Fur::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const ParameterValues& values = context.values;
    const Coats coats{table_, values, restStates(table_, values), context.worldFromExhibit, context.time, plan.seed};
    const bool mirrored = glm::determinant(glm::dmat3(context.worldFromExhibit)) < 0;

    FurBodies bodies;
    for (int i = 0; i < furBodyCount; ++i) bodies.body[i] = coats.body(i);
    bodies.worldFromPit = glm::mat4(context.worldFromExhibit);
    bodies.pitFromWorld = glm::mat4(glm::inverse(context.worldFromExhibit));
    bodies.pit = {static_cast<float>(pitRadius), static_cast<float>(pitRim), context.alone ? 1.0F : 0.0F, 0};

    std::vector<std::string> defines;
    if (values[table_.clump] > 0 || values[table_.curl] > 0) defines.emplace_back("CLUMPS");
    if (values[table_.curl] > 0) defines.emplace_back("CURLS");
    const auto coatPass = [&](std::string name, std::string reason) {
        Pass pass;
        pass.name = std::move(name);
        pass.reason = std::move(reason);
        pass.shader = {"fur/coat.vert", "fur/coat.frag", "", defines, derive::uniformBlock(table_)};
        pass.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
        pass.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::back};
        return pass;
    };
    const auto shells = [&](int i, const render::View& view, bool shadow) {
        FurBody body = bodies.body[i];
        const render::Box box = coats.bounds(i, wardrobe_->skins[i]->bounds);
        if (shadow) {
            body.shells.x = std::min(body.shells.x, 8.0F);
            body.shells.y = std::min(body.shells.y, 3.0F);
        } else if (values[table_.levelOfDetail]) {
            const double distance = glm::length(view.eye - box.center());
            const double angle = 2 * view.tanHalfFov.y / view.raster.size.y;
            body.shells.x = static_cast<float>(shellsAtDistance(static_cast<int>(body.shells.x), body.coat.x, distance, angle));
        }
        render::Draw draw;
        draw.mesh = wardrobe_->skins[i];
        draw.instances = std::max(static_cast<int>(std::ceil(body.shells.x)), 1);
        draw.mirrored = mirrored;
        draw.object = render::bytesOf(body);
        return draw;
    };

    if (context.noShadowBecause.empty()) {
        Pass pass = coatPass("fur/shadow", "the sun reaches it and its shadow may be seen");
        pass.stage = render::Stage::shadow;
        pass.view = context.surroundings.exhibitShadowView;
        pass.key = context.surroundings.exhibitShadowKey;
        pass.shader.defines.emplace_back("SHADOW");
        pass.depth = Attachment{exhibitShadowImage, Load::keep, {}, -1, 0};
        pass.state.depthClamp = true;
        for (int i = 0; i < furBodyCount; ++i) pass.draws.push_back(shells(i, context.surroundings.exhibitShadowView, true));
        plan.add(std::move(pass));
    } else {
        plan.skip("fur/shadow", context.noShadowBecause);
    }

    if (!context.hiddenBecause.empty()) {
        for (const char* pass : {"fur/coat", "fur/shade", "fur/floor"}) plan.skip(pass, context.hiddenBecause);
        return;
    }
    Pass coat = coatPass("fur/coat", "");
    std::string seen;
    for (int i = 0; i < furBodyCount; ++i) {
        if (!plan.runEverything && !plan.view.mayContain(coats.bounds(i, wardrobe_->skins[i]->bounds))) continue;
        coat.draws.push_back(shells(i, plan.view, false));
        seen += (seen.empty() ? "" : ", ") + std::string(names[i]);
    }
    if (coat.draws.empty()) {
        for (const char* pass : {"fur/coat", "fur/shade"}) plan.skip(pass, "out of view");
    } else {
        plan.image({.name = foundImage, .format = render::Format::rgba16f, .nearest = true});
        plan.image({.name = tintedImage, .format = render::Format::rgba8, .nearest = true});
        coat.reason = "in view: " + seen;
        coat.countSamples = true;
        for (const render::Draw& draw : coat.draws) coat.counts["shells"] += draw.instances;
        coat.colors = {{foundImage, Load::clear, {}, -1, 0}, {tintedImage, Load::clear, {}, -1, 0}};
        coat.depth = Attachment{depthImage, Load::keep, {}, -1, 0};
        if (context.channels.normal) {
            coat.shader.defines.emplace_back("WRITE_NORMAL");
            coat.colors.push_back({normalImage, Load::keep, {}, -1, 0});
        }
        plan.add(std::move(coat));

        Pass shade;
        shade.name = "fur/shade";
        shade.reason = "light on the strands that were found";
        shade.shader = {"fur/shade.vert", "fur/shade.frag", "", {}, derive::uniformBlock(table_)};
        shade.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
        shade.colors = {{radianceImage, Load::keep, {}, -1, 0}};
        context.surroundings.illuminate(shade);
        shade.inputs.push_back({UNIT_EXHIBIT_A, std::string(foundImage)});
        shade.inputs.push_back({UNIT_EXHIBIT_B, std::string(tintedImage)});
        shade.inputs.push_back({UNIT_EXHIBIT_C, std::string(depthImage)});
        shade.draws = {render::Draw{}};
        shade.draws[0].object = render::bytesOf(bodies);
        plan.add(std::move(shade));
    }

    Pass floor;
    floor.name = "fur/floor";
    floor.reason = context.alone ? "they stand on something" : "the bodies keep light off the floor";
    floor.stage = render::Stage::transparent;
    floor.shader = {"fur/floor.vert", "fur/floor.frag", "", {}, derive::uniformBlock(table_)};
    floor.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
    floor.colors = {{radianceImage, Load::keep, {}, -1, 0}};
    floor.depth = Attachment{depthImage, Load::keep, {}, -1, 0};
    floor.state = {.depthTest = render::DepthTest::nearer, .blend = render::Blend::premultiplied};
    context.surroundings.illuminate(floor);
    floor.draws = {render::Draw{}};
    floor.draws[0].mesh = diskMesh();
    floor.draws[0].object = render::bytesOf(bodies);
    plan.add(std::move(floor));
}

}  // namespace vitrine
