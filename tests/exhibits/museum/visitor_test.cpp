// Visitor: places to walk, buttons to press, and objects under the pointer.

#include "exhibits/hall/walk.h"
#include "exhibits/kit/surface_net.h"
#include "exhibits/sdf_morph/sdf_morph.h"
#include "render/files/assets.h"
#include "render/scene/ray.h"
#include "tests/stability/fields.h"
#include "tests/support/museum_on_paper.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <map>

namespace vitrine {
namespace {

using glm::dvec3;
using hall::Collider;
using hall::freePlinthPlace;
using hall::Place;
using hall::visitorRadius;
using test::Scene;

constexpr double eyeHeight = 1.65;

/// Returns how far the visitor's cylinder reaches into an obstacle, in meters; 0 or less: not at all. Independent of
/// the code of walking.
double overlap(const Collider& collider, const dvec3& eye)
{
    const dvec3 p = dvec3(collider.localFromWorld * glm::dvec4(eye.x, eye.y - eyeHeight, eye.z, 1));
    if (p.y > collider.halfSize.y - 0.05 || p.y + 1.8 < -collider.halfSize.y) return -1;
    if (collider.cylinder) return collider.halfSize.x + visitorRadius - std::hypot(p.x, p.z);
    const double dx = std::abs(p.x) - collider.halfSize.x;
    const double dz = std::abs(p.z) - collider.halfSize.z;
    if (dx <= 0 && dz <= 0) return visitorRadius - std::max(dx, dz);
    return visitorRadius - std::hypot(std::max(dx, 0.0), std::max(dz, 0.0));
}

double worstOverlap(const dvec3& eye)
{
    double worst = -1;
    for (const Collider& collider : test::building().colliders()) worst = std::max(worst, overlap(collider, eye));
    return worst;
}

bool inHall(const dvec3& eye)
{
    return std::abs(eye.x) < 7 && std::abs(eye.z) < 13;
}

TEST(Walk, NeverEndsInsideAnythingHoweverOneWalks)
{
    test::Random random(5);
    dvec3 eye = test::museum().initialSceneState().camera.eye;
    ASSERT_LE(worstOverlap(eye), 1e-6);
    double traveled = 0;
    for (int i = 0; i < 20000; ++i) {
        const double stride = i % 10 == 0 ? random.number(1, 30) : random.number(0, 0.5);
        const double angle = random.number(0, 6.283185307);
        const dvec3 next =
            test::museum().surroundings().walk(eye, eye + stride * dvec3(std::cos(angle), 0, std::sin(angle)));
        ASSERT_LE(worstOverlap(next), 1e-5)
            << i << ": from " << eye.x << ',' << eye.z << " to " << next.x << ',' << next.z;
        ASSERT_TRUE(inHall(next)) << next.x << ',' << next.z;
        traveled += glm::length(next - eye);
        eye = next;
    }
    EXPECT_GT(traveled, 1000);
}

TEST(Walk, StopsAtAWallAndSlidesAlongIt)
{
    const dvec3 from(-4.9, eyeHeight, -1.9);
    const dvec3 straight = test::museum().surroundings().walk(from, {-9, eyeHeight, -1.9});
    EXPECT_GT(straight.x, -6.1 + visitorRadius - 0.2);
    EXPECT_LT(straight.x, -5.5);
    const dvec3 slanted = test::museum().surroundings().walk(from, {-9, eyeHeight, -0.9});
    EXPECT_NEAR(slanted.z, -0.9, 0.02);  // The part of the motion along the wall continues.
    EXPECT_GT(slanted.x, -6.1 + visitorRadius - 0.2);
    // Control: without obstacles, the visitor arrives.
    EXPECT_LT(
        glm::length(test::museum().surroundings().walk(from, {-4.9, eyeHeight, -1.2}) - dvec3(-4.9, eyeHeight, -1.2)),
        1e-9);
}

TEST(Walk, NoStrideIsLongEnoughToLeaveTheHouse)
{
    for (const double far : {20.0, 90.0, 1e4, 1e9})
        for (int i = 0; i < 64; ++i) {
            const double angle = i * 0.0981747704;
            const dvec3 end = test::museum().surroundings().walk(
                {0, eyeHeight, 6}, dvec3(std::cos(angle), 0, std::sin(angle)) * far + dvec3(0, eyeHeight, 6));
            EXPECT_TRUE(inHall(end)) << far << " m at " << angle << " ends at " << end.x << ',' << end.z;
        }
}

TEST(Walk, AStepIntoNowhereKeepsThePlace)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const dvec3 from(0, eyeHeight, 6);
    for (const dvec3 to :
         {dvec3(nan, eyeHeight, 6), dvec3(0, nan, 6), dvec3(0, eyeHeight, infinity), dvec3(-infinity, eyeHeight, nan)})
        EXPECT_EQ(test::museum().surroundings().walk(from, to), from);
}

TEST(Walk, EveryPlaceCanBeReachedOnFoot)
{
    constexpr double grid = 0.25;
    const dvec3 start = test::museum().initialSceneState().camera.eye;
    const auto at = [&](std::pair<int, int> cell) {
        return dvec3(start.x + grid * cell.first, eyeHeight, start.z + grid * cell.second);
    };
    std::map<std::pair<int, int>, bool> seen{{{0, 0}, true}};
    std::deque<std::pair<int, int>> open{{0, 0}};
    std::map<int, double> nearest;
    while (!open.empty()) {
        const auto cell = open.front();
        open.pop_front();
        for (const auto& [number, place] : test::building().places()) {
            const dvec3 p(place.worldFromPlace[3]);
            double distance = std::hypot(p.x - at(cell).x, p.z - at(cell).z);
            if (distance < 3) {  // From the last cell the visitor goes as near as possible.
                const dvec3 end = test::museum().surroundings().walk(at(cell), {p.x, eyeHeight, p.z});
                distance = std::hypot(p.x - end.x, p.z - end.z);
            }
            const auto found = nearest.emplace(number, distance).first;
            found->second = std::min(found->second, distance);
        }
        for (const auto& [dx, dz] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const std::pair<int, int> next{cell.first + dx, cell.second + dz};
            if (seen[next]) continue;
            if (glm::length(test::museum().surroundings().walk(at(cell), at(next)) - at(next)) > 1e-6) continue;
            seen[next] = true;
            open.push_back(next);
        }
    }
    for (int number = 1; number <= 10; ++number) {
        ASSERT_TRUE(nearest.contains(number)) << number;
        EXPECT_LE(nearest.at(number), 2.2) << "place " << number;
    }
    EXPECT_LT(seen.size(), 30000U);  // The walk stays in the building: 12 by 24 m are 4600 cells.
}

TEST(Walk, EveryPlaceStandsReadyAndTheEmptyOnesAreKnown)
{
    const std::vector<int> empty = test::museum().emptyPlaces();
    for (const auto& [i, exhibit] : test::museum().exhibits()) {
        EXPECT_EQ(std::count(empty.begin(), empty.end(), exhibit.place()), 0) << exhibit.name();
        EXPECT_TRUE(test::museum().isInHall(i)) << exhibit.name();
    }
    EXPECT_EQ(empty.size() + test::museum().exhibits().size() + 1, test::building().places().size());
    for (int number = 1; number <= 10; ++number) {
        ASSERT_TRUE(test::building().place(number)) << number;
        EXPECT_TRUE(test::building().place(number)->worldFromPlaque) << number;
    }
    EXPECT_TRUE(test::building().place(freePlinthPlace)) << "the visitor's plinth";
    EXPECT_FALSE(test::building().place(11));
}

/// The frame of the tenth place hangs in the middle arch of the right wall, facing the room.
TEST(Walk, TheFrameOfTheTenthPlaceHangsInItsArch)
{
    const Place& place = *test::building().place(10);
    EXPECT_LT(glm::distance(dvec3(place.worldFromPlace[3]), dvec3(6, 1.65, 0)), 1e-12);
    EXPECT_LT(glm::distance(dvec3(place.worldFromPlace[2]), dvec3(-1, 0, 0)), 1e-12) << "z runs into the room";
    ASSERT_EQ(place.stand.size(), 1U);
    ASSERT_EQ(place.cloth.size(), 2U) << "while no work hangs in it, a panel fills it";
    const render::Box box = place.stand[0].mesh->bounds.transformed(place.stand[0].modelFromPart);
    EXPECT_NEAR(box.high.x, 6, 1e-6) << "it touches the wall";
    EXPECT_NEAR(box.high.z - box.low.z, 2.4 + 2 * 0.14, 1e-6);
    // The arch is 5.2 m wide; the plaque hangs beside the frame, within the arch.
    const double plaque = (*place.worldFromPlaque)[3].z;
    EXPECT_GT(plaque - 0.15, box.high.z);
    EXPECT_LT(plaque + 0.15, 2.6);
    // Normals of all triangles point away from the wall or along it, and match their winding.
    const render::Mesh& mesh = *place.stand[0].mesh;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        const dvec3 winding = glm::cross(at(1) - at(0), at(2) - at(0));
        ASSERT_GT(glm::dot(winding, dvec3(mesh.vertices[mesh.indices[i]].normal)), 0);
        EXPECT_GT(mesh.vertices[mesh.indices[i]].normal.z, -1e-6);
    }
}

/// Returns the position of the sdf exhibit's button in world space.
dvec3 button()
{
    return dvec3((*test::building().place(1)->worldFromButton)[3]);
}

std::optional<LookedAt> lookFrom(const dvec3& eye, const dvec3& target)
{
    SceneState sceneState = test::museum().initialSceneState();
    sceneState.camera.eye = eye;
    sceneState.camera.target = target;
    FrameRequest request;
    request.camera = sceneState.camera;
    return test::museum().surroundings().lookedAt(test::museum().prepare(sceneState, request));
}

TEST(LookedAt, TheButtonAnswersWithinTwoMetersOnly)
{
    const dvec3 away = glm::normalize(dvec3(0.3, 0.5, 1));
    for (const double distance : {0.3, 1.0, 1.5, 1.99}) {
        const auto found = lookFrom(button() + away * distance, button());
        ASSERT_TRUE(found) << distance;
        EXPECT_EQ(found->text, "E – let it melt");
        EXPECT_EQ(found->exhibit, *test::museum().find("sdf_morph"));
    }
    for (const double distance : {2.01, 2.5, 10.0})
        EXPECT_FALSE(lookFrom(button() + away * distance, button())) << distance;
}

TEST(LookedAt, TheButtonAnswersOnlyWhenTheLookRestsOnIt)
{
    const dvec3 eye = button() + dvec3(0, 0.6, 1.2);
    EXPECT_TRUE(lookFrom(eye, button() + dvec3(0.05, 0, 0)));
    EXPECT_FALSE(lookFrom(eye, button() + dvec3(0.25, 0, 0)));
    EXPECT_FALSE(lookFrom(eye, button() + dvec3(0, 0.4, 0)));
    EXPECT_FALSE(lookFrom(eye, eye + (eye - button())));  // Away from it.
    EXPECT_FALSE(lookFrom(eye, eye));
}

TEST(LookedAt, PressingMeltsAndPressingAgainStops)
{
    Scene scene;
    const HasButton& button = *capability<HasButton>(test::museum().exhibit(scene.sdf));
    EXPECT_TRUE(button.press(scene.object()));
    EXPECT_TRUE(scene.object()[test::sdfTable().animate]);
    EXPECT_TRUE(button.press(scene.object()));
    EXPECT_FALSE(scene.object()[test::sdfTable().animate]);
}

/// Looks at the button of the mug from the other side of its plinth, close enough to press it.
TEST(LookedAt, NoButtonAnswersThroughItsPlinth)
{
    const dvec3 behind(-0.75, 0.62, -0.5);
    ASSERT_LT(glm::length(button() - behind), 1.95);
    EXPECT_FALSE(lookFrom(behind, button()));
    // Control: from the same distance, with nothing in between.
    EXPECT_TRUE(lookFrom(button() + glm::length(button() - behind) * glm::normalize(dvec3(0.3, 0.4, 1)), button()));
}

std::optional<Pointed> pointed(const Scene& scene, glm::dvec2 ndc = {0, 0})
{
    return test::museum().surroundings().pick(test::museum().prepare(scene.sceneState, scene.request), scene.request,
                                              ndc);
}

TEST(Pick, FindsTheExhibitUnderThePointer)
{
    Scene scene;
    // Side of the handle, because the center of a torus is a hole.
    const render::Box box = test::museum()
                                .subject(scene.sdf)
                                .bounds(scene.object())
                                .transformed(test::museum().worldFromExhibit(scene.sdf));
    scene.see(dvec3(box.center().x, box.center().y, 3), {box.center().x, box.low.y + 0.1, box.center().z});
    const auto found = pointed(scene);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->exhibit, scene.sdf);
    EXPECT_EQ(found->name, "Torus to Mug");
    EXPECT_FALSE(found->button);
    EXPECT_EQ(found->view, test::museum().bestView(scene.sdf, scene.object()));
    EXPECT_FALSE(pointed(scene, {-0.98, 0.95}));
    scene.see({0, 1.65, 3}, {0, 1.65, 12});
    EXPECT_FALSE(pointed(scene));
}

TEST(Pick, AWallIsAWallThoughABoxOfAnExhibitIsBeforeIt)
{
    // Over the pit, below the top of the bodies' space, at the bare wall behind.
    Scene scene;
    scene.see({0, 1.65, 3}, {6, 1.25, 3});
    const std::size_t fur = *test::museum().find("fur");
    const render::Box box = test::museum()
                                .subject(fur)
                                .bounds(scene.sceneState.values[fur])
                                .transformed(test::museum().worldFromExhibit(fur));
    ASSERT_LT(render::firstHit(
                  {scene.sceneState.camera.eye, scene.sceneState.camera.target - scene.sceneState.camera.eye}, box),
              1);
    EXPECT_FALSE(pointed(scene));
    // Control: the bodies in the pit.
    scene.see({0, 1.65, 3}, {3.3, -0.2, 3});
    ASSERT_TRUE(pointed(scene));
    EXPECT_EQ(pointed(scene)->exhibit, fur);
}

TEST(Pick, WhatStandsBeforeAnExhibitIsNotSeenThrough)
{
    Scene scene;
    // The mug, from below through its plinth.
    const dvec3 mug(test::museum().worldFromExhibit(scene.sdf)[3]);
    scene.see(mug + dvec3(0, -1.25, 0.6), mug);
    const auto found = pointed(scene);
    EXPECT_FALSE(found && found->exhibit == scene.sdf);
}

TEST(Pick, AButtonIsNamedByWhatItDoes)
{
    Scene scene;
    scene.see(button() + dvec3(0.2, 0.5, 0.9), button());
    const auto found = pointed(scene);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->button);
    EXPECT_TRUE(found->inReach);
    EXPECT_EQ(found->name, "E – let it melt");
    scene.see(button() + dvec3(0.2, 1.5, 2.9), button());
    ASSERT_TRUE(pointed(scene));
    EXPECT_FALSE(pointed(scene)->inReach);
    EXPECT_EQ(pointed(scene)->name, "Torus to Mug");  // A click visits it first.
}

TEST(Pick, TheVisitorsOwnObjectCanBeVisited)
{
    Scene scene;
    const dvec3 above = dvec3(test::building().place(freePlinthPlace)->worldFromPlace[3]) + dvec3(0, 0.15, 0);
    scene.see(above + dvec3(0.3, 0.6, 2.2), above);
    EXPECT_FALSE(pointed(scene));
    scene.hall().setParameter(*scene.hall().table().find("model"), render::asset("models/teddy.glb").string());
    const auto found = pointed(scene);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->exhibit, std::size_t{0});
    EXPECT_EQ(found->name, "Your object: teddy.glb");
    // Its view shows it, from outside and close by.
    scene.see(found->view);
    const auto again = pointed(scene);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->name, "Your object: teddy.glb");
    EXPECT_GT(again->distance, 0.2);
    EXPECT_LT(again->distance, 4);
}

TEST(Pick, AFieldIsHitWhereItsMeshIs)
{
    // Sphere tracing compared with triangles of the same body: both hit at the same distance.
    test::Random random(6);
    Scene scene;
    scene.object().set(test::sdfTable().morph, 0.6);
    const sdf_morph::SdfMorph exhibit;
    const SdfBody body = exhibit.body(scene.object(), 0);
    const auto mesh = surfaceNet(body.distance, body.box, 96, "mesh");
    const double cell =
        2 * std::max({mesh->bounds.halfSize().x, mesh->bounds.halfSize().y, mesh->bounds.halfSize().z}) / 96;
    int hits = 0, wrong = 0;
    for (int i = 0; i < 600; ++i) {
        const dvec3 eye = mesh->bounds.center() + random.direction() * random.number(1.2, 4);
        const render::Ray ray{eye, mesh->bounds.center() + random.point(0.5) - eye};
        const double field = exhibit.firstHit({scene.object()}, ray);
        const double triangles = render::firstHit(ray, *mesh, render::Faces::both);
        hits += std::isfinite(field);
        // Grazing rays may differ.
        const bool same =
            std::isfinite(field) == std::isfinite(triangles) &&
            (!std::isfinite(field) || std::abs(field - triangles) * glm::length(ray.direction) < 3 * cell);
        wrong += !same;
    }
    EXPECT_GT(hits, 120);
    EXPECT_LT(hits, 570);  // It has a hole, and rays pass beside it.
    EXPECT_LT(wrong, 12);
}

TEST(Rays, ParallelToAFaceAreNoSpecialCase)
{
    // A plain slab test is 0/0 there.
    const render::Box box{{-1, -1, -1}, {1, 1, 1}};
    for (const double y : {-1.0, -0.999, 0.0, 0.999, 1.0})
        EXPECT_EQ(render::firstHit({{0, y, 3}, {0, 0, -1}}, box), 2) << y;
    for (const double y : {-1.001, 1.001})
        EXPECT_FALSE(std::isfinite(render::firstHit({{0, y, 3}, {0, 0, -1}}, box))) << y;
    EXPECT_EQ(render::firstHit({{0, 0, 0}, {0, 0, -1}}, box), 0);
    EXPECT_FALSE(std::isfinite(render::firstHit({{0, 0, -3}, {0, 0, -1}}, box)));
}

TEST(Rays, DistancesAreTheSameInEverySpace)
{
    test::Random random(8);
    for (int i = 0; i < 200; ++i) {
        const dvec3 center = random.point(3);
        const double radius = random.number(0.1, 1);
        const render::Ray ray{random.point(5), random.direction() * random.number(0.1, 10)};
        const double here = render::firstHit(ray, center, radius);
        const glm::dmat4 unit = glm::inverse(glm::scale(glm::translate(glm::dmat4(1), center), dvec3(radius)));
        const double there = render::firstHit(ray.transformed(unit), dvec3(0), 1);
        ASSERT_EQ(std::isfinite(here), std::isfinite(there));
        if (std::isfinite(here)) {
            EXPECT_NEAR(here, there, 1e-9);
            if (here > 0) {
                EXPECT_NEAR(glm::length(ray.at(here) - center), radius, 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace vitrine
