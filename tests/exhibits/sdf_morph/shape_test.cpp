// S1, S2, S3, S5, S8, S12: pictures of the ray-marched object, compared with the same field at float64.

#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::sdf_morph {
namespace {

using glm::dmat4;
using glm::dvec3;
using namespace test;

class Shape : public test::GlTest {};

/// Expects a correct outline: every ray that hits the surface is drawn, and every drawn pixel has a ray within the
/// tolerance of the table. 2 % are allowed for rounding of positions at float32, 1e-5 m compared with half a pixel.
void expectOutlineOfTheField(Shot& shot, const char* what)
{
    const Picture picture = shot.take();
    const Solid solid(shot.values(), shot.worldFromExhibit());
    int missing = 0, extra = 0, hits = 0;
    picture.each([&](int x, int y) {
        const Found truth = solid.trace(picture.view, x, y);
        hits += truth.hit;
        missing += truth.hit && truth.cosine > 0.02 && !picture.hit(x, y);
        extra += picture.hit(x, y) && !truth.hit && truth.closest > 1.02;
    });
    EXPECT_EQ(missing, 0) << what << ": pixels of " << hits << " are missing";
    EXPECT_EQ(extra, 0) << what << ": pixels beside the object are drawn";
    EXPECT_GT(hits, 20) << what << ": the test must see the object";
}

TEST_F(Shape, NothingIsDrawnOutsideTheBoundingMesh)
{
    for (const double size : {1.0, 0.5, 3.0}) {
        Shot shot;
        shot.values().set(sdfTable().boxSize, size);
        const Picture picture = shot.take();
        const Solid solid(shot.values(), dmat4(1));
        int outside = 0, insideBox = 0;
        picture.each([&](int x, int y) {
            const test::Ray ray = test::pixelRay(picture.view, x, y);
            insideBox += solid.meetsBox(ray);
            outside += !solid.meetsBox(ray, 1e-5) && (picture.hit(x, y) || picture.alpha(x, y) > 0);
        });
        EXPECT_EQ(outside, 0) << size;
        EXPECT_GT(insideBox, 100);
        EXPECT_GT(picture.hits(), 50);
    }
}

TEST_F(Shape, OutOfViewNotOnePixelIsMarched)
{
    Shot shot;
    shot.see({0, 0, 2}, {0, 0, 9});
    const Picture picture = shot.take();
    for (const render::StepReport& step : picture.report.ran)
        EXPECT_EQ(step.name.rfind("sdf_morph/", 0), std::string::npos) << step.name;
    for (const float alpha : picture.image.pixels) EXPECT_TRUE(alpha == 0 || !std::isfinite(alpha));
}

TEST_F(Shape, TorusAndMugAndAllBetweenHaveTheOutlineOfTheField)
{
    for (const double morph : {0.0, 0.25, 0.5, 0.62, 0.85, 1.0}) {
        Shot shot;
        shot.values().set(sdfTable().morph, morph);
        expectOutlineOfTheField(shot, ("morph " + std::to_string(morph)).c_str());
    }
}

TEST_F(Shape, TheOutlineOfTheTorusIsNotThatOfTheMug)
{
    // Control: the test above distinguishes the two shapes.
    Shot shot;
    shot.values().set(sdfTable().morph, 0.0);
    const Picture torus = shot.take();
    shot.values().set(sdfTable().morph, 1.0);
    const Solid mug(shot.values(), dmat4(1));
    int wrong = 0;
    torus.each([&](int x, int y) { wrong += mug.trace(torus.view, x, y).hit != torus.hit(x, y); });
    EXPECT_GT(wrong, 100);
}

TEST_F(Shape, DepthIsThatOfTheExactShapes)
{
    for (const double morph : {0.0, 1.0}) {
        Shot shot;
        shot.values().set(sdfTable().morph, morph);
        shot.values().set(sdfTable().hitTolerance, 0.02);
        shot.values().set(sdfTable().stepLimit, 1024);
        const Picture picture = shot.take();
        const Solid solid(shot.values(), dmat4(1));
        int compared = 0;
        picture.each([&](int x, int y) {
            const Found truth = solid.trace(picture.view, x, y);
            if (!truth.hit || truth.grazed || truth.cosine < 0.2) return;  // At steep surfaces, depth changes too fast.
            ++compared;
            EXPECT_NEAR(picture.depth(x, y) / truth.distance, 1, 1e-3) << "morph " << morph << " at " << x << ',' << y;
        });
        EXPECT_GT(compared, 200);
    }
}

TEST_F(Shape, NoHolesWhileItMelts)
{
    // A hole is a pixel without a hit whose eight neighbors all have one, and whose ray hits the field.
    for (int i = 0; i <= 8; ++i) {
        Shot shot;
        shot.values().set(sdfTable().morph, i / 8.0);
        const Picture p = shot.take();
        p.each([&](int x, int y) {
            if (x == 0 || y == 0 || x == p.width() - 1 || y == p.height() - 1 || p.hit(x, y)) return;
            int around = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) around += p.hit(x + dx, y + dy);
            EXPECT_LT(around, 8) << "morph " << i / 8.0 << " at " << x << ',' << y;
        });
    }
}

TEST_F(Shape, FromInsideTheBoundingMeshTheObjectIsStillSeen)
{
    Shot torus;
    torus.values().set(sdfTable().morph, 0.0);
    torus.see({0, 0, 0}, {1, 0, 0});  // Camera in the hole.
    torus.request.frame.camera.fovY = 1.6;
    expectOutlineOfTheField(torus, "in the torus's hole");

    Shot mug;
    mug.values().set(sdfTable().morph, 1.0);
    mug.see({-0.05, 0.1, 0}, {-0.3, -0.2, 0.1});  // Camera in the cup.
    mug.request.frame.camera.fovY = 1.2;
    expectOutlineOfTheField(mug, "in the cup");
    Picture inside = mug.take();
    EXPECT_GT(inside.hits(), inside.width() * inside.height() / 2);
}

TEST_F(Shape, TheOutlineStaysWholeWhileTheCameraEntersTheBoundingMesh)
{
    Shot shot;
    shot.values().set(sdfTable().morph, 0.62);
    shot.request.frame.camera.fovY = 1.4;
    shot.size(64, 36);
    const double front = Solid(shot.values(), dmat4(1)).box().high.z;
    int last = -1;
    for (int i = -6; i <= 6; ++i) {
        const double z = front - 0.004 * i;
        shot.see({0.05, 0.05, z}, {0.05, 0.0, -1});
        const int hits = shot.take().hits();
        if (last >= 0) {
            // 4 mm nearer: an outline of some 200 pixels moves by at most a hundredth of the picture's height.
            EXPECT_NEAR(hits, last, 0.02 * 64 * 36) << "step " << i;
        }
        last = hits;
        expectOutlineOfTheField(shot, ("step " + std::to_string(i)).c_str());
    }
}

TEST_F(Shape, TheNearPlaneCutsNoHoleIntoTheBoundingMesh)
{
    // The front of the mesh is between eye and near plane; the object behind it is not.
    Shot shot;
    shot.values().set(sdfTable().boxSize, 1.3);
    const double front = Solid(shot.values(), dmat4(1)).box().high.z;
    for (const double ahead : {0.001, 0.01, 0.019, 0.021}) {
        shot.see({0.2, 0.1, front + ahead}, {0, 0, -1});
        shot.request.frame.camera.fovY = 1.5;
        expectOutlineOfTheField(shot, ("front face " + std::to_string(ahead) + " m ahead").c_str());
    }
}

TEST_F(Shape, InTheSolidOrOnItsSurfaceThePictureIsFinite)
{
    for (const dvec3 eye :
         {dvec3(0.35, 0, 0), dvec3(0.47, 0, 0), dvec3(0.4701, 0, 0), dvec3(0.23, 0, 0), dvec3(0, 0.35, 0.12)}) {
        Shot shot;
        shot.values().set(sdfTable().morph, 0.0);
        shot.request.frame.channels.evaluations = true;
        for (const dvec3 target : {dvec3(5, 0.1, 0), dvec3(-5, 0, 0.2), dvec3(0.1, 5, 0.1)}) {
            shot.see(eye, target);
            const Picture picture = shot.take();
            EXPECT_EQ(test::notFinite(picture.image, 4), "");
            for (int i = 0; i < picture.width() * picture.height(); ++i)
                EXPECT_LT(picture.image.pixels[static_cast<std::size_t>(i) * 9 + 8], 4000) << "a ray does not end";
        }
    }
}

/// Returns the transforms that a visitor can set, including mirrored and non-uniform ones.
std::vector<std::pair<const char*, dmat4>> transforms()
{
    const dmat4 one(1);
    return {{"moved", glm::translate(one, dvec3(0.3, -0.2, 0.4))},
            {"turned", glm::rotate(glm::rotate(one, 0.7, dvec3(0, 1, 0)), 0.5, dvec3(1, 0, 0))},
            {"larger", glm::scale(one, dvec3(1.6))},
            {"non-uniform", glm::scale(one, dvec3(1, 2, 0.5))},
            {"mirrored", glm::scale(one, dvec3(-1, 1, 1))},
            {"mirrored twice", glm::scale(one, dvec3(-1, 1, -0.7))},
            {"mirrored, turned, non-uniform",
             glm::rotate(glm::scale(glm::rotate(one, 0.6, dvec3(0, 0, 1)), dvec3(1, -1.4, 0.6)), 0.4, dvec3(0, 1, 0))}};
}

TEST_F(Shape, FollowsItsTransform)
{
    for (const auto& [name, transform] : transforms()) {
        Shot shot;
        shot.values().set(sdfTable().morph, 0.85);
        shot.transform(transform).see({0.9, 0.6, 2.6}, {0, 0, 0});
        expectOutlineOfTheField(shot, name);
    }
}

/// Returns the number of pixels in which two outlines differ although all neighbors agree, so not at the edge.
int differenceOffTheEdge(const Picture& a, const Picture& b)
{
    int count = 0;
    a.each([&](int x, int y) {
        if (a.hit(x, y) == b.hit(x, y)) return;
        bool edge = false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int nx = std::clamp(x + dx, 0, a.width() - 1), ny = std::clamp(y + dy, 0, a.height() - 1);
                edge = edge || b.hit(nx, ny) == a.hit(x, y);
            }
        count += !edge;
    });
    return count;
}

Picture meshTwin(Shot shot, int cells)
{
    shot.values().set(sdfTable().shownAs, SdfShown::mesh);
    shot.values().set(sdfTable().tessellation, cells);
    return shot.take();
}

TEST_F(Shape, OutlineAndDepthAreThoseOfTheRasterizedTwin)
{
    for (const auto& [name, transform] : transforms()) {
        Shot shot;
        shot.values().set(sdfTable().morph, 0.85);
        shot.values().set(sdfTable().hitTolerance, 0.005);
        shot.transform(transform).see({0.9, 0.6, 2.6}, {0, 0, 0});
        const Picture marched = shot.take();
        const Picture mesh = meshTwin(shot, 128);
        EXPECT_GT(mesh.hits(), 100) << name;
        EXPECT_EQ(differenceOffTheEdge(marched, mesh), 0) << name;
        // Away from the edge both differ by the chords of the mesh only: with cells of 7 mm (times a scale of 2),
        // curves of 5 cm sag by up to 0.4 mm, twice that in slanted views, and more at the rim and in the fillet of the
        // handle.
        std::vector<double> errors;
        marched.each([&](int x, int y) {
            if (marched.hit(x, y) && mesh.hit(x, y)) errors.push_back(std::abs(marched.depth(x, y) - mesh.depth(x, y)));
        });
        std::sort(errors.begin(), errors.end());
        EXPECT_LT(errors[errors.size() / 2], 1e-3) << name;
        EXPECT_LT(errors[errors.size() * 9 / 10], 5e-3) << name;
    }
    // Control: a mesh of other values is detected.
    Shot shot;
    shot.values().set(sdfTable().morph, 0.85);
    const Picture still = shot.take();
    shot.transform(glm::scale(dmat4(1), dvec3(-1, 1, 1)));
    EXPECT_GT(differenceOffTheEdge(still, meshTwin(shot, 48)), 20);
}

TEST_F(Shape, NormalsGoByTheInverseTranspose)
{
    for (const auto& [name, placed] : transforms()) {
        const dmat4 transform = placed;  // A lambda cannot capture a structured binding.
        Shot shot;
        shot.values().set(sdfTable().morph, 0.0);  // Smooth everywhere: differences cannot cross a crease.
        shot.values().set(sdfTable().hitTolerance, 0.02);
        shot.transform(transform).see({0.9, 0.6, 2.6}, {0, 0, 0}).size(192, 108);
        const Picture picture = shot.take();
        const Solid solid(shot.values(), transform);
        std::vector<double> angles;
        double naive = 0;
        picture.each([&](int x, int y) {
            const Found truth = solid.trace(picture.view, x, y);
            if (!truth.hit || truth.grazed || truth.cosine < 0.25 || !picture.hit(x, y)) return;
            EXPECT_NEAR(glm::length(picture.normal(x, y)), 1, 1e-4);
            angles.push_back(std::acos(std::clamp(glm::dot(picture.normal(x, y), truth.normal), -1.0, 1.0)));
            // Control: a normal transformed like a vector.
            const dvec3 local = glm::normalize(glm::transpose(glm::dmat3(transform)) * truth.normal);
            const dvec3 wrong = glm::normalize(glm::dmat3(transform) * local);
            naive = std::max(naive, std::acos(std::clamp(glm::dot(wrong, truth.normal), -1.0, 1.0)));
        });
        ASSERT_GT(angles.size(), 200U) << name;
        std::sort(angles.begin(), angles.end());
        // One degree: the step of the differences, a quarter of a pixel, on a tube of 12 cm.
        EXPECT_LT(angles[angles.size() * 99 / 100], 0.01745) << name;
        EXPECT_LT(angles.back(), 0.07) << name;
        if (std::string(name).find("non-uniform") != std::string::npos) {
            EXPECT_GT(naive, 0.3) << name;
        }
    }
}

TEST_F(Shape, NormalsStayQuietFarAway)
{
    for (const double far : {3.0, 12.0, 40.0}) {
        Shot shot;
        shot.values().set(sdfTable().morph, 0.0);
        shot.see(glm::normalize(dvec3(0.3, 0.25, 1)) * far, {0, 0, 0});
        shot.request.frame.camera.fovY = std::max(1.3 / far, 0.0175);
        const Picture picture = shot.take();
        const Solid solid(shot.values(), dmat4(1));
        std::vector<double> angles;
        picture.each([&](int x, int y) {
            if (!picture.hit(x, y)) return;
            // At the surface point of the picture, so that only the error of the normal counts.
            const test::Ray ray = test::pixelRay(picture.view, x, y);
            const dvec3 truth = solid.normalAt(ray.origin + ray.direction * picture.depth(x, y));
            angles.push_back(std::acos(std::clamp(glm::dot(picture.normal(x, y), truth), -1.0, 1.0)));
        });
        ASSERT_GT(angles.size(), 200U) << far;
        std::sort(angles.begin(), angles.end());
        EXPECT_LT(angles[angles.size() * 95 / 100], 0.1 * 0.0174533) << far << " m";
    }
}

TEST_F(Shape, AThinRingFarAwayIsNotLost)
{
    Shot shot;
    shot.values().set(sdfTable().morph, 0.0);
    shot.values().set(sdfTable().minorRadius, 0.01);
    shot.see({0, 0, 30}, {0, 0, 0});
    shot.request.frame.camera.fovY = 0.0288;
    expectOutlineOfTheField(shot, "wire of 1 cm at 30 m");
}

TEST_F(Shape, GrazingRaysLeaveNoHolesWithFewSteps)
{
    // A ray without remaining steps ends at its best candidate: everything solid is drawn all the same.
    Shot shot;
    shot.values().set(sdfTable().morph, 1.0);
    shot.values().set(sdfTable().stepLimit, 9);
    shot.values().set(sdfTable().relaxation, SdfRelaxation::none);
    shot.values().set(sdfTable().conePrepass, false);
    const Picture picture = shot.take();
    const Solid solid(shot.values(), dmat4(1));
    int missing = 0;
    picture.each([&](int x, int y) {
        const Found truth = solid.trace(picture.view, x, y);
        missing += truth.hit && truth.cosine > 0.05 && !picture.hit(x, y);
    });
    EXPECT_EQ(missing, 0);
    // Control: the limit does end rays.
    shot.values().set(sdfTable().stepLimit, 1024);
    EXPECT_GT(test::largestDifference(shot.take().image, picture.image), 0);
}

TEST_F(Shape, IsTheSameFromATriangleOverTheWholePicture)
{
    for (const bool inHall : {false, true}) {
        Shot box;
        if (inHall) box.inHall();
        Shot picture = box;
        picture.values().set(sdfTable().drawnOver, SdfDrawnOver::picture);
        const Picture ofBox = box.take();
        const Picture ofPicture = picture.take();
        EXPECT_EQ(ofPicture.image.pixels, ofBox.image.pixels);
        const auto marched = [](const Shot& shot) {
            const render::FramePlan plan = test::planned(gallery().museum, shot.sceneState, shot.request.frame);
            return plan.find("sdf_morph/march")->draws.at(0).mesh;
        };
        EXPECT_EQ(marched(picture), nullptr);  // One triangle without vertices.
        EXPECT_NE(marched(box), nullptr);
    }
}

TEST_F(Shape, ABoxTooSmallClipsVisibly)
{
    Shot shot;
    const Picture whole = shot.take();
    shot.values().set(sdfTable().boxSize, 0.6);
    const Picture clipped = shot.take();
    const Solid solid(shot.values(), dmat4(1));
    EXPECT_LT(clipped.hits(), 0.8 * whole.hits());
    EXPECT_GT(clipped.hits(), 30);
    clipped.each([&](int x, int y) {
        if (!clipped.hit(x, y)) return;
        const test::Ray ray = test::pixelRay(clipped.view, x, y);
        const dvec3 p = ray.origin + ray.direction * clipped.depth(x, y);
        EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(p - solid.box().center()), solid.box().halfSize() + 0.003)))
            << x << ',' << y;
    });
}

TEST_F(Shape, TheOverlayShowsTheBoxAndTurnsRedWhenItClips)
{
    Shot shot;
    const int plain = shot.take().hits();
    shot.values().set(sdfTable().showBox, true);
    const Picture good = shot.take();
    EXPECT_GT(good.hits(), plain + 50);
    shot.values().set(sdfTable().boxSize, 0.6);
    const Picture clips = shot.take();
    // Amber is one third green; the red of clipping has almost none.
    const auto greenShare = [&](const Picture& p) {
        const Solid solid(shot.values(), dmat4(1));
        double share = 0;
        int n = 0;
        p.each([&](int x, int y) {
            const dvec3 c = p.color(x, y);
            if (!p.hit(x, y) || c.r < 0.25 || c.b > 0.1 * c.r) return;
            share += c.g / c.r;
            ++n;
        });
        EXPECT_GT(n, 10);
        return share / std::max(n, 1);
    };
    EXPECT_GT(greenShare(good), 0.2);
    EXPECT_LT(greenShare(clips), 0.15);
}

}  // namespace
}  // namespace vitrine::sdf_morph
