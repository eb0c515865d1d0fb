// S4, S9, S10, S11: the object among others. Depths are compared exactly: the nearest is visible.

#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::sdf_morph {
namespace {

using glm::dmat4;
using glm::dvec3;
using namespace test;

class Scene : public test::GlTest {};

const dmat4 away = glm::translate(dmat4(1), dvec3(0, -500, 0));

void hideTheSun(Shot& shot)
{
    shot.hall().set(hallTable().sunAzimuth, 0.7);
    shot.hall().set(hallTable().sunElevation, 0.35);
}

/// Sets the sun to shine through the window onto the exhibit, whose shadow falls on the floor of the near half.
void shineOnTheExhibit(Shot& shot)
{
    shot.hall().set(hallTable().sunAzimuth, 0.0);
    shot.hall().set(hallTable().sunElevation, 0.21);
}

/// Takes a picture of the exhibit without the hall, by the same camera.
Picture withoutHall(const Shot& inHall)
{
    Shot shot = inHall;
    shot.request.frame.alone = shot.exhibit;
    shot.request.frame.subject.reset();
    shot.request.frame.transparent = true;
    shot.request.frame.exhibitTransform = inHall.worldFromExhibit();
    return shot.take();
}

void expectTheNearerOne(const Picture& both, const Picture& a, const Picture& b)
{
    int fromA = 0, fromB = 0;
    both.each([&](int x, int y) {
        const float nearer = std::min(a.image.at(x, y, 4), b.image.at(x, y, 4));
        EXPECT_EQ(both.image.at(x, y, 4), nearer) << x << ',' << y;
        fromA += a.hit(x, y) && b.hit(x, y) && a.depth(x, y) < b.depth(x, y);
        fromB += a.hit(x, y) && b.hit(x, y) && b.depth(x, y) < a.depth(x, y);
    });
    EXPECT_GT(fromA, 20) << "the first must hide part of the second";
    EXPECT_GT(fromB, 20) << "the second must hide part of the first";
}

using LongScene = Scene;

TEST_F(LongScene, ThePlinthHidesTheObjectPixelExactly)
{
    Shot shot;
    shot.inHall();
    hideTheSun(shot);  // Without the object's shadow on the hall: pixels in which the hall is nearer must not change.
    shot.see({0.3, 0.2, 1.3}, {0, 1.2, 0});
    shot.request.frame.camera.fovY = 1.2;
    const Picture both = shot.take();
    const Picture object = withoutHall(shot);
    Shot empty = shot;
    const Picture hall = empty.transform(away).take();
    expectTheNearerOne(both, hall, object);
    both.each([&](int x, int y) {
        if (object.depth(x, y) <= hall.depth(x, y) && object.hit(x, y)) return;
        for (int c = 0; c < 4; ++c) EXPECT_EQ(both.image.at(x, y, c), hall.image.at(x, y, c)) << x << ',' << y;
    });
}

TEST_F(Scene, SunkIntoThePlinthTheTwoIntersect)
{
    Shot shot;
    shot.inHall();
    hideTheSun(shot);
    shot.transform(glm::translate(dmat4(1), dvec3(0.12, -0.42, 0.2))).see({0.9, 1.9, 2.2}, {0, 0.9, 0});
    const Picture both = shot.take();
    Shot empty = shot;
    expectTheNearerOne(both, Shot(empty).transform(away).take(), withoutHall(shot));
}

TEST_F(Scene, TheBoxOverlayIntersectsTheObject)
{
    Shot shot;
    shot.values().set(sdfTable().boxSize, 0.7);
    const Picture object = shot.take();
    shot.values().set(sdfTable().showBox, true);
    const Picture both = shot.take();
    int hidden = 0, inFront = 0;
    both.each([&](int x, int y) {
        if (!object.hit(x, y)) return;
        EXPECT_LE(both.image.at(x, y, 4), object.image.at(x, y, 4)) << x << ',' << y;
        inFront += both.image.at(x, y, 4) == object.image.at(x, y, 4);
        hidden += both.image.at(x, y, 4) < object.image.at(x, y, 4);
    });
    EXPECT_GT(inFront, 100);
    EXPECT_GT(hidden, 10);
}

/// Adds the object's passes of `other` to `plan` under another name, like a second exhibit.
render::FramePlan withTheObjectOf(const render::FramePlan& plan, const render::FramePlan& other)
{
    render::FramePlan both;
    both.view = plan.view;
    for (const auto& [name, image] : plan.images()) both.image(image);
    for (const render::Pass& pass : plan.passes()) both.add(pass);
    for (render::Pass pass : other.passes()) {
        if (pass.name.rfind("sdf_morph/", 0) != 0) continue;
        pass.name = "second/" + pass.name;
        const auto rename = [](std::string& name) {
            if (name == "sdf_morph.cone") name = "second.cone";
        };
        for (render::Attachment& a : pass.colors) rename(a.image);
        for (render::SampledTexture& input : pass.inputs)
            if (auto* name = std::get_if<std::string>(&input.source)) rename(*name);
        both.add(std::move(pass));
    }
    render::ImageInfo cone = plan.images().at("sdf_morph.cone");
    cone.name = "second.cone";
    both.image(cone);
    both.prune({"frame", depthImage});
    return both;
}

TEST_F(Scene, TwoIntersectingFieldsGiveTheirUnion)
{
    Shot first;
    first.values().set(sdfTable().morph, 0.0);
    Shot second;
    second.values().set(sdfTable().morph, 1.0);
    second.transform(glm::translate(glm::rotate(dmat4(1), 0.5, dvec3(0, 1, 0)), dvec3(0.15, 0.05, 0.1)));
    const auto draw = [](const render::FramePlan& plan) {
        (void)gallery().renderer.draw(plan);
        return gallery().renderer.read(depthImage);
    };
    const auto planOf = [](const Shot& shot) {
        return test::planned(gallery().museum, shot.sceneState, shot.request.frame,
                             gallery().renderer.persistentState());
    };
    const render::Image a = draw(planOf(first));
    const render::Image b = draw(planOf(second));
    const render::Image ab = draw(withTheObjectOf(planOf(first), planOf(second)));
    const render::Image ba = draw(withTheObjectOf(planOf(second), planOf(first)));
    int both = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        EXPECT_EQ(ab.pixels[i], std::max(a.pixels[i], b.pixels[i]));  // Reversed depth: near is large.
        EXPECT_EQ(ba.pixels[i], ab.pixels[i]) << "the order of drawing must not matter";
        both += a.pixels[i] > 0 && b.pixels[i] > 0;
    }
    EXPECT_GT(both, 100);
}

TEST_F(Scene, TheShadowMapHoldsWhereTheSunsRaysHit)
{
    for (const double morph : {0.0, 1.0}) {
        Shot shot;
        shot.inHall();
        shineOnTheExhibit(shot);
        shot.values().set(sdfTable().morph, morph);
        shot.hall().set(hallTable().shadowMapSize, 512);
        const render::FramePlan plan =
            test::planned(gallery().museum, shot.sceneState, shot.request.frame, gallery().renderer.persistentState());
        const render::Pass* pass = plan.find("sdf_morph/shadow");
        ASSERT_TRUE(pass);
        const render::View light = *pass->view;
        (void)gallery().renderer.draw(plan);
        const render::Image map = gallery().renderer.read(exhibitShadowImage);
        ASSERT_EQ(map.width, light.raster.size.x);

        const Solid solid(shot.values(), shot.worldFromExhibit());
        const dmat4 worldFromView = glm::inverse(light.viewFromWorld);
        // The exhibit's own: an eighth of a texel.
        const double halfTexel = 0.25 / (light.clipFromView[0][0] * map.width);
        int hits = 0, missing = 0, extra = 0;
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) {
                const glm::dvec2 ndc =
                    glm::dvec2(x + 0.5, map.height - y - 0.5) / glm::dvec2(map.width, map.height) * 2.0 - 1.0;
                const glm::dvec4 start = glm::inverse(light.clipFromView) * glm::dvec4(ndc, 1, 1);
                const test::Ray ray{dvec3(worldFromView * start), glm::dmat3(worldFromView) * dvec3(0, 0, -1)};
                const Found truth = solid.trace(ray, 0, 0, halfTexel);
                hits += truth.hit;
                missing += truth.hit && truth.cosine > 0.05 && map.at(x, y) == 0;
                extra += !truth.hit && truth.closest > 1.05 && map.at(x, y) > 0;
                if (truth.hit && !truth.grazed && truth.cosine > 0.3 && map.at(x, y) > 0) {
                    const double depth = (light.clipFromWorld * glm::dvec4(truth.world, 1)).z;
                    // In meters: within two half texels divided by the cosine.
                    EXPECT_NEAR(map.at(x, y), depth,
                                std::abs(light.clipFromView[2][2]) * (2 * halfTexel / truth.cosine + 1e-4))
                        << x << ',' << y;
                }
            }
        EXPECT_GT(hits, 500);
        EXPECT_EQ(missing, 0) << "of " << hits;
        EXPECT_EQ(extra, 0);
    }
}

TEST_F(Scene, TheFloorIsDarkExactlyWhereTheObjectHidesTheSun)
{
    Shot shot;
    shot.inHall();
    shineOnTheExhibit(shot);
    shot.hall().set(hallTable().shadowMapSize, 2048);
    shot.values().set(sdfTable().morph, 0.0);
    shot.see({0.01, 6, 6.9}, {0, 0, 6.8});
    shot.request.frame.camera.fovY = 0.7;
    const Picture with = shot.take();
    Shot empty = shot;
    const Picture without = empty.transform(away).take();
    Shot unshadowed = shot;
    unshadowed.hall().set(hallTable().sunShadows, false);
    const Picture lit = unshadowed.transform(away).take();

    const Solid solid(shot.values(), shot.worldFromExhibit());
    const dvec3 towardsSun(0, std::sin(0.21), -std::cos(0.21));
    int shaded = 0, wrong = 0, open = 0;
    with.each([&](int x, int y) {
        // Only where the sun reaches the floor without the object.
        if (!with.hit(x, y) || without.luminance(x, y) < 0.99 * lit.luminance(x, y)) return;
        const test::Ray ray = test::pixelRay(with.view, x, y);
        const dvec3 floor = ray.origin + ray.direction * with.depth(x, y);
        // Two widths of the filter (5 texels of about 4 mm, slanted) are neither light nor shade.
        const Found dark = solid.trace({floor, towardsSun}, 0.01, 0, 0.03);
        const double ratio = with.luminance(x, y) / without.luminance(x, y);
        const double inside = dark.hit ? solid.distance(solid.toLocal(dark.world + towardsSun * 0.06)) : 0;
        if (inside < -0.03) {
            ++shaded;
            wrong += ratio > 0.85;
        } else if (!dark.hit && dark.closest > 1) {
            ++open;
            wrong += ratio < 0.99;
        }
    });
    EXPECT_GT(shaded, 50);
    EXPECT_GT(open, 100);
    EXPECT_EQ(wrong, 0);
}

TEST_F(Scene, TheObjectLiesInTheShadowOfTheWalls)
{
    Shot shot;
    shot.inHall();
    hideTheSun(shot);
    shot.values().set(sdfTable().metalness, 0.0);
    shot.values().set(sdfTable().roughness, 0.8);
    const Picture shaded = shot.take();
    shot.hall().set(hallTable().sunShadows, false);
    const Picture lit = shot.take();
    double a = 0, b = 0;
    const Picture mask = withoutHall(shot);
    mask.each([&](int x, int y) {
        if (!mask.hit(x, y)) return;
        a += shaded.luminance(x, y);
        b += lit.luminance(x, y);
    });
    EXPECT_LT(a, 0.8 * b);
}

}  // namespace
}  // namespace vitrine::sdf_morph
