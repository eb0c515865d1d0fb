// Pictures of the exhibit compared with the evaluator of the same file, and with closed forms.

#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/exhibits/sdf_scenes/scene_shot.h"
#include "tests/support/made_image.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

namespace vitrine {
namespace {

using glm::dvec3;
using scenes::SceneEvaluation;
using scenes::SceneLook;
using scenes::SceneOcclusion;
using namespace test;

class ScenePicture : public test::GlTest {
protected:
    test::TemporaryFolder folder_;
};

/// Returns the distance at which a ray hits the field, at float64; infinity if it does not within `far`.
double firstHit(const scenes::SceneField& field, const dvec3& origin, const dvec3& d, double start, double far)
{
    double t = start;
    for (int step = 0; step < 20'000 && t < far; ++step) {
        const double f = field.distance(origin + t * d);
        if (f < 1e-6) return t;
        t += f;
    }
    return std::numeric_limits<double>::infinity();
}

using LongScenePicture = ScenePicture;

TEST_F(LongScenePicture, ShowsSurfacesWhereTheEvaluatorFindsThem)
{
    for (const char* name : {"primitives", "unions", "torus", "mercury", "still_life"}) {
        SceneShot shot(shippedScene(name));
        shot.values().set(scenesTable().hitTolerance, 0.05);
        shot.values().set(scenesTable().stepLimit, 512);
        const test::Picture p = shot.take();
        const scenes::SceneField field = shot.field();
        const glm::dmat4 scene = shot.sceneFromWorld();
        const dvec3 origin(scene * glm::dvec4(p.view.eye, 1));
        int solid = 0, wrong = 0, turned = 0;
        for (int y = 1; y < p.height(); y += 3)
            for (int x = 1; x < p.width(); x += 3) {
                const dvec3 ray(scene * glm::dvec4(p.ray(x, y), 0));
                const double perDepth = glm::length(ray);
                const double truth = firstHit(field, origin, ray / perDepth, 0, 40);
                const dvec3 aside(scene * glm::dvec4(p.ray(x + 1, y + 1), 0));
                const double beside = firstHit(field, origin, glm::normalize(aside), 0, 40);
                // For objects as small as a pixel, the pixel's width decides.
                if (!std::isfinite(truth) || std::abs(beside / truth - 1) > 0.05) continue;
                const dvec3 point = origin + ray / perDepth * truth;
                dvec3 slope;
                for (int axis = 0; axis < 3; ++axis) {
                    dvec3 h(0);
                    h[axis] = 1e-4;
                    slope[axis] = (field.distance(point + h) - field.distance(point - h)) / 2e-4;
                }
                // At outlines and creases, half a pixel decides.
                if (std::abs(glm::dot(glm::normalize(slope), ray / perDepth)) < 0.2) continue;
                ++solid;
                const bool apart = std::abs(p.depth(x, y) * perDepth / truth - 1) > 5e-3;
                wrong += apart;
                turned += !apart &&
                          glm::dot(p.normal(x, y), glm::normalize(glm::transpose(glm::dmat3(scene)) * slope)) < 0.98;
            }
        EXPECT_GT(solid, 60) << name;
        EXPECT_LE(wrong, solid / 100) << name << ": of " << solid;
        EXPECT_LE(turned, solid / 20) << name << ": of " << solid;
    }
}

/// Returns a shot of a ball of radius 1 at the origin with other shapes, in the reference's lighting, seen from z = 4;
/// 48 x 48 pixels.
SceneShot sourceShot(const test::TemporaryFolder& folder, const std::string& others, const std::string& lights,
                     const std::string& look)
{
    const std::string head = R"("camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fieldOfView": 60},
 "environment": {"kind": "sky", "zenith": [0.2, 0.3, 0.4], "horizon": [0.2, 0.3, 0.4], "ground": [0.2, 0.3, 0.4]},
 "materials": {"ball": {"model": "phong", "color": [0.8, 0.4, 0.2], "ambient": 0.2, "diffuse": 0.5, "specular": 0.3, "shininess": 8, "mirror": 0.25}},
 "lights": [)" + lights + "], \"look\": {\"asInTheReference\": true, \"bounces\": 1" +
                             look + "},";
    SceneShot shot(test::writeScene(
        folder, R"({"kind": "union", "children": [{"kind": "sphere", "radius": 1, "material": "ball"})" + others + "]}",
        head));
    shot.request.frame.raster.size = {48, 48};
    shot.request.frame.averageIn = AverageIn::display;
    return shot;
}

/// Returns the displayed number.
dvec3 shownAt(const test::Picture& p, int x, int y)
{
    const dvec3 c = p.color(x, y);
    dvec3 number;
    for (int i = 0; i < 3; ++i) number[i] = c[i] <= 0.0031308 ? 12.92 * c[i] : 1.055 * std::pow(c[i], 1 / 2.4) - 0.055;
    return number;
}

TEST_F(ScenePicture, AsInTheReferenceIsPhongWithAMirrorShownAsNumbers)
{
    SceneShot shot = sourceShot(folder_, "", R"({"kind": "point", "position": [2, 3, 4], "color": [0.9, 1, 0.8]})",
                                R"(, "ambient": [0.5, 0.6, 0.7])");
    shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
    shot.values().set(scenesTable().hitTolerance, 0.01);
    const test::Picture p = shot.take();
    const glm::dmat4 scene = shot.sceneFromWorld();
    const dvec3 eye(scene * glm::dvec4(p.view.eye, 1));
    int compared = 0;
    double worst = 0;
    p.each([&](int x, int y) {
        const dvec3 d = glm::normalize(dvec3(scene * glm::dvec4(p.ray(x, y), 0)));
        const double middle = -glm::dot(eye, d);
        const double inside = 1 - glm::dot(eye, eye) + middle * middle;
        if (inside < 0.15) return;
        const dvec3 n = eye + d * (middle - std::sqrt(inside));
        const dvec3 toLight = glm::normalize(dvec3(2, 3, 4) - n);
        const double cosine = glm::dot(n, toLight);
        if (cosine < 0.05) return;
        const double gleam = std::pow(std::max(glm::dot(glm::reflect(-toLight, n), -d), 0.0), 8.0);
        const dvec3 color(0.8, 0.4, 0.2);
        const dvec3 lit = dvec3(0.9, 1, 0.8) * (color * (0.5 * cosine) + 0.3 * gleam) +
                          (0.8 + 1.0) * dvec3(0.5, 0.6, 0.7) * color * 0.2;
        const dvec3 expected = glm::min(0.75 * lit + 0.25 * dvec3(0.2, 0.3, 0.4), 1.0);
        ++compared;
        const dvec3 off = glm::abs(shownAt(p, x, y) - expected);
        worst = std::max({worst, off.x, off.y, off.z});
    });
    EXPECT_GT(compared, 200);
    EXPECT_LT(worst, 0.012);
}

TEST_F(ScenePicture, BouncesAreCounted)
{
    // The eye between two boards that reflect each other: each bounce adds up to half of the one before.
    SceneShot shot(test::writeScene(folder_, R"({"kind": "union", "material": "mirror", "children": [
      {"kind": "sphere", "radius": 1}, {"kind": "box", "size": [90, 90, 0.1], "translate": [0, 0, 5]},
      {"kind": "box", "size": [90, 90, 0.1], "translate": [0, 0, -5]}]})",
                                    R"("camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fieldOfView": 60},
 "materials": {"mirror": {"model": "phong", "color": [0.8, 0.4, 0.2], "diffuse": 0.5, "mirror": 0.5}},
 "lights": [{"kind": "point", "position": [2, 3, 4], "color": [0.9, 1, 0.8]}],
 "look": {"asInTheReference": true, "bounces": 4},)"));
    std::vector<test::Picture> pictures;
    for (int bounces = 0; bounces <= 4; ++bounces) {
        shot.values().set(scenesTable().bounces, bounces);
        pictures.push_back(shot.take());
    }
    for (std::size_t i = 1; i < pictures.size(); ++i)
        EXPECT_GT(test::largestDifference(pictures[i].image, pictures[i - 1].image), 1e-3) << i;
}

TEST_F(ScenePicture, WhatIsBehindTheLightKeepsNothingAway)
{
    const std::string light = R"({"kind": "point", "position": [0, 0, 3], "color": [1, 1, 1]})";
    const auto middle = [&](const char* others, const char* look) {
        SceneShot shot = sourceShot(folder_, others, light, look);
        shot.values().set(scenesTable().bounces, 0);
        shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
        return shownAt(shot.take(), 19, 24).x;
    };
    // A board behind the light, beside the eye, and one in front of it.
    const char* behind = R"(, {"kind": "box", "size": [20, 20, 0.1], "translate": [0, 0, 9]})";
    const char* before = R"(, {"kind": "box", "size": [0.4, 0.4, 0.02], "translate": [0, 0, 2.2]})";
    for (const char* look : {"", R"(, "softShadows": 20)"}) {
        const double lit = middle("", look);
        EXPECT_GT(lit, 0.3);
        EXPECT_NEAR(middle(behind, look), lit, 0.01) << look;
        SceneShot shaded = sourceShot(folder_, before, light, look);
        SceneShot open = sourceShot(folder_, "", light, look);
        shaded.size(96, 96);
        open.size(96, 96);
        // The board hides the center of the ball from the eye, and more of it from the light.
        const test::Picture with = shaded.take(), without = open.take();
        double darker = 0;
        with.each([&](int x, int y) { darker = std::max(darker, without.luminance(x, y) - with.luminance(x, y)); });
        EXPECT_GT(darker, 0.03) << "control: before the light it does";
    }
}

TEST_F(LongScenePicture, OcclusionOfAWallIsAHalfAtItsFoot)
{
    // A floor in front of an infinite wall, in white light from everywhere.
    const std::string head = R"("camera": {"position": [0, 2, 2], "target": [0, 0, 0], "fieldOfView": 40},
 "environment": {"kind": "sky", "zenith": [1, 1, 1], "horizon": [1, 1, 1], "ground": [1, 1, 1]},
 "materials": {"chalk": {"model": "pbr", "color": [0.5, 0.5, 0.5], "roughness": 1, "reflectance": 0}},)";
    SceneShot shot(test::writeScene(folder_, R"({"kind": "union", "material": "chalk", "children": [
      {"kind": "plane", "normal": [0, 1, 0]}, {"kind": "box", "size": [2000, 2000, 1], "translate": [0, 0, -0.5]}]})",
                                    head));
    shot.values().set(scenesTable().occlusionRange, 1000.0);
    shot.values().set(scenesTable().occlusionRays, 128);
    shot.request.frame.raster.size = {33, 33};
    const auto openness = [&](SceneOcclusion method, int row) {
        shot.values().set(scenesTable().occlusionMethod, method);
        double sum = 0;
        for (const int x : {4, 10, 16, 22, 28}) sum += shot.take().color(x, row).x / 5;
        return sum;
    };
    const double all = openness(SceneOcclusion::none, 17);
    // Row 17 is just in front of the wall's foot. The wall hides half of the weighted light there.
    const double rays = openness(SceneOcclusion::hemisphere, 17) / all;
    EXPECT_GT(rays, 0.44);
    EXPECT_LT(rays, 0.58);
    EXPECT_GT(openness(SceneOcclusion::hemisphere, 32) / all, rays) << "farther from it, more is open";
    const double range = 0.5;
    shot.values().set(scenesTable().occlusionRange, range);
    // The floor's point in row 17 is nearer to the wall than to the taps above that height.
    const test::Picture p = shot.take();
    const glm::dmat4 scene = shot.sceneFromWorld();
    const dvec3 eye(scene * glm::dvec4(p.view.eye, 1)), ray(scene * glm::dvec4(p.ray(16, 17), 0));
    const double before = eye.z - ray.z * eye.y / ray.y;
    double blocked = 0, weights = 0;
    for (int k = 1; k <= 5; ++k) {
        const double height = range * glm::length(dvec3(scene[0])) * k * k / 25;
        blocked += (1 - std::min(height, before) / height) / k;
        weights += 1.0 / k;
    }
    // Its sample is anywhere in the pixel, between whose upper and lower edges the value changes by a tenth.
    EXPECT_NEAR(openness(SceneOcclusion::taps, 17) / all, 1 - blocked / weights, 0.03);
    EXPECT_NEAR(openness(SceneOcclusion::cones, 17) / all, openness(SceneOcclusion::hemisphere, 17) / all, 0.15);
    shot.values().set(scenesTable().occlusionRange, 0.01);
    EXPECT_GT(openness(SceneOcclusion::hemisphere, 32) / all, 0.97) << "E13: what is farther away than the range";
}

/// Returns the share of cosine-weighted rays that a wall of any size blocks, at a point of the floor at this distance.
/// A hit at distance t blocks 1 - t^2 / range^2.
double hiddenByWall(double distance, double range)
{
    const double c = std::min(distance / range, 1.0);
    return ((1 + 2 * c * c) * std::acos(c) - 3 * c * std::sqrt(1 - c * c)) / std::numbers::pi;
}

/// Returns the share of 32 rays, spread as those of the shader, that the wall blocks.
double hiddenFromRays(double distance, double range)
{
    constexpr int rays = 32;
    double hidden = 0;
    for (int k = 0; k < rays; ++k) {
        const double towards = std::sqrt((k + 0.5) / rays) * std::cos(2 * std::numbers::pi * k * 0.618033989);
        const double t = distance / towards;
        if (towards > 0 && t < range) hidden += (1 - t * t / (range * range)) / rays;
    }
    return hidden;
}

/// Error of the occlusion in rows of a floor that are parallel to a wall, so that it is the same all along a row.
struct RowErrors {
    double bands = 0;      ///< Mean square of the error of a row's mean.
    double equalRays = 0;  ///< The same if all pixels had the same 32 rays, as in the reference.
    double largest = 0;    ///< Largest error of a row's mean.
    double darkest = 0;    ///< Largest share that the wall hides in a row.
    int rows = 0;
};

RowErrors rowErrors(const test::Picture& open, const test::Picture& hidden, const glm::dmat4& sceneFromWorld,
                    double range)
{
    RowErrors errors;
    const dvec3 eye(sceneFromWorld * glm::dvec4(open.view.eye, 1));
    for (int y = open.height() / 3; y < open.height(); ++y) {
        const dvec3 at = eye + dvec3(sceneFromWorld * glm::dvec4(open.ray(open.width() / 2, y), 0)) *
                                   open.depth(open.width() / 2, y);
        if (std::abs(at.y) > 0.01 || at.z < 0.05) continue;
        double mean = 0;
        for (int x = 0; x < open.width(); ++x) mean += (1 - hidden.color(x, y).x / open.color(x, y).x) / open.width();
        const double truth = hiddenByWall(at.z, range);
        errors.bands += (mean - truth) * (mean - truth);
        errors.equalRays += std::pow(hiddenFromRays(at.z, range) - truth, 2);
        errors.largest = std::max(errors.largest, std::abs(mean - truth));
        errors.darkest = std::max(errors.darkest, mean);
        ++errors.rows;
    }
    errors.bands /= errors.rows;
    errors.equalRays /= errors.rows;
    return errors;
}

TEST_F(ScenePicture, OcclusionHasNoBandsAndReachesAsFarAsItsRange)
{
    const std::string head = R"("camera": {"position": [0, 1.5, 2.4], "target": [0, 0, 0.5], "fieldOfView": 40},
 "environment": {"kind": "sky", "zenith": [1, 1, 1], "horizon": [1, 1, 1], "ground": [1, 1, 1]},
 "materials": {"chalk": {"model": "pbr", "color": [0.5, 0.5, 0.5], "roughness": 1, "reflectance": 0}},)";
    SceneShot shot(test::writeScene(folder_, R"({"kind": "union", "material": "chalk", "children": [
      {"kind": "plane", "normal": [0, 1, 0]}, {"kind": "box", "size": [2000, 2000, 1], "translate": [0, 0, -0.5]}]})",
                                    head));
    shot.size(96, 64);
    shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
    const test::Picture open = shot.take();
    shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::hemisphere);
    double darkest = 0;
    for (const double range : {0.4, 1.0, 3.0}) {
        shot.values().set(scenesTable().occlusionRange, range);
        const RowErrors errors = rowErrors(open, shot.take(), shot.sceneFromWorld(), range);
        ASSERT_GE(errors.rows, 20);
        EXPECT_LT(errors.bands, errors.equalRays / 4) << range << ", control: the same rays in all pixels";
        EXPECT_LT(errors.largest, 0.01) << range;
        EXPECT_GT(errors.darkest, darkest) << "a longer range darkens more";
        darkest = errors.darkest;
    }
}

TEST_F(ScenePicture, SixFacesSurroundTheSceneWhereTheirNamesSay)
{
    const dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    const char* const names[] = {"right", "left", "top", "bottom", "front", "back"};
    const dvec3 towards[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0.01}, {0, -1, 0.01}, {0, 0, -1}, {0, 0, 1}};
    std::string faces;
    for (int i = 0; i < 6; ++i) {
        const std::string file = std::string(names[i]) + ".png";
        writePicture(folder_ / file, test::made(16, 16, [&](int, int, int c) { return float(colors[i][c]); }),
                     render::PictureFormat::png8);
        faces += std::string(", \"") + names[i] + "\": \"" + file + '"';
    }
    for (int i = 0; i < 6; ++i) {
        const dvec3 t = towards[i];
        const std::string head = "\"camera\": {\"position\": [0, 0, 0], \"target\": [" + std::to_string(t.x) + ", " +
                                 std::to_string(t.y) + ", " + std::to_string(t.z) +
                                 "]},\n\"environment\": {\"kind\": \"faces\"" + faces + "},";
        SceneShot shot(test::writeScene(folder_, R"({"kind": "sphere", "radius": 0.1, "translate": [9, 9, 9]})", head,
                                        std::string(names[i]) + ".json"));
        const dvec3 seen = shot.take().color(48, 32);
        const double most = std::max({seen.x, seen.y, seen.z});
        EXPECT_LT(glm::distance(seen / most, colors[i]), 0.02) << names[i];
    }
}

TEST_F(ScenePicture, AFaceThatChangedIsSeenWhenTheSceneIsReadAgain)
{
    const auto write = [&](const std::string& name, double red) {
        writePicture(folder_ / (name + ".png"),
                     test::made(4, 4, [&](int, int, int c) { return c == 0 ? float(red) : 0; }),
                     render::PictureFormat::png8);
    };
    std::string faces;
    for (const char* name : {"right", "left", "top", "bottom", "front", "back"}) {
        write(name, 0);
        faces += std::string(", \"") + name + "\": \"" + name + ".png\"";
    }
    SceneShot shot(test::writeScene(folder_, R"({"kind": "sphere", "radius": 0.1, "translate": [9, 9, 9]})",
                                    "\"environment\": {\"kind\": \"faces\"" + faces + "},\n" +
                                        R"("camera": {"position": [0, 0, 0], "target": [0, 0, -1]},)"));
    const double before = shot.take().color(48, 32).x;
    write("front", 1);  // Not the file whose path is the key of the picture in the store.
    shot.read();
    EXPECT_GT(shot.take().color(48, 32).x, before + 0.1);
}

/// Returns the pass of an idle scene state.
render::Pass restingPass(SceneShot& shot, bool rests = true)
{
    FrameRequest frame = shot.request.frame;
    frame.idle = rests;
    return *test::planned(test::gallery().museum, shot.sceneState, frame).find("sdf_scenes/scene");
}

TEST_F(ScenePicture, FoldedNumbersDrawTheSamePictureFromTheSameInputs)
{
    for (const char* name : {"torus", "intersections", "primitives"}) {
        SceneShot shot(shippedScene(name));
        FrameRequest frame = shot.request.frame;
        frame.idle = true;
        const auto image = [&](bool folded) {
            render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, frame,
                                                   test::gallery().renderer.persistentState());
            plan.allSlices = true;
            auto& shader = const_cast<render::Pass*>(plan.find("sdf_scenes/scene"))->shader;
            EXPECT_TRUE(shader.specialized) << name;
            if (folded) {
                EXPECT_NE(shader.sources->hash(), shader.specialized->sources->hash());
                shader = render::ShaderKey(*shader.specialized);
            }
            test::gallery().renderer.draw(plan);
            return test::gallery().renderer.read(radianceImage);
        };
        const render::Image whole = image(false), folded = image(true);
        int apart = 0;
        double sum = 0;
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            sum += double(whole.pixels[i]);
            // At outlines, rounding decides.
            apart += std::abs(whole.pixels[i] - folded.pixels[i]) > 2e-3F * (1 + std::abs(whole.pixels[i]));
        }
        EXPECT_GT(sum, 100) << name;
        EXPECT_LE(apart, static_cast<int>(whole.pixels.size() / 200)) << name;
    }
}

TEST_F(ScenePicture, NumbersAreFoldedWhenTheyRestAndThoseThatMoveNever)
{
    SceneShot shot(test::writeScene(folder_, R"--({"kind": "union", "children": [{"kind": "sphere", "radius": "size"},
        {"kind": "box", "size": [0.3, 0.4, 0.512345], "translate": ["sin(t)", 0, 0]}]})--",
                                    R"("parameters": {"size": {"value": 0.5, "unit": "m", "range": [0.1, 1]}},)"));
    const auto text = [&] { return restingPass(shot).shader.specialized->sources->textByPath().begin()->second; };
    EXPECT_FALSE(restingPass(shot, false).shader.specialized);
    EXPECT_EQ(text().find("sceneValues["), text().rfind("sceneValues[")) << "declared, and never read";
    EXPECT_NE(text().find("0.512345"), std::string::npos);
    EXPECT_EQ(restingPass(shot).blocks, restingPass(shot, false).blocks);
    const std::string still = text();
    shot.set("size", 0.7);
    EXPECT_NE(text(), still) << "other numbers, another text";
    EXPECT_EQ(restingPass(shot).shader, restingPass(shot, false).shader) << "beside the same program";

    shot.values().set(scenesTable().animate, true);
    shot.request.frame.time = 1;
    const std::string moving = text();
    EXPECT_NE(moving.find("sceneValues["), moving.rfind("sceneValues[")) << "what moves is read from the block";
    EXPECT_NE(moving.find("0.512345"), std::string::npos) << "and what does not is folded";
    shot.request.frame.time = 2;
    EXPECT_EQ(text(), moving) << "the same text at every moment";

    shot.values().set(scenesTable().evaluation, SceneEvaluation::shapes);
    EXPECT_FALSE(restingPass(shot).shader.specialized) << "it was asked for with its numbers beside it";
}

TEST_F(ScenePicture, ADragAfterFoldingCompilesNothing)
{
    SceneShot shot(test::writeScene(folder_, R"({"kind": "sphere", "radius": "size"})",
                                    R"("parameters": {"size": {"value": 0.5, "unit": "m", "range": [0.1, 1]}},)"));
    render::gl::Renderer renderer;
    renderer.buildInBackground(test::gallery().context.shared());
    const auto frame = [&](bool rests) {
        FrameRequest request = shot.request.frame;
        request.idle = rests;
        return renderer.draw(
            test::planned(test::gallery().museum, shot.sceneState, request, renderer.persistentState()));
    };
    const auto isFolded = [](const render::FrameReport& report) {
        for (const render::StepReport& step : report.ran)
            if (step.name == "sdf_scenes/scene") return step.reason.find("numbers compiled in") != std::string::npos;
        return false;
    };
    EXPECT_FALSE(isFolded(frame(true))) << "the picture does not wait for it";
    bool folded = false;
    for (int i = 0; i < 400 && !folded; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        folded = isFolded(frame(true));
    }
    ASSERT_TRUE(folded);
    const auto programs = frame(true).counters.at("programs");
    for (int i = 0; i < 5; ++i) {
        shot.set("size", 0.5 + 0.05 * i);
        const render::FrameReport report = frame(false);
        EXPECT_FALSE(isFolded(report));
        EXPECT_FALSE(report.unfinished) << "no program is being built";
        EXPECT_EQ(report.counters.at("programs"), programs);
    }
    (void)frame(true);
    EXPECT_GT(frame(true).counters.at("programs"), programs) << "control: at rest, one more is";
}

TEST_F(ScenePicture, ASliderOfTheSceneMovesWhatItNamesWithoutAnotherProgram)
{
    SceneShot shot(test::writeScene(folder_, R"({"kind": "sphere", "radius": "size"})",
                                    R"("parameters": {"size": {"value": 0.5, "unit": "m", "range": [0.1, 1]}},
"camera": {"position": [0, 0, 5], "target": [0, 0, 0], "fieldOfView": 40},)"));
    const auto pixels = [&] {
        const test::Picture p = shot.take();
        int solid = 0;
        p.each([&](int x, int y) { solid += p.normal(x, y).z > 0 && p.depth(x, y) < 1000; });
        return solid;
    };
    const auto shader = [&] {
        const render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, shot.request.frame);
        return plan.find("sdf_scenes/scene")->shader;
    };
    const int before = pixels();
    const render::ShaderKey key = shader();
    shot.set("size", 1.0);
    EXPECT_EQ(shader(), key);
    // Seen from 5 radii, a ball's outline is 1 / sqrt(24) wide; from 10 radii, 1 / sqrt(99).
    EXPECT_NEAR(static_cast<double>(pixels()) / before, 99.0 / 24, 0.5);
    shot.values().set(scenesTable().look, SceneLook::reference);
    EXPECT_FALSE(shader() == key) << "control: another look does compile";
    EXPECT_EQ(shader().programFamily, key.programFamily) << "and the picture does not wait for it";
}

TEST_F(LongScenePicture, IsSeenThroughItsFrameOnly)
{
    SceneShot shot(shippedScene("torus"));
    shot.inHall();
    shot.request.frame.raster.size = {160, 100};
    const glm::dmat4 world = test::gallery().museum.worldFromExhibit(shot.exhibit);
    const dvec3 eye(0.9, 0.1, 1.6);
    shot.request.frame.camera = {dvec3(world * glm::dvec4(eye, 1)), dvec3(world * glm::dvec4(0, 0, 0, 1)), 1.1};
    const test::Picture one = shot.take();
    shot.values().set(scenesTable().brightness, 8.0);
    shot.values().set(scenesTable().look, SceneLook::physical);
    const test::Picture other = shot.take();
    int through = 0, leaked = 0;
    one.each([&](int x, int y) {
        const dvec3 d(glm::inverse(world) * glm::dvec4(one.ray(x, y), 0));
        const dvec3 at = eye + d * ((-0.495 - eye.z) / d.z);
        const bool beside = d.z >= 0 || std::abs(at.x) > 1.22 || std::abs(at.y) > 0.82;
        const bool changed = glm::distance(one.color(x, y), other.color(x, y)) > 1e-3;
        through += !beside && changed;
        leaked += beside && changed;
    });
    EXPECT_GT(through, 500);
    EXPECT_EQ(leaked, 0);
}

}  // namespace
}  // namespace vitrine
