// Pictures of coats: finite for all settings, and within their length; the effect of every parameter.

#include "render/failure.h"
#include "render/plan/diagnostics.h"
#include "tests/exhibits/fur/fur_shot.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::fur {
namespace {

using namespace test;

class FurTest : public GlTest {};

using LongFurTest = FurTest;

TEST_F(FurTest, WithoutLengthIsTheSkin)
{
    FurShot bare, one;
    for (FurShot* shot : {&bare, &one})
        for (int i = 0; i < furBodyCount; ++i)
            shot->values().set(furTable().coats[static_cast<std::size_t>(i)].length, 0.0);
    one.shells(1, FurSilhouette::none);
    const Picture a = bare.take();
    EXPECT_GT(a.hits(), 300);
    EXPECT_EQ(largestDifference(a.image, one.take().image), 0);
    FurShot furry;
    EXPECT_GT(furry.take().hits(), a.hits());
}

TEST_F(FurTest, OneShellIsAPictureToo)
{
    FurShot shot;
    const Picture p = shot.shells(1, FurSilhouette::march).take();
    EXPECT_EQ(notFinite(p.image, 4), "");
    EXPECT_GT(p.hits(), 300);
}

TEST_F(FurTest, AHalfTurnIsTheSameEitherWay)
{
    FurShot there, back;
    there.hand({0, 0, 0}, 3.141592653589793);
    back.hand({0, 0, 0}, -3.141592653589793);
    const Picture p = there.take();
    EXPECT_LT(colorDifference(p, back.take()), 0.02);
    EXPECT_EQ(notFinite(p.image, 4), "");
    EXPECT_GT(p.hits(), 300);
}

TEST_F(FurTest, StaysWithinItsLengthHoweverItIsPulled)
{
    for (const glm::dvec3 tipOffset : {glm::dvec3(20, 0, 0), glm::dvec3(0, -3, 0), glm::dvec3(-20, 20, 20)}) {
        FurShot shot;
        shot.hand(tipOffset, 1.0);
        const Picture p = shot.take();
        const glm::dmat4 worldFromView = glm::inverse(p.view.viewFromWorld);
        p.each([&](int x, int y) {
            if (!p.hit(x, y)) return;
            const glm::dvec2 ndc((x + 0.5) / p.width() * 2 - 1, 1 - (y + 0.5) / p.height() * 2);
            const glm::dvec3 world(worldFromView *
                                   glm::dvec4(glm::dvec3(ndc * p.view.tanHalfFov, -1) * p.depth(x, y), 1));
            // No body with the longest fur reaches farther than this from the center of the pit.
            EXPECT_LT(std::hypot(world.x, world.z), 1.45);
            EXPECT_LT(world.y, 2 * ballRadius + 0.2 + 0.2);
            EXPECT_GT(world.y, -0.05) << "through the floor";
        });
    }
}

TEST_F(FurTest, IsFiniteWhateverOneSets)
{
    const auto& t = furTable();
    const std::vector<std::function<void(ParameterValues&)>> hostile{
        [&](ParameterValues& v) {
            v.set(t.coats[furBall].density, 1);
            v.set(t.coats[furRing].density, 1000000);
        },
        [&](ParameterValues& v) {
            v.set(t.coats[furBall].thickness, 0.1);
            v.set(t.coats[furRoll].thickness, 0.0001);
        },
        [&](ParameterValues& v) {
            v.set(t.coats[furBall].length, 1.0);
            v.set(t.coats[furRoll].length, 1e-7);
        },
        [&](ParameterValues& v) {
            v.set(t.strandRoundness, 0.999);
            v.set(t.coats[furBall].uniformity, 0.0);
            v.set(t.coats[furRoll].uniformity, 1.0);
        },
        [&](ParameterValues& v) {
            v.set(t.curvature, 0.0);
            v.set(t.comb, 10.0);
        },
        [&](ParameterValues& v) {
            v.set(t.curvature, 10.0);
            v.set(t.disorder, 10.0);
        },
        [&](ParameterValues& v) { v.set(t.distanceAttenuation, 0.01); },
        [&](ParameterValues& v) {
            v.set(t.distanceAttenuation, 3.0);
            v.set(t.shellCount, 2);
        },
        [&](ParameterValues& v) {
            v.set(t.clump, 0.95);
            v.set(t.clumpSize, 1.0);
            v.set(t.curl, 1.0);
            v.set(t.curlTurns, 20.0);
        },
        [&](ParameterValues& v) {
            v.set(t.occlusionAttenuation, 0.0);
            v.set(t.gradient, 10.0);
            v.set(t.sheen, 4.0);
            v.set(t.rimLight, 8.0);
        },
        [&](ParameterValues& v) {
            v.set(t.wind, 20.0);
            v.set(t.gustiness, 1.0);
        },
        [&](ParameterValues& v) {
            v.set(t.lamp, 1000.0);
            v.set(t.lampDirection, {{0, -1, 0}});
        },
        [&](ParameterValues& v) {
            v.set(t.flattening, 0.0);
            v.set(t.growing, true);
            v.set(t.growth, 0.2);
            v.set(t.growthRate, 20.0);
        },
        [&](ParameterValues& v) {
            v.set(t.frozenAt, 0.5);
            v.set(t.springModel, FurSpring::explicitEuler);
            v.set(t.frequency, 1000.0);
            v.set(t.springRate, 15);
            v.set(t.displacementLimit, 100.0);
        },
        [&](ParameterValues& v) {
            v.set(t.frozenAt, 0.2);
            v.set(t.inertia, 100.0);
            v.set(t.damping, 0.0);
            v.set(t.strength, 10.0);
        },
    };
    for (std::size_t i = 0; i < hostile.size(); ++i) {
        FurShot shot;
        shot.size(64, 40);
        hostile[i](shot.values());
        const Picture p = shot.take();
        EXPECT_EQ(notFinite(p.image, 4), "") << i;
        EXPECT_GT(p.hits(), 20) << i;
    }
}

TEST_F(FurTest, SurvivesMirrorsAndUnevenScale)
{
    FurShot plain;
    const int hits = plain.take().hits();
    FurShot mirrored;
    mirrored.transform(glm::scale(glm::dmat4(1), glm::dvec3(1, 1, -1)));
    mirrored.see({-0.05, 1.55, 3.15}, {0, 0.36, 0});
    const Picture m = mirrored.take();
    EXPECT_EQ(notFinite(m.image, 4), "");
    EXPECT_NEAR(static_cast<double>(m.hits()) / hits, 1, 0.25);
    FurShot uneven;
    uneven.transform(glm::scale(glm::dmat4(1), glm::dvec3(0.3, 2, 1)));
    EXPECT_EQ(notFinite(uneven.take().image, 4), "");
}

TEST_F(FurTest, AVisitorsModelWearsTheRingsCoatAndJumps)
{
    const TemporaryFolder folder;
    for (const bool awkward : {false, true}) {
        // An open sheet, and the same twice, mirrored, unevenly scaled, with a node of size 0.
        GltfBuilder file;
        const int mesh = file.triangle();
        file.node({{"mesh", mesh}});
        if (awkward) {
            file.node({{"mesh", mesh}, {"scale", {-1, 0.2, 3}}, {"translation", {0, 0, 0.5}}});
            file.node({{"mesh", mesh}, {"scale", {1, 0, 1}}});
        }
        const std::string path = (folder / (awkward ? "awkward.glb" : "sheet.glb")).string();
        writeBytes(path, file.glb());
        FurShot shot;
        const Picture ring = shot.take();
        shot.values().set(furTable().ringModel, path);
        for (const double at : {0.0, 0.3, 1.5}) {
            shot.values().set(furTable().frozenAt, at);
            const Picture p = shot.take();
            EXPECT_EQ(notFinite(p.image, 4), "") << at;
            EXPECT_GT(p.hits(), 300) << at;
            EXPECT_GT(colorDifference(p, ring), 0.001) << at;
        }
        render::Diagnostics log;
        const auto lines = [&] {
            return log.begun(test::planned(gallery().museum, shot.sceneState, shot.request.frame).skipped());
        };
        const std::vector<render::CulledPass> first = lines();
        ASSERT_EQ(first.size(), awkward ? 1U : 0U);
        if (awkward) {
            EXPECT_EQ(lineOf(first[0]), "fur/model: 1 triangle without area was left out");
        }
        EXPECT_TRUE(lines().empty()) << "said again in the next frame";
        for (const FurSilhouette silhouette : {FurSilhouette::fins, FurSilhouette::byAngle}) {
            shot.values().set(furTable().silhouette, silhouette);
            EXPECT_EQ(notFinite(shot.take().image, 4), "");
        }
    }
    FurShot shot;
    shot.values().set(furTable().ringModel, (folder / "no-such.glb").string());
    shot.request.frame.needsFiles = true;
    try {
        (void)shot.take();
        FAIL() << "a file that is not there was worn";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("no-such.glb"), std::string::npos);
    }
}

TEST_F(FurTest, GrowsDarkerTowardsTheRoots)
{
    const auto brightness = [](double attenuation, double bias) {
        FurShot shot;
        shot.values().set(furTable().occlusionAttenuation, attenuation);
        shot.values().set(furTable().occlusionBias, bias);
        return shot.take().mean();
    };
    EXPECT_GT(brightness(0, 0), brightness(1, 0));
    EXPECT_GT(brightness(1, 0), brightness(4, 0));
    EXPECT_GT(brightness(4, 0.4), brightness(4, 0));
}

TEST_F(FurTest, CastsTheLampsShadowOnTheFloorAndOnItsNeighbors)
{
    FurShot shot;
    shot.values().set(furTable().lamp, 20.0);
    shot.values().set(furTable().lampDirection, {glm::normalize(glm::dvec3(-1, 1, 0))});
    shot.size(192, 120);
    const Picture p = shot.take();
    const auto floorAt = [&](double x, double z) {
        const glm::dvec4 clip = p.view.clipFromWorld * glm::dvec4(x, 0, z, 1);
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        return p.luminance(static_cast<int>((ndc.x * 0.5 + 0.5) * p.width()),
                           static_cast<int>((0.5 - ndc.y * 0.5) * p.height()));
    };
    // The ball is at (-0.62, -0.02); its shadow is half a meter to the right of it. In front on the left there is none.
    EXPECT_LT(floorAt(-0.05, 0.25), 0.5 * floorAt(-0.75, 0.75));
}

TEST_F(LongFurTest, IsThinnedFromAfarWithoutAChangeOfLook)
{
    FurShot with, without;
    for (FurShot* shot : {&with, &without}) {
        shot->see({-0.3, 2.2, 7}, {0, 0.3, 0}).request.frame.camera.fovY = 0.35;
        shot->request.samples = 8;
    }
    without.values().set(furTable().levelOfDetail, false);
    const Picture thinned = with.take();
    const Picture full = without.take();
    EXPECT_LT(with.samplesPassed(), without.samplesPassed());
    EXPECT_NEAR(thinned.mean() / full.mean(), 1, 0.04);
}

}  // namespace
}  // namespace vitrine::fur
