// Lamps in the vault: their light compared with a path tracer, and the times when they are on.
#include "exhibits/hall/vault_lamps.h"

#include "exhibits/hall/sun.h"
#include "render/files/strict_json.h"
#include "tests/exhibits/hall/bounced_light.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vitrine::hall {
namespace {

using namespace test;

render::Json readReference(const char* name)
{
    return render::readJson(std::string(VITRINE_SOURCE_DIR "/tests/exhibits/hall/") + name).root();
}

/// Square of the hall, and the light from lamps of radiance 1 on it, path traced by assets/models/hall_lamps.py.
struct LampSquare {
    std::string name;
    double light = 0;
    glm::dvec3 normal{0};
    std::vector<glm::dvec3> places;
    std::vector<glm::dvec2> atlas;
};

std::vector<LampSquare> lampSquares()
{
    const auto vectorOf = [](const render::Json& c) {
        return glm::dvec3(c[0].get<double>(), c[1].get<double>(), c[2].get<double>());
    };
    const render::Json light = readReference("lamp_light_reference.json");
    const render::Json squares = readReference("bounced_light_reference.json");
    std::vector<LampSquare> all;
    for (const render::Json& region : squares.at("regions")) {
        LampSquare square{region.at("name").get<std::string>(), 0, vectorOf(region.at("normal")), {}, {}};
        square.light = light.at(square.name).get<double>();
        for (const render::Json& place : region.at("places")) square.places.push_back(vectorOf(place));
        for (const render::Json& at : region.at("atlas"))
            square.atlas.emplace_back(at[0].get<double>(), at[1].get<double>());
        all.push_back(std::move(square));
    }
    return all;
}

/// Returns the mean of the lightmap's alpha over the square, as shaders read it.
double lampsOnLightmap(const LampSquare& square)
{
    const render::Texture& map = *test::building().surfaces().lightmaps().sky;
    double sum = 0;
    for (const glm::dvec2& at : square.atlas) {
        const glm::ivec2 texel(at * glm::dvec2(map.width, map.height));
        const double code = map.bytes[static_cast<std::size_t>(4 * (texel.y * map.width + texel.x) + 3)] / 255.0;
        sum += code * code * test::building().surfaces().lightmaps().lamps.surfaceScale();
    }
    return sum / static_cast<double>(square.atlas.size());
}

/// Returns the same for the air in front of the square.
double lampsInAir(const LampSquare& square)
{
    const LampLight& lamps = test::building().surfaces().lightmaps().lamps;
    test::Air air(lamps.air()->bytes.size());
    for (std::size_t i = 0; i < air.size(); ++i) {
        const double code = lamps.air()->bytes[i] / 255.0;
        air[i] = code * code * lamps.airScale();
    }
    double sum = 0;
    for (const glm::dvec3& place : square.places)
        sum += test::airOn(test::building().surfaces().lightmaps().sun, air, place, square.normal);
    return sum / static_cast<double>(square.places.size());
}

TEST(VaultLamps, LightTheHallAsAPathTracerSays)
{
    ASSERT_EQ(test::building().surfaces().lightmaps().sky->channels, 4);
    double mean = 0;
    const std::vector<LampSquare> squares = lampSquares();
    ASSERT_EQ(squares.size(), 8U);
    for (const LampSquare& square : squares) {
        EXPECT_NEAR(lampsOnLightmap(square), square.light, 0.08 * square.light) << square.name;
        // In the air near walls, objects beside them take some of the light.
        EXPECT_NEAR(lampsInAir(square), square.light, 0.25 * square.light) << square.name;
        mean += square.light / 8;
    }
    // Control: one value for the whole hall would be wrong.
    EXPECT_GE(std::count_if(squares.begin(), squares.end(),
                            [&](const LampSquare& s) { return std::abs(mean - s.light) > 0.08 * s.light; }),
              4);
}

TEST(VaultLamps, BurnAsTheSunSinks)
{
    EXPECT_EQ(lampsShareAt(lampsBegin), 0);
    EXPECT_EQ(lampsShareAt(0.0), 1);
    EXPECT_EQ(lampsShareAt(-0.7), 1);
    for (double height = 0; height < lampsBegin; height += 1e-3)
        EXPECT_NEAR(lampsShareAt(height), lampsShareAt(height + 1e-3), 0.012) << height;

    test::Scene scene;
    const auto lampsAt = [&](double hour) {
        scene.hall().set(hallTable().timeOfDay, hour);
        return vaultLampsOf(hallTable(), scene.hall()).radiance.r;
    };
    scene.hall().set(hallTable().sunBy, SunBy::hour);
    EXPECT_EQ(lampsAt(12), 0);
    EXPECT_EQ(lampsAt(16.9), 0);
    EXPECT_GT(lampsAt(17.6), 0);
    EXPECT_GT(lampsAt(18), lampsAt(17.6));
    EXPECT_EQ(lampsAt(22), lampsAt(18));
    EXPECT_EQ(lampsAt(6), lampsAt(18)) << "and in the morning";
}

bool readsLamps(const render::FramePlan& plan, const char* pass)
{
    const render::Pass* found = plan.find(pass);
    if (!found) return false;
    const std::vector<std::string>& defines = found->shader.defines;
    return std::find(defines.begin(), defines.end(), "LAMP_LIGHT") != defines.end();
}

TEST(VaultLamps, CostNothingByDay)
{
    test::Scene scene;
    const std::vector<const char*> readers{"hall/walls", "hall/floor", "hall/light in the air", "probe/walls/0"};
    const auto expectDark = [&](const char* why) {
        const render::FramePlan plan = scene.plan();
        EXPECT_EQ(reasonFor(plan, "hall/lamps"), why);
        for (const char* pass : readers) EXPECT_FALSE(readsLamps(plan, pass)) << pass;
    };
    expectDark("the sun is too high for lamps");
    scene.hall().set(hallTable().lamps, LampsLit::on);
    const render::FramePlan lit = scene.plan();
    for (const char* pass : readers) EXPECT_TRUE(readsLamps(lit, pass)) << pass;
    EXPECT_FALSE(lit.findSkipped("hall/lamps"));
    scene.hall().set(hallTable().lampStrength, 0.0);
    expectDark("the strength of the lamps is 0");
    scene.hall().set(hallTable().lamps, LampsLit::off);
    expectDark("the lamps are switched off");
}

}  // namespace
}  // namespace vitrine::hall
