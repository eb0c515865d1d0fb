// How light the hall is: what bounces, what the film makes of it, and what nothing falls on.
#include "exhibits/hall/hall.h"
#include "exhibits/kit/exhibit_pass.h"
#include "tests/exhibits/hall/bounced_light.h"
#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

using test::hallTable;
using test::Picture;
using test::Shot;

constexpr double degree = std::numbers::pi / 180;

class LightLevels : public test::GlTest {};

const Hall& hall()
{
    static const Hall built(std::make_shared<const HallModel>(), {});
    return built;
}

TEST_F(LightLevels, TheMapOfBouncedLightIsThatOfFloat64)
{
    Shot shot;
    const HallScene scene = hall().scene(shot.hall(), false, nullptr);
    render::FramePlan plan;
    planBouncedLight(scene, sceneLighting(scene), plan);
    plan.prune({"light.bounced"});
    render::gl::Renderer renderer;
    (void)renderer.draw(plan);
    const render::Image map = renderer.read("light.bounced");
    const SunTransfer& transfer = scene.model.sunTransfer();
    ASSERT_EQ(map.width, transfer.surfaces()->width);
    const test::Air air =
        test::airOf(transfer, transfer.at(shot.hall()[hallTable().sunAzimuth], shot.hall()[hallTable().sunElevation]));
    // Middles of large triangles, which lie on the map as the mesh says.
    int checked = 0;
    for (const render::MeshInstance& part : scene.model.walls())
        for (std::size_t i = 0; i + 2 < part.mesh->indices.size(); i += 3) {
            const render::Vertex* corner[3];
            for (std::size_t k = 0; k < 3; ++k) corner[k] = &part.mesh->vertices[part.mesh->indices[i + k]];
            const glm::dvec2 a(corner[0]->extra), b(corner[1]->extra), c(corner[2]->extra);
            const glm::dvec2 size(map.width, map.height);
            if (std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) * size.x * size.y < 600) continue;
            // The texel's middle, and where on the triangle that is.
            const glm::ivec2 texel((a + b + c) / 3.0 * size);
            const glm::dvec2 at = (glm::dvec2(texel) + 0.5) / size;
            const glm::dvec2 st = glm::inverse(glm::dmat2(b - a, c - a)) * (at - a);
            const auto blend = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
                return p + st.x * (q - p) + st.y * (r - p);
            };
            const glm::dvec3 place = blend(corner[0]->position, corner[1]->position, corner[2]->position);
            const glm::dvec3 n = glm::normalize(blend(corner[0]->normal, corner[1]->normal, corner[2]->normal));
            const glm::dvec3 right = test::surfaceShare(transfer, at) * test::airOn(transfer, air, place, n);
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(map.at(texel.x, map.height - 1 - texel.y, k), right[k], 5e-3 * right[k] + 1e-6);
            ++checked;
        }
    EXPECT_GT(checked, 20);
}

/// The walls alone, scene-linear, under a sky that does not know how strong and how high the sun is.
render::Image wallsWith(const ParameterValues& values)
{
    const HallScene scene = hall().scene(values, false, nullptr);
    SceneLighting light = sceneLighting(scene);
    light.light.skyZenith = {1.2F, 1.5F, 2};
    light.light.skyHorizon = {1.9F, 2, 2.1F};
    light.light.skySunward = {0, 0, 0};
    render::FramePlan plan;
    render::Raster raster;
    raster.size = {96, 54};
    plan.view = render::makeView(hall().bestView(values), raster);
    plan.image({.name = radianceImage, .format = render::Format::rgba32f});
    plan.image({.name = depthImage, .format = render::Format::depth32f, .nearest = true});
    planHallShadow(scene, light, plan);
    planBouncedLight(scene, light, plan);
    planAirLight(scene, light, plan);
    planContactShadows(scene, plan);
    planProbe(scene, light, plan);
    planWalls(scene, light, {}, plan);
    plan.prune({radianceImage});
    render::gl::Renderer renderer;
    (void)renderer.draw(plan);
    return renderer.read(radianceImage);
}

TEST_F(LightLevels, OfASunThatShinesInNowhereAreThoseOfNoSun)
{
    Shot shot;
    shot.hall().set(hallTable().reflectionProbe, false);
    const auto under = [&](double azimuth, double elevation, double strength) {
        shot.hall().set(hallTable().sunAzimuth, azimuth * degree);
        shot.hall().set(hallTable().sunElevation, elevation * degree);
        shot.hall().set(hallTable().sunStrength, strength);
        return wallsWith(shot.hall());
    };
    const render::Image none = under(-3, 19, 0);
    EXPECT_EQ(test::largestDifference(under(170, 12, 3.6), none), 0);
    EXPECT_GT(test::largestDifference(under(-3, 19, 3.6), none), 0.1);
}

}  // namespace
}  // namespace vitrine
