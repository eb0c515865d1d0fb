// The floor: contact shadows, and reflections of the objects on it and of the window.
#include "exhibits/hall/hall_scene.h"
#include "exhibits/kit/backdrop.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "render/glsl/cpu.h"
#include "render/glsl/std140.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace vitrine::hall {
namespace {

#include "shaders/kit/floor_block.glsl"

using render::Attachment;
using render::Pass;

constexpr const char* contactImage = "floor.contact";
constexpr double contactTexels = 80;  ///< Texels of the contact shadow map per meter.

/// Returns the area of the floor that the map covers: least and greatest x and z, meters.
glm::dvec4 contactArea(const HallScene& scene)
{
    const render::Box& room = scene.model.room();
    return {room.low.x, room.low.z, room.high.x, room.high.z};
}

/// Returns everything that stands on the floor or hangs over it.
std::vector<StandingShape> shapesIn(const HallScene& scene)
{
    std::vector<StandingShape> shapes = scene.model.furniture().shapes;
    for (const auto& [number, place] : scene.model.places()) {
        const std::vector<StandingShape>& own = isOccupied(scene, number) ? place.standShapes : place.clothShapes;
        shapes.insert(shapes.end(), own.begin(), own.end());
    }
    shapes.insert(shapes.end(), scene.bodies.begin(), scene.bodies.end());
    const std::vector<StandingShape> own = ownShapes(scene);
    shapes.insert(shapes.end(), own.begin(), own.end());
    return shapes;
}

/// Returns the shapes that are near enough to the floor to darken it.
std::vector<StandingShape> touching(std::vector<StandingShape> shapes)
{
    std::erase_if(shapes, [](const StandingShape& shape) {
        return shape.strength <= 0 || shape.center.y - shape.halfHeight > shape.reach || shape.halfHeight <= 0;
    });
    return shapes;
}

/// Returns the distance in meters around a shape within which reflection lobes meet more than a hundredth of it. Lobes
/// spread with the height of its top.
double spreadAround(const StandingShape& shape)
{
    return 0.1 + 0.25 * static_cast<double>(shape.center.y + shape.halfHeight);
}

/// Returns the shapes with the largest reflections that may be visible, from near to far.
std::vector<StandingShape> mirroredIn(const render::View& view, std::vector<StandingShape> shapes)
{
    const glm::dvec3 mirrorEye = view.eye * glm::dvec3(1, -1, 1);
    struct Ranked {
        StandingShape shape;
        double size, distance;
    };
    std::vector<Ranked> seen;
    for (const StandingShape& shape : shapes) {
        const render::Box box = boundsOf(shape);
        const double spread = spreadAround(shape);
        const render::Box mirrored{{box.low.x - spread, -box.high.y, box.low.z - spread},
                                   {box.high.x + spread, -box.low.y, box.high.z + spread}};
        if (!view.mayContain(mirrored)) continue;
        const double distance = glm::length(glm::dvec3(shape.center) - mirrorEye);
        seen.push_back({shape, glm::length(box.halfSize()) / std::max(distance, 0.1), distance});
    }
    const std::size_t most = std::min<std::size_t>(seen.size(), MOST_MIRRORED_SHAPES);
    std::partial_sort(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(most), seen.end(),
                      [](const Ranked& a, const Ranked& b) { return a.size > b.size; });
    seen.resize(most);
    std::sort(seen.begin(), seen.end(), [](const Ranked& a, const Ranked& b) { return a.distance < b.distance; });
    std::vector<StandingShape> result;
    for (const Ranked& one : seen) result.push_back(one.shape);
    return result;
}

/// Writes window, bars and oculus into the block.
void mirrorOpenings(const HallModel& model, FloorMirrorBlock& block)
{
    const WindowBars& bars = model.furniture().bars;
    for (const render::Box& opening : model.openings()) {
        if (flatAxis(opening) == 1)
            block.oculus = glm::vec4(opening.center().x, opening.low.y, opening.center().z, opening.halfSize().x);
        if (flatAxis(opening) != 2) continue;
        block.window = glm::vec4(opening.low.x, opening.high.x, opening.low.y, opening.high.y);
        block.windowZ = {opening.high.z, bars.z};
        for (const glm::dvec2& bar : bars.upright)
            if (block.uprightBars < MOST_UPRIGHT_BARS)
                block.bars[static_cast<std::size_t>(block.uprightBars++)] = glm::vec2(bar);
        double hidden = 0;
        for (const glm::dvec2& bar : bars.level) hidden += bar.y / opening.halfSize().y;
        block.behindBars = static_cast<float>(1 - std::min(hidden, 1.0));
    }
}

/// Sets the bit of the shape in every azimuth in which the eye sees the shape or its blurred reflection.
void markAzimuths(std::size_t index, const glm::dvec3& eye, FloorMirrorBlock& block)
{
    using std::numbers::pi;
    const StandingShape& shape = block.shapes[index];
    const glm::dvec2 size(shape.halfSize);
    const double radius = (shape.kind == STANDING_BOX ? glm::length(size) : size.x) + spreadAround(shape);
    const glm::dvec2 towards(shape.center.x - eye.x, shape.center.z - eye.z);
    const double distance = glm::length(towards);
    const double halfWidth = distance > radius ? std::asin(radius / distance) : pi;
    // The step is smaller than every bin; bins are narrowest on the diagonals.
    constexpr double bin = 4 * pi / MIRROR_AZIMUTHS;
    const double middle = std::atan2(towards.y, towards.x);
    for (double angle = -halfWidth - bin; angle < halfWidth + bin; angle += 0.2 * bin) {
        const double turn = glsl::azimuthTurn({std::cos(middle + angle), std::sin(middle + angle)});
        const auto at = static_cast<std::size_t>(std::clamp(turn * MIRROR_AZIMUTHS, 0.0, MIRROR_AZIMUTHS - 1.0));
        block.shapesAt[at] |= 1U << index;
    }
}

FloorMirrorBlock floorMirror(const HallScene& scene, const render::View& view, bool shapes)
{
    FloorMirrorBlock block;
    block.mapArea = glm::vec4(contactArea(scene));
    if (!shapes) return block;
    mirrorOpenings(scene.model, block);
    std::size_t count = 0;
    for (const StandingShape& shape : mirroredIn(view, shapesIn(scene))) {
        block.shapes[count] = shape;
        markAzimuths(count++, view.eye, block);
    }
    return block;
}

constexpr const char* screenMirrorPass = "hall/floor/mirror";

/// Plans the floor once more, over itself, when everything opaque is drawn: with reflections of the picture.
void planScreenMirror(const HallScene& scene, bool hasProbe, Pass floor, render::FramePlan& plan)
{
    if (scene.values[scene.table.floorMirror] != FloorMirror::screen)
        return plan.skip(screenMirrorPass, "the floor mirrors nothing in screen space");
    if (!hasProbe) return plan.skip(screenMirrorPass, "there is no reflection probe");
    if (plan.view.raster.drawn() != plan.view.raster.size)
        return plan.skip(screenMirrorPass, "the picture is drawn in tiles, and reflections reach beyond them");
    floor.name = screenMirrorPass;
    floor.reason = "the floor mirrors what the picture shows";
    floor.state.depthTest = render::DepthTest::nearerOrEqual;
    floor.state.depthWrite = false;
    mirrorPicture(floor, plan);
    plan.add(std::move(floor));
}

}  // namespace

void planContactShadows(const HallScene& scene, render::FramePlan& plan)
{
    if (!scene.values[scene.table.contactShadows]) {
        plan.skip("floor/contact", "contact shadows are switched off");
        return;
    }
    const glm::dvec4 area = contactArea(scene);
    plan.image({.name = contactImage,
                .format = render::Format::r8,
                .size = glm::ivec2(contactTexels * (glm::dvec2(area.z, area.w) - glm::dvec2(area))),
                .persistent = true});
    Pass pass;
    pass.name = "floor/contact";
    pass.reason = "the objects on the floor have changed";
    pass.phase = render::PassPhase::prepare;
    pass.shader = {.vertex = "hall/contact.vert", .fragment = "hall/contact.frag"};
    pass.colors = {Attachment::cleared(contactImage, glm::vec4(1))};
    pass.state.blend = render::Blend::premultiplied;
    render::Hash key;
    for (const StandingShape& shape : touching(shapesIn(scene))) {
        const render::Box box = boundsOf(shape);
        const auto reach = static_cast<double>(shape.reach);
        render::Draw draw;
        draw.object = render::std140Bytes(ContactBlock{
            .shape = shape,
            .area = glm::vec4(box.low.x - reach, box.low.z - reach, box.high.x + reach, box.high.z + reach),
            .mapArea = glm::vec4(area)});
        for (const std::byte byte : draw.object) key.addValue(byte);
        pass.draws.push_back(std::move(draw));
    }
    pass.contentHash = key.value();
    plan.add(std::move(pass));
}

void planFloor(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    Pass floor = surfacePass("hall/floor", "the floor is in view", light, channels,
                             {"POLISHED_FLOOR", "BASE_COLOR_MAP", "SURFACE_MAP"});
    for (const render::MeshInstance& part : scene.model.walls()) {
        if (!isFloor(part) || !plan.view.mayContain(part.mesh->bounds.transformed(part.modelFromPart))) continue;
        floor.draws.push_back(partDraw(scene, part));
    }
    if (floor.draws.empty()) {
        for (const std::string& name : {floor.name, std::string(screenMirrorPass)})
            plan.skip(name, "the floor is out of view");
        return;
    }
    if (scene.values[scene.table.bakedLight]) bindLightmaps(scene, light, floor);
    const bool mirrors = light.light.hasProbe && scene.values[scene.table.floorMirror] != FloorMirror::probe;
    if (scene.values[scene.table.contactShadows]) {
        floor.shader.defines.emplace_back("CONTACT_SHADOWS");
        floor.inputs.push_back({UNIT_EXHIBIT_A, std::string(contactImage)});
    }
    if (mirrors) floor.shader.defines.emplace_back("MIRROR_SHAPES");
    floor.blocks[BLOCK_EXHIBIT] = render::std140Bytes(floorMirror(scene, plan.view, mirrors));
    plan.add(floor);
    planScreenMirror(scene, light.light.hasProbe, std::move(floor), plan);
}

}  // namespace vitrine::hall
