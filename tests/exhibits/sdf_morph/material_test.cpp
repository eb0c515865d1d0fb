// S7, S14: glass, the rasterized twin, heat maps.

#include "exhibits/compare/offered_comparison.h"
#include "tests/exhibits/sdf_morph/truth.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::sdf_morph {
namespace {

using glm::dvec3;
using namespace test;

class Material : public test::GlTest {};

Shot glass(double index)
{
    Shot shot;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().probeSize, 256);
    ParameterValues& o = shot.values();
    o.set(sdfTable().material, SdfMaterial::glass);
    o.set(sdfTable().refractiveIndex, index);
    o.set(sdfTable().baseColor, ColorValue{dvec3(1)});
    o.set(sdfTable().roughness, 0.0);
    o.set(sdfTable().bounces, 4);
    return shot;
}

TEST_F(Material, GlassIsFiniteAndRefracts)
{
    for (const double morph : {0.0, 0.5, 1.0}) {
        Shot shot = glass(1.5);
        shot.values().set(sdfTable().morph, morph);
        const Picture refracted = shot.take();
        EXPECT_EQ(test::notFinite(refracted.image, 4), "");
        shot.values().set(sdfTable().material, SdfMaterial::opaque);
        EXPECT_GT(test::colorDifference(refracted, shot.take()), 0.02) << morph;
    }
}

TEST_F(Material, AnotherIndexBendsOtherwise)
{
    EXPECT_GT(test::colorDifference(glass(1.3).take(), glass(1.9).take()), 0.01);
}

TEST_F(Material, ClearGlassOfIndex1IsNotThere)
{
    // Rays go straight on without reflections, so the picture shows the probe behind the object.
    test::TemporaryFolder folder;
    const auto room = [](const dvec3& d) { return dvec3(1 + 0.7 * d.x, 1 + 0.7 * d.y, 1 + 0.7 * d.z); };
    test::writePanorama(folder / "room.hdr", room);
    Shot shot = glass(1.0);
    shot.hall().set(hallTable().environment, (folder / "room.hdr").string());
    shot.values().set(sdfTable().morph, 0.0);
    const Picture through = shot.take();
    const test::Solid solid(shot.values(), glm::dmat4(1));
    std::vector<double> errors;
    through.each([&](int x, int y) {
        // At the very edge, a ray that ends half a pixel early gets a normal that faces away from it.
        const test::Found truth = solid.trace(through.view, x, y);
        if (!truth.hit || truth.cosine < 0.15) return;
        const dvec3 ratio = through.color(x, y) / room(glm::normalize(test::pixelRay(through.view, x, y).direction));
        errors.push_back(std::max({std::abs(ratio.r - 1), std::abs(ratio.g - 1), std::abs(ratio.b - 1)}));
    });
    ASSERT_GT(errors.size(), 200U);
    std::sort(errors.begin(), errors.end());
    // Steps of 1/64 in the panorama, and the blur of the probe's second level.
    EXPECT_LT(errors[errors.size() / 2], 0.03);
    EXPECT_LT(errors.back(), 0.06);
    // Control: glass of another index is visible.
    Shot other = glass(1.5);
    other.values().set(sdfTable().morph, 0.0);
    other.hall().set(hallTable().environment, (folder / "room.hdr").string());
    EXPECT_GT(test::colorDifference(other.take(), through), 0.05);
}

/// Errors of the absorption in red glass of index 1, compared with Beer's law over the length of the path inside,
/// computed at float64: median and ninth decile of the relative errors, and the darkest pixel.
struct GlassErrors {
    double median = 0, ninth = 0, darkest = 1;
};

GlassErrors glassErrors(const dvec3& scale)
{
    Shot shot = glass(1.0);
    shot.values().set(sdfTable().morph, 0.0);
    shot.values().set(sdfTable().hitTolerance, 0.05);  // The path inside starts two tolerances below the surface.
    shot.transform(glm::scale(glm::dmat4(1), scale));
    const Picture clear = shot.take();
    const double left = 0.3;  // Transmittance of 10 cm.
    shot.values().set(sdfTable().baseColor, ColorValue{dvec3(left)});
    const Picture tinted = shot.take();
    const test::Solid solid(shot.values(), shot.worldFromExhibit());
    GlassErrors result;
    std::vector<double> errors;
    clear.each([&](int x, int y) {
        const test::Found front = solid.trace(clear.view, x, y);
        if (!front.hit || front.cosine < 0.5) return;
        const test::Ray ray = test::pixelRay(clear.view, x, y);
        const double step = 0.0005;
        double inside = 0;
        for (double t = front.distance; t < front.distance + 1.5; t += step)
            if (solid.distance(solid.toLocal(ray.origin + ray.direction * t)) < 0)
                inside += step * glm::length(ray.direction);
        const double through = tinted.luminance(x, y) / clear.luminance(x, y);
        result.darkest = std::min(result.darkest, through);
        errors.push_back(std::abs(through / std::pow(left, inside / 0.1) - 1));
    });
    EXPECT_GT(errors.size(), 100U);
    std::sort(errors.begin(), errors.end());
    result.median = errors[errors.size() / 2];
    result.ninth = errors[errors.size() * 9 / 10];
    return result;
}

TEST_F(Material, ColoredGlassDarkensWithItsDepthInTheWorldHoweverItIsScaled)
{
    for (const dvec3& scale : {dvec3(1), dvec3(1, 1, 0.1), dvec3(0.5, 2, 1)}) {
        const GlassErrors e = glassErrors(scale);
        EXPECT_LT(e.median, 0.03) << scale.x << ' ' << scale.y << ' ' << scale.z;
        EXPECT_LT(e.ninth, 0.09) << scale.x << ' ' << scale.y << ' ' << scale.z;
    }
}

TEST_F(Material, SeenAlongItsFlatSideSquashedGlassIsAsThinAsItIs)
{
    // A torus with a tube of 0.24 m, scaled to a tenth: 24 mm transmit 0.3^0.24 = 0.749 if 100 mm transmit 0.3.
    Shot shot = glass(1.0);
    shot.values().set(sdfTable().morph, 0.0);
    shot.values().set(sdfTable().hitTolerance, 0.05);
    shot.transform(glm::scale(glm::dmat4(1), dvec3(1, 1, 0.1)));
    shot.see({0, 0, 6}, {0, 0, 0});
    shot.request.frame.camera.fovY = 0.2;
    const Picture clear = shot.take();
    shot.values().set(sdfTable().baseColor, ColorValue{dvec3(0.3)});
    const Picture tinted = shot.take();
    double darkest = 1;
    int through = 0;
    clear.each([&](int x, int y) {
        // At the rim, a ray within the surface's tolerance has only half a step inside.
        if (!clear.hit(x, y) || std::abs(clear.normal(x, y).z) < 0.5) return;
        ++through;
        darkest = std::min(darkest, tinted.luminance(x, y) / clear.luminance(x, y));
    });
    EXPECT_GT(through, 200);
    EXPECT_NEAR(darkest, 0.749, 0.02);
}

Picture twin(int cells)
{
    Shot shot;
    shot.values().set(sdfTable().shownAs, SdfShown::mesh);
    shot.values().set(sdfTable().tessellation, cells);
    return shot.take();
}

TEST_F(Material, TheMeshComesNearerToTheMarchedObjectTheFinerItIs)
{
    Shot shot;
    shot.values().set(sdfTable().hitTolerance, 0.05);
    const Picture marched = shot.take();
    double last = 1e9;
    for (const int cells : {6, 16, 48, 128}) {
        const Picture mesh = twin(cells);
        double sum = 0;
        int n = 0, outline = 0;
        marched.each([&](int x, int y) {
            outline += marched.hit(x, y) != mesh.hit(x, y);
            if (!marched.hit(x, y) || !mesh.hit(x, y)) return;
            sum += std::min(std::abs(marched.depth(x, y) - mesh.depth(x, y)), 0.05);
            ++n;
        });
        EXPECT_LT(sum / n, last) << cells;
        last = sum / n;
        if (cells == 6) {
            EXPECT_GT(sum / n, 2e-3) << "so few cells must show";
        }
        if (cells == 128) {
            EXPECT_LT(sum / n, 1e-3);
            EXPECT_LT(outline, 40);
        }
    }
}

TEST_F(Material, IsOfferedBesideItsMeshWithEachAsItIsAlone)
{
    const SceneObject& subject = gallery().museum.subject(*gallery().museum.find("sdf_morph"));
    Shot shot;
    shot.values().set(sdfTable().tessellation, 24);
    const Picture marched = shot.take();
    const Picture mesh = twin(24);
    Shot other = shot;
    other.sceneState = compare::otherSide(shot.sceneState, *gallery().museum.find("sdf_morph"),
                                          compare::offeredComparison(subject, "mesh"));
    EXPECT_EQ(test::largestDifference(other.take().image, mesh.image), 0);
    EXPECT_GT(test::colorDifference(marched, mesh), 0.01) << "facets show";
    Shot back = other;
    back.sceneState = compare::otherSide(other.sceneState, *gallery().museum.find("sdf_morph"),
                                         compare::offeredComparison(subject, "field"));
    EXPECT_EQ(test::largestDifference(back.take().image, marched.image), 0);
}

TEST_F(Material, TheMeshFillsTheNormalChannelToo)
{
    const Picture mesh = twin(48);
    mesh.each([&](int x, int y) {
        if (mesh.hit(x, y)) {
            EXPECT_NEAR(glm::length(mesh.normal(x, y)), 1, 1e-3) << x << ',' << y;
        }
    });
}

TEST_F(Material, HeatMapsShowFromBlackToWhiteWhatEachPixelCosts)
{
    Shot shot;
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.frame.channels.evaluations = true;
    const Picture plain = shot.take();
    std::vector<Picture> maps;
    for (const SdfHeatMap map :
         {SdfHeatMap::steps, SdfHeatMap::evaluations, SdfHeatMap::normals, SdfHeatMap::distance}) {
        shot.values().set(sdfTable().heatMap, map);
        maps.push_back(shot.take());
        EXPECT_GT(test::colorDifference(maps.back(), plain), 0.02) << static_cast<int>(map);
        EXPECT_EQ(maps.back().hits(), plain.hits());
    }
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(test::colorDifference(maps[i], maps[j]), 0.02);

    shot.values().set(sdfTable().heatMap, SdfHeatMap::evaluations);
    shot.values().set(sdfTable().heatScale, 1.0);
    const Picture white = shot.take();
    shot.values().set(sdfTable().heatScale, 4096.0);
    const Picture black = shot.take();
    white.each([&](int x, int y) {
        if (!white.hit(x, y)) return;
        EXPECT_GT(white.luminance(x, y), 0.85);
        EXPECT_LT(black.luminance(x, y), 0.12);
    });
}

TEST_F(Material, TheNormalsMapShowsTheNormals)
{
    Shot shot;
    shot.request.frame.averageIn = AverageIn::display;
    shot.values().set(sdfTable().heatMap, SdfHeatMap::normals);
    const Picture p = shot.take();
    double worst = 0;
    p.each([&](int x, int y) {
        // Colors are stored as half floats.
        if (p.hit(x, y)) worst = std::max(worst, glm::length(p.color(x, y) - (p.normal(x, y) * 0.5 + 0.5)));
    });
    EXPECT_LT(worst, 0.002);
}

}  // namespace
}  // namespace vitrine::sdf_morph
