// S14 in the hall: objects seen through glass, the shadow of glass, and the passes for it.

#include "exhibits/hall/hall_model.h"
#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vitrine::sdf_morph {
namespace {

using glm::dvec3;
using namespace test;

class GlassInTheHall : public test::GlTest {};

constexpr double hidden = 0.05;  ///< A box that contains nothing of the torus, because it lies inside of the hole.

Shot glassInHall(double index, const dvec3& color = dvec3(1))
{
    Shot shot;
    shot.inHall();
    shot.size(160, 90);
    shot.hall().set(hallTable().sunAzimuth, 0.0);
    shot.hall().set(hallTable().sunElevation, 0.21);
    ParameterValues& o = shot.values();
    o.set(sdfTable().material, SdfMaterial::glass);
    o.set(sdfTable().refractiveIndex, index);
    o.set(sdfTable().baseColor, ColorValue{color});
    o.set(sdfTable().morph, 0.0);
    o.set(sdfTable().bounces, 4);
    return shot;
}

/// Returns the largest difference of the colors of two displayed pictures, in levels of 255.
double levels(const Picture& a, const Picture& b)
{
    double most = 0;
    a.each([&](int x, int y) {
        const dvec3 d = glm::abs(a.color(x, y) - b.color(x, y));
        most = std::max({most, d.r, d.g, d.b});
    });
    return 255 * most;
}

using LongGlassInTheHall = GlassInTheHall;

TEST_F(GlassInTheHall, ClearGlassOfIndex1ThrowsNoShadowAndShowsWhatIsBehindIt)
{
    Shot shot = glassInHall(1.0);
    shot.request.frame.averageIn = AverageIn::display;
    const Picture clear = shot.take();
    shot.values().set(sdfTable().boxSize, hidden);
    const Picture none = shot.take();
    EXPECT_LE(levels(clear, none), 1.0);
    // Controls: with index 1.5 it is visible, and its color falls on the plinth.
    EXPECT_GT(levels(glassInHall(1.5).take(), none), 20.0);
    Shot red = glassInHall(1.0, {1, 0.1, 0.1});
    red.request.frame.averageIn = AverageIn::display;
    EXPECT_GT(levels(red.take(), none), 20.0);
}

/// Ray behind the glass with a unit direction, at float64; `met` is false if it misses the glass.
struct LeavingRay {
    bool met = false;
    dvec3 origin{0}, direction{0};
    double share = 1;  ///< Transmitted share of the light.
};

/// Returns the direction by Snell's law; zero on total internal reflection.
dvec3 refracted(const dvec3& direction, const dvec3& facing, double eta)
{
    const double cosine = -glm::dot(direction, facing);
    const double k = 1 - eta * eta * (1 - cosine * cosine);
    return k < 0 ? dvec3(0) : eta * direction + (eta * cosine - std::sqrt(k)) * facing;
}

/// Returns the reflectance for unpolarized light. `eta` is the index before the surface divided by that behind it.
double fresnel(double cosine, double eta)
{
    const double sine2 = eta * eta * (1 - cosine * cosine);
    if (sine2 >= 1) return 1;
    const double behind = std::sqrt(1 - sine2);
    const double s = (eta * cosine - behind) / (eta * cosine + behind);
    const double p = (cosine - eta * behind) / (cosine + eta * behind);
    return 0.5 * (s * s + p * p);
}

LeavingRay through(const test::Solid& solid, const test::Ray& ray, double index)
{
    LeavingRay leaving{false, ray.origin, glm::normalize(ray.direction), 1};
    bool inside = false;
    for (int surface = 0; surface < 10; ++surface) {
        const test::Found found = solid.trace({leaving.origin, leaving.direction}, 0, 1e-7);
        if (!found.hit) break;
        leaving.met = true;
        const dvec3 facing = inside ? -found.normal : found.normal;
        const double eta = inside ? index : 1 / index;
        const dvec3 bent = refracted(leaving.direction, facing, eta);
        const bool total = bent == dvec3(0);
        if (!total) leaving.share *= 1 - fresnel(-glm::dot(leaving.direction, facing), eta);
        leaving.direction = total ? glm::reflect(leaving.direction, facing) : glm::normalize(bent);
        leaving.origin = found.world + (total ? 1e-5 : -1e-5) * facing;
        if (!total) inside = !inside;
    }
    return leaving;
}

/// Returns the bounds of the stone below the exhibit in world space.
render::Box plinthUnder(const Shot& shot)
{
    static const hall::HallModel building;
    const dvec3 below = dvec3(shot.worldFromExhibit()[3]) - dvec3(0, 0.8, 0);
    for (const hall::Collider& collider : building.colliders()) {
        const dvec3 local(collider.localFromWorld * glm::dvec4(below, 1));
        if (collider.cylinder || glm::any(glm::greaterThan(glm::abs(local), collider.halfSize))) continue;
        return render::Box{-collider.halfSize, collider.halfSize}.transformed(
            glm::affineInverse(collider.localFromWorld));
    }
    throw std::logic_error("no plinth stands below the exhibit");
}

/// For pixels that see the top of the plinth through the glass at float64: returns the relative difference of their
/// light from the plinth's at that point.
std::vector<double> errorsOnThePlinth(double drawnIndex, double tracedIndex)
{
    Shot shot = glassInHall(drawnIndex);
    shot.size(240, 180);
    const render::Box plinth = plinthUnder(shot);
    const dvec3 center(shot.worldFromExhibit()[3]);
    shot.see(center + dvec3(0.25, 1.1, 1.5), center + dvec3(0, -0.2, 0));
    shot.request.frame.camera.fovY = 0.6;
    ParameterValues& o = shot.values();
    o.set(sdfTable().roughness, 0.0);
    o.set(sdfTable().specular, 0.0);
    o.set(sdfTable().hitTolerance, 0.05);
    // The glass's effect on sunlight on the plinth is not tested here.
    shot.hall().set(hallTable().sunShadows, false);
    const Picture seen = shot.take();
    o.set(sdfTable().boxSize, hidden);
    const Picture behind = shot.take();
    o.set(sdfTable().boxSize, 1.0);
    const test::Solid solid(shot.values(), shot.worldFromExhibit());
    std::vector<double> errors;
    seen.each([&](int x, int y) {
        const LeavingRay ray = through(solid, test::pixelRay(seen.view, x, y), tracedIndex);
        if (!ray.met || ray.direction.y > -0.05) return;
        const dvec3 at = ray.origin + ray.direction * ((plinth.high.y - ray.origin.y) / ray.direction.y);
        if (at.x < plinth.low.x + 0.02 || at.x > plinth.high.x - 0.02 || at.z < plinth.low.z + 0.02 ||
            at.z > plinth.high.z - 0.02)
            return;
        const glm::dvec4 clip = seen.view.clipFromWorld * glm::dvec4(at, 1);
        const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(seen.view.raster.size);
        const glm::ivec2 i(static_cast<int>(pixel.x), seen.height() - 1 - static_cast<int>(pixel.y));
        if (i.x < 0 || i.y < 0 || i.x >= seen.width() || i.y >= seen.height()) return;
        errors.push_back(std::abs(seen.luminance(x, y) / (ray.share * behind.luminance(i.x, i.y)) - 1));
    });
    std::sort(errors.begin(), errors.end());
    return errors;
}

TEST_F(LongGlassInTheHall, ThePlinthIsSeenWhereFloat64FindsItThroughTheGlass)
{
    const std::vector<double> errors = errorsOnThePlinth(1.5, 1.5);
    ASSERT_GT(errors.size(), 300U);
    // The rest is reflection in the glass, and pixels with several points of the marble.
    EXPECT_LT(errors[errors.size() / 2], 0.06);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.3);
    // Control: rays with another index hit other points. Between 1.1 and 1.5 their light differs enough in any sky.
    const std::vector<double> other = errorsOnThePlinth(1.5, 1.1);
    EXPECT_GT(other[other.size() / 2], 0.15);
    EXPECT_GT(other[other.size() * 9 / 10], 1.0);
}

TEST_F(GlassInTheHall, ColoredGlassThrowsAColoredShadow)
{
    // Red glass without refraction: in the shadow of an opaque torus, the red of the sun remains, and little else.
    const auto lit = [](Shot shot) {
        shot.hall().set(hallTable().bakedLight, false);
        shot.see({1.2, 1.6, 9.5}, {0, 0, 6.5});
        return shot.take();
    };
    Shot opaque = glassInHall(1.0);
    opaque.values().set(sdfTable().material, SdfMaterial::opaque);
    Shot none = glassInHall(1.0);
    none.values().set(sdfTable().boxSize, hidden);
    const Picture dark = lit(opaque), red = lit(glassInHall(1.0, {1, 0.05, 0.05})), bright = lit(none);
    int shadow = 0, tinted = 0;
    bright.each([&](int x, int y) {
        // Pixels of the torus itself are left out.
        if (std::abs(dark.depth(x, y) - bright.depth(x, y)) > 1e-4) return;
        const dvec3 kept = dark.color(x, y) / bright.color(x, y);
        if (kept.r > 0.7) return;
        ++shadow;
        const dvec3 left = (red.color(x, y) - dark.color(x, y)) / (bright.color(x, y) - dark.color(x, y));
        tinted += left.r > 0.8 && left.g < 0.6 && left.b < 0.6;
    });
    EXPECT_GT(shadow, 100);
    EXPECT_GT(tinted, shadow * 8 / 10);
}

TEST_F(GlassInTheHall, OnlyGlassCopiesThePictureAndOnlyRoughGlassBlursIt)
{
    const auto planOf = [](const Shot& shot) {
        return test::planned(gallery().museum, shot.sceneState, shot.request.frame, {});
    };
    Shot shot = glassInHall(1.5);
    shot.values().set(sdfTable().roughness, 0.0);
    render::FramePlan plan = planOf(shot);
    EXPECT_TRUE(plan.find("kit/backdrop"));
    EXPECT_FALSE(plan.find("kit/backdrop/blurred"));
    EXPECT_TRUE(plan.find("exhibits/shadow/glass"));
    EXPECT_EQ(plan.find("sdf_morph/march")->phase, render::PassPhase::transparent);
    shot.values().set(sdfTable().roughness, 0.3);
    plan = planOf(shot);
    EXPECT_TRUE(plan.find("kit/backdrop/blurred"));
    shot.values().set(sdfTable().material, SdfMaterial::opaque);
    plan = planOf(shot);
    for (const char* pass : {"kit/backdrop", "kit/backdrop/blurred", "exhibits/shadow/glass"})
        EXPECT_FALSE(plan.find(pass)) << pass;
    EXPECT_EQ(plan.find("sdf_morph/march")->phase, render::PassPhase::opaque);
}

}  // namespace
}  // namespace vitrine::sdf_morph
