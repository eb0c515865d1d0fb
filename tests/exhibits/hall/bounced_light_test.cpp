// Bounced sunlight compared with a path tracer; its conditions and its continuity.
#include "tests/exhibits/hall/bounced_light.h"

#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/hall/sun.h"
#include "render/files/strict_json.h"
#include "shaders/lib/bindings.glsl"
#include "tests/support/block_of.h"
#include "tests/support/degree.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vitrine::hall {
namespace {

using namespace test;
constexpr const char* bouncePasses[] = {"hall/bounced light in the air", "hall/bounced light",
                                        "hall/bounced light/edges"};

const SunTransfer& transfer()
{
    return test::building().surfaces().lightmaps().sun;
}

Air airAt(double azimuth, double elevation)
{
    return test::airOf(transfer(), transfer().at(azimuth * degree, elevation * degree));
}

double sumOf(const Air& air)
{
    double sum = 0;
    for (const double light : air) sum += light;
    return sum;
}

/// Returns eight squares of the hall under twelve suns, path traced by assets/models/hall_reference.py.
const render::Json& reference()
{
    static const render::Json read =
        render::readJson(VITRINE_SOURCE_DIR "/tests/exhibits/hall/bounced_light_reference.json").root();
    return read;
}

glm::dvec3 vectorOf(const render::Json& c)
{
    return {c[0].get<double>(), c[1].get<double>(), c[2].get<double>()};
}

double gray(const glm::dvec3& color)
{
    return (color.r + color.g + color.b) / 3;
}

/// Returns the mean of a surface's light over a square of the reference, and over the color channels.
double lightOn(const render::Json& region, const Air& air)
{
    double sum = 0;
    const std::size_t count = region.at("atlas").size();
    for (std::size_t i = 0; i < count; ++i) {
        const render::Json& at = region.at("atlas")[i];
        const glm::dvec3 share = test::surfaceShare(transfer(), {at[0].get<double>(), at[1].get<double>()});
        sum +=
            gray(share) * test::airOn(transfer(), air, vectorOf(region.at("places")[i]), vectorOf(region.at("normal")));
    }
    return sum / static_cast<double>(count);
}

/// Returns the relative error of the light of `airOf(azimuth, elevation)` for each square and sun. If a square gets
/// less than its mean over the twelve suns, the error is relative to that mean.
template <typename AirOf> std::vector<double> errors(const AirOf& airOf)
{
    const render::Json& suns = reference().at("suns");
    const render::Json& regions = reference().at("regions");
    std::vector<double> wrong;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        double mean = 0;
        for (const render::Json& sun : suns)
            mean += gray(vectorOf(sun.at("light")[r])) / static_cast<double>(suns.size());
        for (const render::Json& sun : suns) {
            const double right = gray(vectorOf(sun.at("light")[r]));
            const Air air = airOf(sun.at("azimuth").get<double>(), sun.at("elevation").get<double>());
            wrong.push_back(std::abs(lightOn(regions[r], air) - right) / std::max(right, mean));
        }
    }
    return wrong;
}

TEST(LongBouncedLight, IsWithinATenthOfAPathTracer)
{
    const std::vector<double> wrong = errors(airAt);
    ASSERT_EQ(wrong.size(), 96U);
    for (std::size_t i = 0; i < wrong.size(); ++i)
        EXPECT_LT(wrong[i], 0.1) << reference().at("regions")[i / 12].at("name") << ", sun " << i % 12;
    // Control: light that depends on the sun's height only, as from lightmaps of three suns, differs.
    const std::vector<double> byHeight = errors([](double, double elevation) {
        return airAt(elevation < 16 ? 14 : elevation < 27 ? 10 : -6, elevation);
    });
    EXPECT_GT(std::count_if(byHeight.begin(), byHeight.end(), [](double e) { return e > 0.1; }), 32);
}

/// Returns the mean of the sky's lightmap, for a sky of radiance 1, over a square of the reference.
double skyOn(const render::Json& region)
{
    const render::Texture& map = *test::building().surfaces().lightmaps().sky;
    const auto channels = static_cast<std::size_t>(map.channels);
    double sum = 0;
    for (const render::Json& at : region.at("atlas")) {
        const auto x = static_cast<std::size_t>(at[0].get<double>() * map.width);
        const auto y = static_cast<std::size_t>(at[1].get<double>() * map.height);
        for (std::size_t c = 0; c < 3; ++c) {
            const double code = map.bytes[(y * static_cast<std::size_t>(map.width) + x) * channels + c] / 255.0;
            sum += code * code * test::building().surfaces().skyScale() / 3;
        }
    }
    return sum / static_cast<double>(region.at("atlas").size());
}

TEST(BouncedLight, IsOnWhatHasNoLightmapAsOnTheWallBesideIt)
{
    constexpr double sky = 2.3;
    constexpr double sun = 3.6;
    const Air air = airAt(-3, 19);
    const Air skyAir = test::skyInAir(transfer());
    int farFromTheMiddle = 0;
    for (std::size_t r = 0; r < 6; ++r) {
        const render::Json& region = reference().at("regions")[r];
        const glm::dvec3 normal = vectorOf(region.at("normal"));
        const auto lightAt = [&](const glm::dvec3& place) {
            return sky * test::airOn(transfer(), skyAir, place, normal) +
                   sun * test::airOn(transfer(), air, place, normal);
        };
        const double wall = sky * skyOn(region) + sun * lightOn(region, air);
        const double beside = lightAt(vectorOf(region.at("places")[5]));
        EXPECT_NEAR(beside, wall, 0.25 * wall) << region.at("name");
        // Control: the light in the middle of the hall, which was once used everywhere.
        farFromTheMiddle += std::abs(lightAt(test::building().probe()) - wall) > 0.25 * wall;
    }
    EXPECT_GE(farFromTheMiddle, 3);

    test::Scene scene;
    scene.see({2.5, 1.65, 4}, {-4, 1, 4});
    const auto readsAir = [&](const char* pass) {
        const render::FramePlan plan = scene.plan();
        const render::Pass* found = plan.find(pass);
        if (!found) return false;
        const std::vector<std::string> inputs = inputsOf(*found);
        return std::find(inputs.begin(), inputs.end(), "light.air") != inputs.end();
    };
    EXPECT_TRUE(readsAir("hall/props"));
    EXPECT_EQ(reasonFor(scene.plan(), "hall/light in the air"), "it ran");
    scene.hall().set(test::hallTable().bakedLight, false);
    EXPECT_FALSE(readsAir("hall/props"));
    // While the probe is being captured, there is no probe to read.
    EXPECT_TRUE(readsAir("probe/things/0"));
    const render::FramePlan plan = scene.plan();
    for (const char* capture : {"probe/sky/0", "probe/walls/0", "probe/things/0"}) {
        const std::map<int, render::Bytes>& blocks = plan.find(capture)->blocks;
        EXPECT_FALSE(test::blockOf<LightBlock>(blocks.at(BLOCK_LIGHT)).hasProbe) << capture;
    }
    scene.hall().set(test::hallTable().reflectionProbe, false);
    EXPECT_EQ(reasonFor(scene.plan(), "hall/light in the air"), "baked light is switched off");
}

TEST(BouncedLight, IsNoneWhileTheSunShinesInNowhere)
{
    EXPECT_TRUE(transfer().at(170 * degree, 12 * degree).empty());
    EXPECT_FALSE(transfer().at(-3 * degree, 19 * degree).empty());

    test::Scene scene;
    for (const char* pass : bouncePasses) EXPECT_EQ(reasonFor(scene.plan(), pass), "it ran") << pass;
    scene.hall().set(test::hallTable().sunAzimuth, 170 * degree);
    scene.hall().set(test::hallTable().sunElevation, 12 * degree);
    EXPECT_EQ(reasonFor(scene.plan(), "hall/bounced light"), "too little sunlight comes in through window and oculus");
    scene.hall().set(test::hallTable().sunAzimuth, 0.0);
    scene.hall().set(test::hallTable().sunStrength, 0.0);
    EXPECT_EQ(reasonFor(scene.plan(), "hall/bounced light"), "the sun's strength is 0");
    // Its readers must know that it is missing.
    const render::FramePlan plan = scene.plan();
    for (const render::Pass& pass : plan.passes())
        for (const std::string& image : inputsOf(pass)) EXPECT_NE(image, "light.bounced") << pass.name;
}

TEST(BouncedLight, IsKeptWhileTheSunRests)
{
    test::Scene scene;
    const render::PersistentState kept = test::keptAfter(scene.plan());
    scene.see({0, 1.65, 5}, {0, 2, -12});
    scene.hall().set(test::hallTable().exposure, 1.0);
    scene.hall().set(test::hallTable().sunTemperature, 3000.0);  // The color is applied to the cached result.
    for (const char* pass : bouncePasses)
        EXPECT_EQ(reasonFor(scene.plan(kept), pass), "unchanged since it last ran") << pass;
    scene.hall().set(test::hallTable().sunAzimuth, 2 * degree);
    for (const char* pass : bouncePasses) EXPECT_EQ(reasonFor(scene.plan(kept), pass), "it ran") << pass;
}

TEST(LongBouncedLight, MovesWithoutJumps)
{
    const double usual = sumOf(airAt(-3, 19));
    const auto expectSmooth = [&](double azimuth, double elevation, double overAzimuth, double overElevation) {
        const Air before = airAt(azimuth, elevation);
        const Air after = airAt(azimuth + overAzimuth, elevation + overElevation);
        double step = 0;
        for (std::size_t i = 0; i < before.size(); ++i) step += std::abs(after[i] - before[i]);
        EXPECT_LT(step, 0.01 * usual) << azimuth << ' ' << elevation;
    };
    // Steps of a hundredth of a degree, at nodes of the grid, beside them, and all around.
    for (double azimuth = -200; azimuth <= 200; azimuth += 5) expectSmooth(azimuth - 0.005, 19, 0.01, 0);
    for (double elevation = -3; elevation <= 93; elevation += 2) expectSmooth(-3, elevation - 0.005, 0, 0.01);
    EXPECT_EQ(airAt(-3, 95), airAt(-3, 90));
    EXPECT_EQ(airAt(-3, -5), airAt(-3, 0));
}

/// Returns the light of a mirrored hall: point by point, with the sides toward -x and +x exchanged.
Air mirrored(const Air& air)
{
    const auto columns = static_cast<std::size_t>(transfer().grid().size.x);
    Air other = air;
    for (std::size_t i = 0; i < air.size() / 6; ++i) {
        const std::size_t from = i - i % columns + (columns - 1 - i % columns);
        for (std::size_t side = 0; side < 6; ++side) other[6 * i + side] = air[6 * from + (side < 2 ? 1 - side : side)];
    }
    return other;
}

TEST(BouncedLight, MirrorsTheSun)
{
    const auto difference = [](const Air& a, const Air& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
        return sum / sumOf(a);
    };
    // Except for its furniture and the subdivision of sources, the hall is symmetric.
    for (const double azimuth : {14.0, 30.0, 55.0})
        for (const double elevation : {12.0, 19.0, 34.0}) {
            const Air right = airAt(azimuth, elevation);
            const Air left = airAt(-azimuth, elevation);
            const double wrong = difference(right, mirrored(left));
            EXPECT_LT(wrong, 0.25) << azimuth << ' ' << elevation;
            EXPECT_GT(difference(right, left), 2 * wrong) << azimuth << ' ' << elevation;
        }
}

TEST(BouncedLight, ComesAndGoesWithTheDay)
{
    // Through the oculus at noon, through the window in the afternoon; none at night.
    test::Scene scene;
    scene.hall().set(test::hallTable().sunBy, SunBy::hour);
    for (int hour = 0; hour < 24; ++hour) {
        const Sun sun = sunAtHour(hour);
        const std::vector<SunTransfer::Source> sources = transfer().at(sun.azimuth, sun.elevation);
        // The block of the pass has space for this many.
        EXPECT_LT(sources.size(), 512U) << hour;
        for (const double light : test::airOf(transfer(), sources)) ASSERT_TRUE(light >= 0 && light < 1) << hour;
        scene.hall().set(test::hallTable().timeOfDay, static_cast<double>(hour));
        const std::string reason = reasonFor(scene.plan(), "hall/bounced light");
        if (hour < 6 || hour > 18) {
            EXPECT_EQ(reason, "the sun has set") << hour;
        } else if (hour >= 10 && hour <= 17) {
            EXPECT_EQ(reason, "it ran") << hour;
        }
    }
}

}  // namespace
}  // namespace vitrine::hall
