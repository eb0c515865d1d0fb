#include "exhibits/lenticular/lenticular.h"

#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "exhibits/lenticular/card_mesh.h"
#include "exhibits/lenticular/card_sheet.h"
#include "render/glsl/cpu.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine::lenticular {
namespace {

using render::Attachment;
using render::Pass;

constexpr double rollTime = 1.2;  ///< Seconds in which the button scrolls the other print in.

/// Prints in the card at one time.
struct CardPose {
    CardFace first = CardFace::front;  ///< Print that leaves, or rests.
    double roll = 0;                   ///< 0 at rest; increases to 1 while the other one enters.
};

CardFace otherFace(CardFace face)
{
    return face == CardFace::front ? CardFace::back : CardFace::front;
}

/// Returns the pose. `sincePressed` is in seconds since the button exchanged the prints, which scrolls the new one in.
CardPose poseAt(const LenticularTable& table, const ParameterValues& values, double time, double sincePressed)
{
    const CardFace start = values[table.face];
    double y = values[table.scroll] ? scrollAt(time, values[table.period], values[table.hold]) : 0;
    if (sincePressed >= 0 && sincePressed < rollTime) y += glsl::smoothStep(0.0, rollTime, sincePressed) - 1;
    const double whole = std::floor(y);
    return {std::fmod(whole, 2.0) == 0 ? start : otherFace(start), y - whole};
}

/// Prints in the card.
struct PreparedCard final : PreparedPart {
    struct Face {
        CardPicture picture;
        bool lying = false;  ///< Whether its lenses are horizontal.
    };
    std::array<Face, 2> faces{};  ///< Indexed by CardFace; no texture: it is not in the card, or cannot be shown.
    std::vector<std::pair<std::string, std::string>> doubts;  ///< Steps, and why their descriptions are not used.
    std::string sheetNote;  ///< How the sheet differs from the parameters, if they are impossible.

    [[nodiscard]] const Face& face(CardFace f) const { return faces[static_cast<std::size_t>(f)]; }
};

/// State that the passes of one frame share.
struct Scene {
    const LenticularTable& table;
    const PlanContext& context;
    glm::dmat4 worldFromCard;
    std::string reason;

    [[nodiscard]] render::Draw draw() const
    {
        render::Draw draw;
        draw.mesh = cardMesh();
        draw.mirrored = isMirrored(worldFromCard);
        return draw;
    }
};

Scene sceneOf(const LenticularTable& table, const PlanContext& context)
{
    return {table, context, context.worldFromExhibit * exhibitFromCard(), "in view"};
}

CardObject cardObject(const Scene& s, const render::View& view, double roll)
{
    const ParameterValues& values = s.context.values;
    CardObject object;
    object.worldFromCard = glm::mat4(s.worldFromCard);
    const glm::dmat4 cardFromWorld = glm::affineInverse(s.worldFromCard);
    object.cardFromWorld = glm::mat4(cardFromWorld);
    const glm::dvec3 right = glm::dvec3(glm::transpose(glm::dmat3(view.viewFromWorld))[0]);
    const CardEyes eyes = values[s.table.eyes];
    const double apart = eyes == CardEyes::off ? 0 : values[s.table.eyeDistance];
    const double left = eyes == CardEyes::right ? 0.5 : -0.5;
    const double other = eyes == CardEyes::left ? -0.5 : 0.5;
    object.leftEye = glm::vec3(cardFromWorld * glm::dvec4(view.eye + right * (left * apart), 1));
    object.rightEye = glm::vec3(cardFromWorld * glm::dvec4(view.eye + right * (other * apart), 1));
    object.lamp = glm::vec3(glm::affineInverse(exhibitFromCard()) * glm::dvec4(cardLamp(), 1));
    object.halfSize = glm::vec3(cardHalfSize);
    object.scroll = static_cast<float>(roll);
    return object;
}

/// Binds one of the two prints; `slot` 0 is the one that is static or scrolls out.
void addPicture(Pass& pass, CardObject& object, int slot, const CardPicture& picture)
{
    object.prints[static_cast<std::size_t>(slot)] = picture.block;
    pass.counts["views"] += picture.block.views;
    pass.inputs.push_back({slot == 0 ? UNIT_EXHIBIT_A : UNIT_EXHIBIT_B, picture.texture});
    if (picture.raster) pass.shader.defines.emplace_back(slot == 0 ? "FIRST_RASTER" : "SECOND_RASTER");
}

/// Returns an upper bound of the light from white paper, whatever is printed on it: light of the room, the sun and the
/// lamp. The lamp is a quarter farther from the card's center than from its nearest corner.
render::ContributionBound dispersionBound(const Scene& s)
{
    const SceneLighting& around = s.context.lighting;
    const glm::dvec3& sun = around.sunIrradiance;
    const double paper = around.probeLight.absolute +
                         (std::max({sun.x, sun.y, sun.z}) + 1.3 * s.context.values[s.table.lamp]) / std::numbers::pi;
    return render::boundOf(0, 1, {{paper, "no light falls on the card"}});
}

Pass cardPass(const Scene& s, const CardPose& pose, const PreparedCard& prepared, render::FramePlan& plan)
{
    const ParameterValues& values = s.context.values;
    Pass pass = exhibitPass("lenticular/card", s.reason, values, "lenticular/card.vert", "lenticular/card.frag");
    CardObject object = cardObject(s, plan.view, pose.roll);
    addPicture(pass, object, 0, prepared.face(pose.first).picture);
    const bool lying = prepared.face(pose.first).lying;
    if (pose.roll > 0) {
        pass.shader.defines.emplace_back("SCROLLING");
        addPicture(pass, object, 1, prepared.face(otherFace(pose.first)).picture);
    }
    object.across = lying ? glm::vec2(0, -1) : glm::vec2(1, 0);
    object.along = lying ? glm::vec2(1, 0) : glm::vec2(0, 1);
    if (!values[s.table.dispersion])
        plan.skip("lenticular/dispersion", "dispersion is switched off");
    else if (plan.includeIfEffective(pass, {"lenticular/dispersion", dispersionBound(s)}))
        pass.shader.defines.emplace_back("DISPERSION");
    if (values[s.table.strips] == CardStrips::squeezed) pass.shader.defines.emplace_back("SQUEEZED");
    if (values[s.table.eyes] == CardEyes::anaglyph) pass.shader.defines.emplace_back("ANAGLYPH");
    pass.draws = {s.draw()};
    pass.draws[0].object = render::std140Bytes(object);
    s.context.bindLighting(pass);
    return pass;
}

}  // namespace

std::shared_ptr<const PreparedPart> Lenticular::prepare(const PrepareContext& context) const
{
    if (!context.seen) return nullptr;
    const ParameterValues& values = context.values;
    auto made = std::make_shared<PreparedCard>();
    const CardSheetFound found = cardSheet(table_, values);
    made->sheetNote = found.note;
    const CardPose pose = poseAt(table_, values, context.time, context.sinceOwnPress);
    for (const CardFace face : {pose.first, otherFace(pose.first)}) {
        if (face != pose.first && pose.roll == 0) continue;
        const bool front = face == CardFace::front;
        const File row = front ? table_.frontPrint : table_.backPrint;
        const CardPrint print = cardPrint(context.assets, face, values[row], values[table_.views]);
        const std::string step = front ? "lenticular/front print" : "lenticular/back print";
        if (print.source && !print.source->doubt.empty()) made->doubts.emplace_back(step, print.source->doubt);
        if (!print.failure.empty())
            made->unreadable.push_back({step, unreadableFile(values.rows()[row.row], title(), print.failure),
                                        print.source ? message("The built-in print is shown until it can be read.")
                                                     : message("The card is left out until it can be read.")});
        if (!print.source) continue;
        made->faces[static_cast<std::size_t>(face)] = {
            cardPicture(table_, values, found.sheet, print.source, context.assets),
            horizontal(table_, values, *print.source)};
    }
    return made;
}

double scrollAt(double time, double period, double hold)
{
    if (!std::isfinite(time)) return 0;
    const double turns = time / period;
    const double whole = std::floor(turns);
    return whole + glsl::smoothStep(hold, 1.0, turns - whole);
}

double scrollRest(double time, double period, double hold)
{
    if (!std::isfinite(time)) return std::numeric_limits<double>::infinity();
    const double turns = time / period;
    return std::max(0.0, (hold - (turns - std::floor(turns))) * period);
}

glm::dvec3 cardMiddle()
{
    // place_2 is 1.2 m above the floor. The ledge's top is at 0.884 m; the lip in front of the card is at z = 0.024.
    const double up = std::cos(cardLean), back = std::sin(cardLean);
    const double foot = 0.884 - 1.2 + 2 * cardHalfSize.z * back;  // Height of the front's lower edge.
    return {0, foot + cardHalfSize.y * up, 0.022 - cardHalfSize.y * back};
}

glm::dvec3 cardLamp()
{
    return cardMiddle() + glm::dvec3(-1.5, 5.3, 10.4);
}

glm::dmat4 exhibitFromCard()
{
    return glm::rotate(glm::translate(glm::dmat4(1), cardMiddle()), -cardLean, glm::dvec3(1, 0, 0));
}

render::Box Lenticular::bounds(const ParameterValues&) const
{
    return cardMesh()->bounds.transformed(exhibitFromCard());
}

double Lenticular::firstHit(const ExhibitState&, const render::Ray& ray) const
{
    // The card leans, so that its bounding box is mostly empty.
    return render::firstHit(ray.transformed(glm::affineInverse(exhibitFromCard())), cardMesh()->bounds);
}

render::Camera Lenticular::bestView(const ParameterValues&) const
{
    // From the distance that it is printed for, the whole card shows one view.
    return {cardMiddle() + glm::dvec3(0.202, 0.1, 1.58), cardMiddle() + glm::dvec3(0.01, -0.01, 0), 0.383972};
}

double Lenticular::nextChange(const ParameterValues& values, double time) const
{
    return values[table_.scroll] ? scrollRest(time, values[table_.period], values[table_.hold])
                                 : std::numeric_limits<double>::infinity();
}

double Lenticular::nextChangeOf(const ExhibitState& state) const
{
    return state.sinceOwnPress < rollTime ? 0 : nextChange(state.values, state.time);
}

bool Lenticular::press(ParameterValues& values) const
{
    values.set(table_.face, otherFace(values[table_.face]));
    return true;
}

std::vector<StandingShape> Lenticular::standingShapes(const ParameterValues&) const
{
    constexpr double print = 0.3;  // Mean color of the prints, which show rooms in their own light.
    // The box stands upright: as high as the card, and as thin.
    const glm::dvec3 half = cardHalfSize * glm::dvec3(1, std::cos(cardLean), 1);
    return {standingBox({cardMiddle() - half, cardMiddle() + half}, glm::dvec3(print))};
}

std::vector<render::LocalLight> Lenticular::localLights(const ExhibitState& state) const
{
    const glm::dvec3 fromCard = cardLamp() - cardMiddle();
    constexpr double whole = 0.4, edge = 1.2;  // Meters from the card's center; stand, plaque and button are within.
    const double distance = glm::length(fromCard);
    render::LocalLight lamp;
    lamp.position = cardLamp();
    lamp.intensity = glm::dvec3(1, 0.90, 0.76) * (state.values[table_.lamp] * distance * distance);
    lamp.axis = -fromCard / distance;
    lamp.coneInner = std::atan(whole / distance);
    lamp.coneOuter = std::atan(edge / distance);
    lamp.nearest = 0.65 * distance;  // Everything in the cone is farther away.
    return {lamp};
}

std::vector<StudyView> Lenticular::studyViews(const ParameterValues& values) const
{
    const glm::dvec3 m = cardMiddle();
    const auto view = [&](const char* name, const glm::dvec3& eye, double fov) {
        return StudyView{name, {m + eye, m, fov}, 0, values};
    };
    return {{"best view", bestView(values), 0, values},
            view("edge of the zone", {0.43, 0.1, 1.5}, 0.5),
            view("far away", {0.5, 0.35, 6}, 0.4),
            view("skewed, from above", {0.5, 0.9, 0.9}, 0.6),
            view("close up", {0.03, 0.02, 0.12}, 0.5)};
}

void Lenticular::planShadow(const PlanContext& context, render::FramePlan& plan) const
{
    const Scene scene = sceneOf(table_, context);
    render::Pass pass = meshShadow("lenticular/shadow", context);
    pass.draws = {scene.draw()};
    pass.draws[0].object = render::std140Bytes(surfaceObject(scene.worldFromCard, {}));
    plan.add(std::move(pass));
}

void Lenticular::plan(const PlanContext& context, render::FramePlan& plan) const
{
    Scene scene = sceneOf(table_, context);
    const auto& prepared = static_cast<const PreparedCard&>(*context.prepared);
    const CardPose pose = poseAt(table_, context.values, context.time, context.sinceOwnPress);
    if (!prepared.face(pose.first).picture.texture ||
        (pose.roll > 0 && !prepared.face(otherFace(pose.first)).picture.texture)) {
        plan.skip("lenticular/card", "its prints cannot be shown");
        return;
    }
    if (pose.roll > 0) scene.reason += ", and one print rolls in after the other";
    for (const auto& [step, doubt] : prepared.doubts) plan.warn(step, doubt);
    if (!prepared.sheetNote.empty()) scene.reason += "; the sheet is impossible: " + prepared.sheetNote;
    Pass card = cardPass(scene, pose, prepared, plan);
    Pass count = card;
    drawSurface(card, context.channels.withoutCounts());
    card.depthOnly = render::DepthOnly{.shader = {.vertex = "lenticular/card.vert", .fragment = "kit/depth.frag"}};
    plan.add(std::move(card));
    if (!context.channels.evaluations) {
        plan.skip("lenticular/count", "no counts are requested");
        return;
    }
    count.name = "lenticular/count";
    count.reason = "the evaluations channel is requested";
    count.phase = render::PassPhase::resolve;
    count.shader.defines.emplace_back("COUNT");
    count.colors = {Attachment::whole(evaluationsImage)};
    count.depth = Attachment::whole(depthImage);
    count.state = {.depthTest = render::DepthTest::equal, .cull = render::Cull::back, .blend = render::Blend::add};
    plan.add(std::move(count));
}

}  // namespace vitrine::lenticular
