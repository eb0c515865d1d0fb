// S6, S13: light on the object. H41, H42: mirrors have no noise and create no light.

#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::sdf_morph {
namespace {

using glm::dvec3;
using namespace test;

class Light : public test::GlTest {};

dvec3 meanOfObject(const Picture& p)
{
    dvec3 sum(0);
    p.each([&](int x, int y) {
        if (p.hit(x, y)) sum += p.color(x, y);
    });
    return sum / static_cast<double>(std::max(p.hits(), 1));
}

TEST_F(Light, TheHighlightMovesWithTheSun)
{
    Shot shot;
    shot.values().set(sdfTable().roughness, 0.35);
    shot.hall().set(hallTable().sunElevation, 0.5);
    const auto highlight = [&](double azimuth) {
        shot.hall().set(hallTable().sunAzimuth, azimuth);
        shot.hall().set(hallTable().sunStrength, 0.0);
        const Picture dark = shot.take();
        shot.hall().set(hallTable().sunStrength, 9.0);
        const Picture lit = shot.take();
        glm::dvec2 sum(0);
        double weight = 0;
        lit.each([&](int x, int y) {
            const double w = std::max(lit.luminance(x, y) - dark.luminance(x, y), 0.0);
            sum += w * glm::dvec2(x, y);
            weight += w;
        });
        EXPECT_GT(weight, 1);
        return sum / weight;
    };
    // The sun is in the direction (sin, ., -cos) of its azimuth: beyond 90 degrees it is behind the viewer.
    const glm::dvec2 left = highlight(-2.4);
    const glm::dvec2 right = highlight(2.4);
    EXPECT_GT(right.x, left.x + 5);
    shot.hall().set(hallTable().sunElevation, 1.2);
    EXPECT_LT(highlight(2.4).y, right.y - 1);  // A higher sun moves the highlight up.
}

TEST_F(Light, TheEnvironmentsColorAppearsOnTheObject)
{
    test::TemporaryFolder folder;
    Shot shot;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.values().set(sdfTable().baseColor, ColorValue{dvec3(1)});
    for (int channel = 0; channel < 3; ++channel) {
        const std::filesystem::path file = folder / ("only" + std::to_string(channel) + ".hdr");
        dvec3 color(0.05);
        color[channel] = 1;
        test::writePanorama(file, [&](const dvec3&) { return color; });
        shot.hall().set(hallTable().environment, file.string());
        const dvec3 seen = meanOfObject(shot.take());
        for (int other = 0; other < 3; ++other)
            if (other != channel) {
                EXPECT_GT(seen[channel], 5 * seen[other]) << channel;
            }
    }
}

TEST_F(Light, AMirrorShowsTheEnvironmentWhereTheReflectedRayGoes)
{
    // A smooth environment that differs in every direction, and a smooth torus: each pixel shows the direction of its
    // reflected ray. Radiance is linear in the direction, so that blurring hardly changes it.
    test::TemporaryFolder folder;
    const auto room = [](const dvec3& d) { return dvec3(1 + 0.7 * d.x, 1 + 0.7 * d.y, 1 + 0.7 * d.z); };
    test::writePanorama(folder / "room.hdr", room);
    Shot shot;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().environment, (folder / "room.hdr").string());
    shot.hall().set(hallTable().probeSize, 256);
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 0.0);
    o.set(sdfTable().baseColor, ColorValue{dvec3(1)});
    o.set(sdfTable().metalness, 1.0);
    o.set(sdfTable().roughness, 0.0);
    o.set(sdfTable().bounces, 0);
    o.set(sdfTable().ambientOcclusion, false);
    o.set(sdfTable().hitTolerance, 0.05);
    const Picture picture = shot.take();
    const test::Solid solid(o, glm::dmat4(1));
    std::vector<double> errors;
    picture.each([&](int x, int y) {
        const test::Found truth = solid.trace(picture.view, x, y);
        if (!truth.hit || truth.cosine < 0.4) return;
        const dvec3 mirrored = glm::reflect(glm::normalize(test::pixelRay(picture.view, x, y).direction), truth.normal);
        const dvec3 ratio = picture.color(x, y) / room(mirrored);
        errors.push_back(std::max({std::abs(ratio.r - 1), std::abs(ratio.g - 1), std::abs(ratio.b - 1)}));
    });
    ASSERT_GT(errors.size(), 200U);
    std::sort(errors.begin(), errors.end());
    // 3 % are from the fit of the lobe, the rest from texels and half a pixel of the torus.
    EXPECT_LT(errors[errors.size() / 2], 0.05);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.12);
}

TEST_F(Light, InAWhiteRoomNothingIsBrighterThanTheRoom)
{
    test::TemporaryFolder folder;
    test::writePanorama(folder / "white.hdr", [](const dvec3&) { return dvec3(1); });
    Shot shot;
    shot.size(64, 36);
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().environment, (folder / "white.hdr").string());
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 1.0);
    o.set(sdfTable().baseColor, ColorValue{dvec3(1)});
    for (const double metalness : {0.0, 1.0})
        for (const double roughness : {0.0, 0.3, 1.0})
            for (const int bounces : {0, 1, 2, 4}) {
                o.set(sdfTable().metalness, metalness);
                o.set(sdfTable().roughness, roughness);
                o.set(sdfTable().bounces, bounces);
                const Picture picture = shot.take();
                double brightest = 0;
                picture.each([&](int x, int y) { brightest = std::max(brightest, picture.luminance(x, y)); });
                // 2 %: fit of the lobe's albedo, and nine coefficients of a constant.
                EXPECT_LE(brightest, 1.02) << metalness << ' ' << roughness << ' ' << bounces;
                // Polished or white surfaces reflect all light. Rough metal reflects down to 0.44, by the fit of the
                // lobe.
                EXPECT_GE(brightest, roughness == 0 || metalness == 0 ? 0.95 : 0.44)
                    << metalness << ' ' << roughness << ' ' << bounces;
            }
}

TEST_F(Light, AConstantRoomIsMirroredWithoutAcne)
{
    // A mirror torus in a uniform environment, with any number of bounces. A ray that starts on its own surface would
    // hit it again and darken single pixels.
    test::TemporaryFolder folder;
    test::writePanorama(folder / "white.hdr", [](const dvec3&) { return dvec3(1); });
    Shot shot;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().environment, (folder / "white.hdr").string());
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 0.0);
    o.set(sdfTable().baseColor, ColorValue{dvec3(1)});
    o.set(sdfTable().metalness, 1.0);
    o.set(sdfTable().roughness, 0.0);
    o.set(sdfTable().ambientOcclusion, false);
    // Rays start close to the surface, where errors of this kind appear, and are exact.
    o.set(sdfTable().hitTolerance, 0.05);
    o.set(sdfTable().bounces, 0);
    const Picture none = shot.take();
    o.set(sdfTable().bounces, 4);
    const Picture all = shot.take();
    const test::Solid solid(o, glm::dmat4(1));
    int open = 0;
    all.each([&](int x, int y) {
        const test::Found truth = solid.trace(all.view, x, y);
        if (!truth.hit || truth.cosine < 0.1) return;
        const dvec3 mirrored = glm::reflect(glm::normalize(test::pixelRay(all.view, x, y).direction), truth.normal);
        // If the reflected ray truly leaves, bounces must find nothing. It starts two tolerances off the surface; one
        // is 0.8 mm after 2 m.
        const test::Found again = solid.trace({truth.world + 0.0016 * truth.normal, mirrored}, 0, 0, 0.0012);
        if (again.hit || again.closest < 1) return;
        ++open;
        EXPECT_EQ(all.color(x, y), none.color(x, y)) << x << ',' << y;
    });
    EXPECT_GT(open, 300);
}

TEST_F(Light, EachBounceTakesLessThanTheOneBefore)
{
    // In a white environment a gray mirror shows the number of hits of each ray: every hit leaves 60 % of the light.
    test::TemporaryFolder folder;
    test::writePanorama(folder / "white.hdr", [](const dvec3&) { return dvec3(1); });
    Shot shot;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().environment, (folder / "white.hdr").string());
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 1.0);
    o.set(sdfTable().roughness, 0.0);
    o.set(sdfTable().metalness, 1.0);
    o.set(sdfTable().baseColor, ColorValue{dvec3(0.6)});
    o.set(sdfTable().ambientOcclusion, false);
    shot.see({0.5, 0.9, 1.3}, {-0.1, 0, 0});  // View into the cup, which reflects itself.
    std::vector<double> light;
    for (int bounces = 0; bounces <= 4; ++bounces) {
        o.set(sdfTable().bounces, bounces);
        light.push_back(shot.take().mean());
    }
    for (std::size_t i = 1; i < light.size(); ++i) {
        EXPECT_LT(light[i], light[i - 1]) << "bounce " << i;
        if (i >= 2) {
            EXPECT_LT(light[i - 1] - light[i], 0.75 * (light[i - 2] - light[i - 1])) << "bounce " << i;
        }
    }
    EXPECT_GT(light[0] - light[1], 0.005);
}

TEST_F(Light, EachBounceChangesFewerPixels)
{
    Shot shot;
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 1.0);
    o.set(sdfTable().roughness, 0.0);
    shot.see({0.5, 0.9, 1.3}, {-0.1, 0, 0});
    std::vector<Picture> pictures;
    for (int bounces = 0; bounces <= 4; ++bounces) {
        o.set(sdfTable().bounces, bounces);
        pictures.push_back(shot.take());
    }
    int last = 96 * 54;
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        int changed = 0;
        pictures[i].each([&](int x, int y) { changed += pictures[i].color(x, y) != pictures[i - 1].color(x, y); });
        EXPECT_LT(changed, last) << "bounce " << i;
        EXPECT_GT(changed, 0) << "bounce " << i;
        last = changed;
    }
}

TEST_F(Light, ShadowMethodsAgreeWhereTheSunIsASharpPoint)
{
    // With a sun of width 0, all methods test only whether the ray is free.
    Shot shot;
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 1.0);
    o.set(sdfTable().metalness, 0.0);
    o.set(sdfTable().roughness, 1.0);
    o.set(sdfTable().sunWidth, 0.000174533);
    shot.hall().set(hallTable().sunAzimuth, 2.2);
    shot.hall().set(hallTable().sunElevation, 0.6);
    shot.see({0.3, 1.5, 1.0}, {-0.1, 0.1, 0});  // View into the cup, half of which is in shade.
    o.set(sdfTable().shadowMethod, SdfShadow::none);
    const Picture none = shot.take();
    o.set(sdfTable().shadowMethod, SdfShadow::hard);
    const Picture hard = shot.take();
    EXPECT_LT(hard.mean(), 0.98 * none.mean());
    for (const SdfShadow method :
         {SdfShadow::classic, SdfShadow::improved, SdfShadow::signedDistance, SdfShadow::area}) {
        o.set(sdfTable().shadowMethod, method);
        const Picture other = shot.take();
        int different = 0;
        other.each([&](int x, int y) {
            different += std::abs(other.luminance(x, y) - hard.luminance(x, y)) > 0.1 * none.luminance(x, y);
        });
        // Edges of the shadow, where the ray is free by less than the tolerance.
        EXPECT_LT(different, 0.04 * hard.hits()) << static_cast<int>(method);
    }
}

TEST_F(Light, WhatStandsBetweenTheSunAndTheMarchedObjectDarkensIt)
{
    const Museum& museum = gallery().museum;
    const std::size_t card = *museum.find("lenticular");
    Shot shot;
    // From the sun's side. Without the hall, all hits are on the object.
    const dvec3 eye(0.5, 0.35, -1.2);
    shot.see(eye, dvec3(0));
    const Picture outline = shot.take();
    shot.inHall();
    const glm::dmat4 place = shot.worldFromExhibit();
    shot.see(dvec3(place * glm::dvec4(eye, 1)), dvec3(place[3]));
    shot.hall().set(hallTable().shadowMapSize, 2048);
    shot.hall().set(hallTable().reflectionProbe, false);
    letTheSunIn(shot.hall());
    shot.values().set(sdfTable().metalness, 0.0);
    shot.values().set(sdfTable().roughness, 1.0);
    const auto meanInside = [&](const Picture& p) {
        double sum = 0;
        outline.each([&](int x, int y) { sum += outline.hit(x, y) ? p.luminance(x, y) : 0; });
        return sum / outline.hits();
    };
    const dvec3 middle(place[3]);
    shot.request.frame.subject = card;
    const double elevation = shot.hall()[hallTable().sunElevation];
    const double azimuth = shot.hall()[hallTable().sunAzimuth];
    const dvec3 sun(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                    -std::cos(azimuth) * std::cos(elevation));
    // The card, eight times as large, upright between the sun and the object, or as far beside that line.
    const render::Box box = museum.subject(card).bounds(shot.sceneState.values[card]);
    const auto cardAt = [&](const dvec3& at) {
        shot.transform(glm::inverse(museum.worldFromExhibit(card)) * glm::translate(glm::dmat4(1), at) *
                       glm::scale(glm::dmat4(1), dvec3(8)) * glm::translate(glm::dmat4(1), -box.center()));
        return meanInside(shot.take());
    };
    const double free = cardAt(middle + 2.5 * sun + dvec3(3, 0, 0));
    const double shaded = cardAt(middle + 2.5 * sun);
    shot.hall().set(hallTable().sunStrength, 0.0);
    const double sunless = cardAt(middle + 2.5 * sun);
    EXPECT_GT(free, 1.3 * sunless) << "the sun shines on it";
    EXPECT_LT(shaded, sunless + 0.4 * (free - sunless)) << "the card takes most of it away";
}

TEST_F(Light, TowardsASunBehindTheSurfaceNoRayIsSent)
{
    Shot shot;
    shot.request.frame.channels.evaluations = true;
    ParameterValues& o = shot.values();
    o.set(sdfTable().morph, 0.0);
    o.set(sdfTable().bounces, 0);
    const auto evaluations = [&](SdfShadow method) {
        o.set(sdfTable().shadowMethod, method);
        const Picture p = shot.take();
        double sum = 0;
        p.each([&](int x, int y) { sum += p.image.at(x, y, 8); });
        return sum;
    };
    // Without the hall, the initial sun is behind the object, and only the rim is lit. In front of it, most of the
    // object is lit.
    shot.hall().set(hallTable().sunAzimuth, 0.0);
    shot.hall().set(hallTable().sunElevation, 0.05);
    const double behind = evaluations(SdfShadow::hard) - evaluations(SdfShadow::none);
    shot.hall().set(hallTable().sunAzimuth, 3.0);
    const double inFront = evaluations(SdfShadow::hard) - evaluations(SdfShadow::none);
    EXPECT_LT(behind, 0.35 * inFront);
    EXPECT_GT(inFront, 300);
}

}  // namespace
}  // namespace vitrine::sdf_morph
