#include "exhibits/fur/fur_passes.h"

#include "exhibits/fur/coat_mesh.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vitrine::fur {
namespace {

using render::Attachment;
using render::Pass;

constexpr const char* statesName = "fur.bodies";
constexpr const char* names[furBodyCount] = {"ball", "roll", "ring"};

// Few shells fill the silhouette of a shadow, which is seen from far away.
constexpr float shadowShells = 8;
constexpr int shadowSamples = 6;
/// Factor by which the number of shells grows towards grazing views, if they are chosen by angle.
constexpr int grazingShells = 4;
/// Largest number of triangles in all shells of a body, since a user's model may have any number of them.
constexpr double mostTriangles = 6e6;

struct Planner {
    const FurScene& scene;
    render::FramePlan& plan;
    const FurTable& table;
    FurBodies all;
    bool inView[furBodyCount] = {};

    Planner(const FurScene& s, render::FramePlan& p) : scene(s), plan(p), table(s.coats.table)
    {
        for (std::size_t i = 0; i < furBodyCount; ++i) all.bodies[i] = scene.coats.body(static_cast<int>(i));
        all.worldFromPit = glm::mat4(scene.context.worldFromExhibit);
        all.pitFromWorld = glm::mat4(glm::inverse(scene.context.worldFromExhibit));
        all.pitRadius = static_cast<float>(pitRadius);
        all.pitRim = static_cast<float>(pitRim);
        all.rugRadius = static_cast<float>(values()[table.rugRadius]);
        all.rugColor = glm::vec3(values()[table.rugColor].value);
    }
    [[nodiscard]] const ParameterValues& values() const { return scene.coats.values; }
    [[nodiscard]] render::Box bounds(int i) const { return scene.coats.bounds(i, scene.skins[i]->bounds); }

    [[nodiscard]] Pass coatPass(std::string name, std::string reason) const
    {
        Pass made = exhibitPass(std::move(name), std::move(reason), values(), "fur/coat.vert", "fur/coat.frag");
        if (values()[table.clump] > 0) made.shader.defines.emplace_back("CLUMPS");
        if (values()[table.curl] > 0) made.shader.defines.emplace_back("CURLS");
        made.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::back};
        made.reads = {statesName};
        return made;
    }
    [[nodiscard]] bool mirrored() const { return isMirrored(scene.context.worldFromExhibit); }
    [[nodiscard]] render::Draw draw(std::shared_ptr<const render::Mesh> mesh, const FurBody& body, int instances) const
    {
        render::Draw draw;
        draw.mesh = std::move(mesh);
        draw.instances = instances;
        draw.mirrored = mirrored();
        draw.object = render::std140Bytes(body);
        return draw;
    }
    [[nodiscard]] static int shellsOf(const FurBody& body)
    {
        return std::max(static_cast<int>(std::ceil(body.shellCount)), 1);
    }
    [[nodiscard]] bool byAngle() const { return values()[table.silhouette] == FurSilhouette::byAngle; }

    [[nodiscard]] FurBody affordable(int i) const
    {
        FurBody body = all.bodies[static_cast<std::size_t>(i)];
        const double triangles = static_cast<double>(scene.skins[i]->indices.size()) / 3;
        body.shellCount =
            static_cast<float>(std::min<double>(body.shellCount, std::max(mostTriangles / triangles, 1.0)));
        return body;
    }

    void shadow() const
    {
        Pass made = coatPass("fur/shadow", shadowReason);
        castShadow(made, scene.context);
        made.shader.defines.emplace_back("SHADOW");
        for (int i = 0; i < furBodyCount; ++i) {
            FurBody body = affordable(i);
            body.shellCount = std::min(body.shellCount, shadowShells);
            body.samplesBetween = std::min(body.samplesBetween, shadowSamples);
            made.draws.push_back(draw(scene.skins[i], body, shellsOf(body)));
        }
        plan.add(std::move(made));
    }

    /// Returns the body with the number of shells that this view needs.
    [[nodiscard]] FurBody seen(int i) const
    {
        FurBody body = affordable(i);
        if (!values()[table.levelOfDetail]) return body;
        const render::Box box = bounds(i);
        const double distance =
            std::max(glm::length(plan.view.eye - box.center()) - glm::length(box.halfSize()) * 0.5, 0.1);
        const double angle = 2 * plan.view.tanHalfFov.y / plan.view.raster.size.y;
        body.shellCount =
            static_cast<float>(shellsAtDistance(static_cast<int>(body.shellCount), body.strandLength, distance, angle));
        return body;
    }

    /// Returns the image of the visible strands; none if no coat is in view.
    std::optional<render::ResourceId> coat()
    {
        Pass made = coatPass("fur/coat", "");
        if (byAngle()) made.shader.defines.push_back("BY_ANGLE " + std::to_string(grazingShells));
        Pass fins = coatPass("fur/fins", "they fill the gaps between shells seen from the side");
        std::string seenBodies;
        for (int i = 0; i < furBodyCount; ++i) {
            if (!plan.runEverything && !plan.view.mayContain(bounds(i))) continue;
            const FurBody body = seen(i);
            made.draws.push_back(
                draw(scene.skins[i], body, shellsOf(body) * (byAngle() && body.shellCount > 1 ? grazingShells : 1)));
            inView[i] = true;
            if (scene.fins[i]) fins.draws.push_back(draw(scene.fins[i], body, 1));
            made.counts["shells"] += made.draws.back().instances;
            seenBodies += (seenBodies.empty() ? "" : ", ") + std::string(names[i]);
        }
        if (made.draws.empty()) {
            for (const char* name : {"fur/coat", "fur/fins", "fur/shade"}) plan.skip(name, "out of view");
            return std::nullopt;
        }
        const render::ResourceId found =
            plan.image({.name = "fur.found", .format = render::Format::rgba32f, .nearest = true});
        made.reason = "in view: " + seenBodies;
        attach(made, Attachment::cleared(found));
        attach(fins, Attachment::whole(found));
        plan.add(std::move(made));
        if (fins.draws.empty()) {
            plan.skip("fur/fins", values()[table.silhouette] == FurSilhouette::fins
                                      ? "no visible part has fins"
                                      : "silhouettes are not filled with fins");
        } else {
            fins.shader.defines.emplace_back("FIN");
            fins.state.cull = render::Cull::none;
            plan.add(std::move(fins));
        }
        return found;
    }
    void attach(Pass& made, Attachment strands) const
    {
        made.countSamples = true;
        drawSurface(made, {.normal = scene.context.channels.normal});
        made.colors.front() = std::move(strands);  // The shading pass adds the radiance.
    }

    void shade(const render::ResourceId& found) const
    {
        Pass made = exhibitPass("fur/shade", "light on the strands that were found", values(), "fur/shade.vert",
                                "fur/shade.frag");
        made.colors = {Attachment::whole(radianceImage)};
        if (scene.context.channels.albedo) writeAlbedo(made);
        // Draws the back faces of the boxes around the fur where something is in front of them, so few pixels without a
        // strand are shaded.
        made.depth = Attachment::whole(depthImage);
        made.state = {.depthTest = render::DepthTest::farther, .cull = render::Cull::front, .depthClamp = true};
        scene.context.bindLighting(made);
        made.inputs.push_back({UNIT_EXHIBIT_A, found});
        for (int i = 0; i < furBodyCount; ++i) {
            if (!inView[i]) continue;
            FurBodies lit = all;
            std::swap(lit.bodies[0], lit.bodies[static_cast<std::size_t>(i)]);
            const render::Box box = scene.coats.space(i, scene.skins[i]->bounds);
            lit.boxCenter = glm::vec3(box.center());
            lit.boxHalfSize = glm::vec3(box.halfSize());
            render::Draw one;
            one.mesh = boxMesh();
            one.mirrored = mirrored();
            one.object = render::std140Bytes(lit);
            made.draws.push_back(std::move(one));
        }
        plan.add(std::move(made));
    }

    void floor() const
    {
        Pass made =
            exhibitPass("fur/floor",
                        scene.context.alone             ? "they stand on something"
                        : values()[table.rugRadius] > 0 ? "a rug lies on the floor, and the bodies keep light off it"
                                                        : "the bodies keep light off the floor",
                        values(), "fur/floor.vert", "fur/floor.frag");
        made.phase = render::PassPhase::transparent;
        if (scene.context.alone)
            made.shader.defines.emplace_back("ALONE");
        else if (values()[table.rugRadius] <= 0)
            made.bound = {1, 0, {}};  // The pass may block all light, but adds none.
        made.colors = {Attachment::whole(radianceImage)};
        if (scene.context.channels.albedo) writeAlbedo(made);
        made.depth = Attachment::whole(depthImage);
        made.state = {.depthTest = render::DepthTest::nearer, .blend = render::Blend::premultiplied};
        made.reads = {statesName};
        scene.context.bindLighting(made);
        made.draws = {render::Draw{}};
        made.draws[0].mesh = diskMesh();
        made.draws[0].object = render::std140Bytes(all);
        plan.add(std::move(made));
    }
};

}  // namespace

void planCoatShadow(const FurScene& scene, render::FramePlan& plan)
{
    Planner(scene, plan).shadow();
}

void planCoats(const FurScene& scene, render::FramePlan& plan)
{
    Planner planner(scene, plan);
    if (const auto found = planner.coat()) planner.shade(*found);
    planner.floor();
}

}  // namespace vitrine::fur
