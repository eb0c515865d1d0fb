// Coats on an exhibit that is scaled unevenly or mirrored. Bodies and fur are scaled together: a strand's length along
// an axis is scaled like the axis. Normals use the inverse transpose.

#include "exhibits/fur/bounce.h"
#include "tests/exhibits/fur/fur_shot.h"
#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::fur {
namespace {

using namespace test;

using FurScaled = GlTest;

/// Returns a shot of the bodies alone, with static, upright fur.
FurShot uprightFur()
{
    FurShot shot;
    shot.set(furTable().byHand, true).set(furTable().levelOfDetail, false);
    for (const Real tipOffset : {furTable().handX, furTable().handY, furTable().handZ, furTable().comb,
                                 furTable().disorder, furTable().clump, furTable().flattening})
        shot.set(tipOffset, 0.0);
    return shot;
}

glm::dvec3 mirrored(const glm::dvec3& v)
{
    return {-v.x, v.y, v.z};
}

TEST_F(FurScaled, AMirroredExhibitIsTheMirrorImageOfItself)
{
    const Shot plain = uprightFur();
    Shot turned = plain;
    turned.transform(glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)));
    const render::Camera& camera = plain.request.frame.camera;
    turned.see(mirrored(camera.eye), mirrored(camera.target));
    const Picture a = plain.take();
    const Picture b = turned.take();
    int furry = 0;
    int same = 0;
    int sameUnmirrored = 0;
    a.each([&](int x, int y) {
        if (!a.hit(x, y)) return;
        ++furry;
        const auto agrees = [&](int bx, const glm::dvec3& normal) {
            return b.hit(bx, y) && std::abs(b.depth(bx, y) - a.depth(x, y)) < 1e-3 &&
                   glm::length(b.normal(bx, y) - normal) < 1e-2;
        };
        same += agrees(a.width() - 1 - x, mirrored(a.normal(x, y)));
        sameUnmirrored += agrees(x, a.normal(x, y));
    });
    EXPECT_GT(furry, 1500);
    // Rounding decides about strands thinner than a pixel.
    EXPECT_GT(same, 0.97 * furry) << "of " << furry;
    EXPECT_LT(sameUnmirrored, 0.5 * furry) << "the scene is symmetric: the comparison proves nothing";
}

TEST_F(FurScaled, NormalsOfAnUnevenlyScaledSkinAreThoseOfItsEllipsoid)
{
    Shot shot = uprightFur();
    for (const Real length :
         {furTable().coats[furBall].length, furTable().coats[furRoll].length, furTable().coats[furRing].length})
        shot.values().set(length, 0.0);
    const glm::dmat4 scale = glm::scale(glm::dmat4(1), glm::dvec3(1, 2, 0.7));
    shot.transform(scale);
    render::Camera camera = shot.request.frame.camera;
    shot.see(glm::dvec3(scale * glm::dvec4(camera.eye, 1)), glm::dvec3(scale * glm::dvec4(camera.target, 1)));
    const Picture p = shot.take();
    const FurState ball = restStates(bounceSettings(furTable(), shot.values(), nullptr, 0))[furBall];
    const glm::dmat3 back = glm::inverse(glm::dmat3(scale));
    struct Seen {
        /// Offset from the ball's center, scaled back, and the normal as written, in world space.
        glm::dvec3 out, normal;
    };
    std::vector<Seen> seen;
    p.each([&](int x, int y) {
        if (!p.hit(x, y) || glm::length(p.normal(x, y)) < 0.5) return;
        const Ray ray = pixelRay(p.view, x, y);
        const glm::dvec3 out = back * (ray.origin + ray.direction * p.depth(x, y)) - ball.position;
        if (std::abs(glm::length(out) - ballRadius * ball.skinScale) < 0.01) seen.push_back({out, p.normal(x, y)});
    });
    ASSERT_GT(seen.size(), 300U);
    const auto median = [&](const glm::dmat3& worldNormalFromNormal) {
        std::vector<double> misses;
        for (const Seen& s : seen)
            misses.push_back(
                std::acos(std::min(glm::dot(glm::normalize(worldNormalFromNormal * s.out), s.normal), 1.0)));
        std::nth_element(misses.begin(), misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2), misses.end());
        return misses[misses.size() / 2];
    };
    EXPECT_LT(median(glm::transpose(back)), 0.03) << "radians";
    EXPECT_GT(median(glm::dmat3(scale)), 0.2) << "normals carried like directions would do as well";
}

TEST_F(FurScaled, AnUnevenlyScaledCoatIsTheScaledCoatOnEverySide)
{
    // Extent of the fur beyond the skin, up and sideways: that of the scaled sphere of skin and fur, at float64.
    Shot shot = uprightFur();
    shot.values().set(furTable().coats[furBall].uniformity, 1.0);
    shot.values().set(furTable().strandRoundness, 0.999);
    shot.values().set(furTable().gravity, 0.0);
    const FurState ball = restStates(bounceSettings(furTable(), shot.values(), nullptr, 0))[furBall];
    const double reach = ballRadius * ball.skinScale + shot.values()[furTable().coats[furBall].length];
    for (const glm::dvec3 factors : {glm::dvec3(1), glm::dvec3(1, 1.6, 1), glm::dvec3(1.6, 1, 0.5)}) {
        const glm::dmat4 scale = glm::scale(glm::dmat4(1), factors);
        shot.transform(scale);
        const glm::dvec3 center = factors * ball.position;
        shot.see(center + glm::dvec3(0, 0, 12), center);
        shot.request.frame.camera.fovY = 0.2;
        shot.size(96, 96);
        const Picture p = shot.take();
        int highest = p.height();
        int leftmost = p.width();
        p.each([&](int x, int y) {
            if (!p.hit(x, y)) return;
            if (std::abs(x - p.width() / 2) < 4) highest = std::min(highest, y);
            if (std::abs(y - p.height() / 2) < 4) leftmost = std::min(leftmost, x);
        });
        const double pixel = 2 * 12 * std::tan(0.1) / p.height();
        EXPECT_NEAR((p.height() / 2.0 - highest) * pixel, reach * factors.y, 0.04 * reach * factors.y) << factors.y;
        EXPECT_NEAR((p.width() / 2.0 - leftmost) * pixel, reach * factors.x, 0.04 * reach * factors.x) << factors.x;
        // Control: the naive method moves the skin along its transformed normal by the unscaled length.
        const double naive = ballRadius * ball.skinScale * factors.y + shot.values()[furTable().coats[furBall].length];
        EXPECT_TRUE(factors.y == 1 || std::abs(naive - reach * factors.y) > 0.1 * reach);
    }
}

}  // namespace
}  // namespace vitrine::fur
