// The presets "Reference" must have the numbers of the published works that the exhibits follow, as read in
// their code. If our unit differs, a comment gives the conversion.

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/fur/coat.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "exhibits/lenticular/lenticular_table.h"
#include "exhibits/noise/noise_table.h"
#include "exhibits/paper_lanterns/paper_lanterns_table.h"
#include "exhibits/pixel_art/pixel_art_table.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"
#include "render/files/read_file.h"
#include "tests/support/degree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace vitrine {
namespace {

using test::degree;

ParameterValues preset(const std::string& exhibit, const std::string& file, const Parameters& table)
{
    const auto path = std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/presets" / exhibit / (file + ".json");
    const Preset read = parsePreset(render::readFile(path, presetLimits.bytes), path.string(), exhibit, table);
    EXPECT_TRUE(read.notes.empty()) << read.notes.front();
    return read.values;
}

/// Returns the number of strands per square meter of the ball for `side` cells along each side of a unit square of
/// texture coordinates.
double strandsPerArea(double side)
{
    return side * side / (4 * std::numbers::pi * fur::ballRadius * fur::ballRadius);
}

TEST(ReferencePreset, OfTheFurHasItsExportedDefaults)
{
    const fur::FurTable t;
    const ParameterValues v = preset("fur", "reference", t);
    EXPECT_EQ(v[t.shellCount], 16);
    EXPECT_EQ(v[t.distanceAttenuation], 1);  // distance_shell_density_attenuation
    EXPECT_EQ(v[t.strandRoundness], 0);
    EXPECT_EQ(v[t.tipSoftness], 0);
    EXPECT_EQ(v[t.occlusionAttenuation], 1);
    EXPECT_EQ(v[t.strength], 0.1);  // displacement_strength
    EXPECT_EQ(v[t.curvature], 1);
    EXPECT_EQ(v[t.displacementLimit], 3);                 // max_displacement
    EXPECT_NEAR(v[t.rotationLimit], 30 * degree, 1e-12);  // max_rotation_displacement_degrees
    EXPECT_EQ(v[t.inertia], 1);
    EXPECT_EQ(v[t.gravity], 10);  // (0, -10, 0), towards which the displacement settles
    EXPECT_EQ(v[t.airDrag], 5);   // displacement -= 5 x the way moved, over inertia
    EXPECT_EQ(v[t.growth], 0.1);  // radius + 0.1 sin(time)
    EXPECT_NEAR(v[t.growthRate], 1 / (2 * std::numbers::pi), 1e-6);
    EXPECT_TRUE(v[t.growing]);
    EXPECT_EQ(v[t.thicknessVariation], 0);
    EXPECT_EQ(v[t.rotationModel], fur::FurRotation::matrixMix);
    EXPECT_EQ(v[t.springModel], fur::FurSpring::explicitEuler);
    EXPECT_EQ(v[t.silhouette], fur::FurSilhouette::none);
    for (int body = 0; body < fur::furBodyCount; ++body) {
        const fur::CoatParameters rows = t.coats[static_cast<std::size_t>(body)];
        EXPECT_EQ(v[rows.length], 0.15);
        EXPECT_EQ(v[rows.uniformity], 0);                              // length_uniformity
        EXPECT_NEAR(v[rows.density] / strandsPerArea(100), 1, 0.005);  // density 100: cells along a side of the texture
        // thickness 5: at its root a strand is five half cells wide, which its cell limits to one. So it is as wide as
        // the cell.
        EXPECT_NEAR(v[rows.thickness] * std::sqrt(v[rows.density]), 1, 0.03);
    }
}

TEST(ReferencePreset, OfTheReferenceVideoHasItsScenesValues)
{
    const fur::FurTable t;
    const ParameterValues v = preset("fur", "as-in-the-reference-video", t);
    EXPECT_EQ(v[t.shellCount], 256);
    EXPECT_EQ(v[t.distanceAttenuation], 1);
    EXPECT_EQ(v[t.curvature], 1);
    EXPECT_EQ(v[t.strength], 0.1);         // displacementStrength
    EXPECT_EQ(v[t.displacementLimit], 1);  // |D| <= 1
    EXPECT_EQ(v[t.gravity], 10);           // D.y -= 10 dt
    EXPECT_EQ(v[t.occlusionAttenuation], 2.04);
    EXPECT_EQ(v[t.occlusionBias], 0);
    // shellColor (0.753, 0.542, 0.439), in sRGB.
    const auto linear = [](double c) { return std::pow((c + 0.055) / 1.055, 2.4); };
    const glm::dvec3 color(linear(0.753), linear(0.542), linear(0.439));
    for (int body = 0; body < fur::furBodyCount; ++body) {
        const fur::CoatParameters rows = t.coats[static_cast<std::size_t>(body)];
        EXPECT_EQ(v[rows.length], 0.15);
        EXPECT_EQ(v[rows.uniformity], 0);  // noiseMin 0, noiseMax 1
        EXPECT_NEAR(v[rows.density] / strandsPerArea(366), 1, 0.005);
        EXPECT_LT(glm::length(v[rows.root].value - color), 2e-3);
        EXPECT_LT(glm::length(v[rows.tip].value - color), 2e-3);
    }
}

TEST(ReferencePreset, OfTheBeamsHasItsDefaults)
{
    const crepuscular_rays::CrepuscularRaysTable t;
    const ParameterValues v = preset("crepuscular_rays", "reference", t);
    EXPECT_EQ(v[t.samples], 128);  // NUM_SAMPLES
    EXPECT_EQ(v[t.decay], 0.5);
    EXPECT_EQ(v[t.weight], 0.1);
    EXPECT_EQ(v[t.density], 1);                            // The whole ray.
    EXPECT_EQ(v[t.rayExposure], 0);                        // No exposure.
    EXPECT_EQ(v[t.sum], crepuscular_rays::RaySum::plain);  // Not divided by the samples.
    EXPECT_EQ(v[t.method], crepuscular_rays::RayMethod::loop);
    EXPECT_EQ(v[t.technique], crepuscular_rays::RayTechnique::screen);
    EXPECT_EQ(v[t.resolution], crepuscular_rays::RayResolution::full);
    EXPECT_EQ(v[t.mask], crepuscular_rays::RayMask::depth);
    EXPECT_EQ(v[t.threshold], 0);  // a mask of 0 and 1
    EXPECT_FALSE(v[t.skyColor]);
    EXPECT_FALSE(v[t.jitter]);
    EXPECT_EQ(v[t.tint].value, glm::dvec3(1));
}

TEST(ReferencePreset, OfTheCardHasItsUniforms)
{
    const lenticular::LenticularTable t;
    const ParameterValues v = preset("lenticular", "reference", t);
    EXPECT_EQ(v[t.views], 16);  // IMAGE_COUNT
    EXPECT_EQ(v[t.slices], 10);
    EXPECT_EQ(v[t.magnification], 1);                        // lenticular_magnification
    EXPECT_NEAR(std::tan(v[t.intendedMaxAngle]), 1, 1e-12);  // intended_max_angle 1, a tangent
    EXPECT_EQ(v[t.model], lenticular::CardModel::linear);
    EXPECT_EQ(v[t.strips], lenticular::CardStrips::squeezed);
    EXPECT_EQ(v[t.axis], lenticular::CardAxis::vertical);
    EXPECT_FALSE(v[t.prefilter]);
    EXPECT_FALSE(v[t.dispersion]);
    EXPECT_EQ(v[t.apertureSamples], 1);
    EXPECT_TRUE(v[t.scroll]);
}

TEST(ReferencePreset, OfThePixelArtHasItsStrengths)
{
    const pixel_art::PixelArtTable t;
    const ParameterValues v = preset("pixel_art", "reference", t);
    EXPECT_EQ(v[t.highlightStrength], 0.1);
    EXPECT_EQ(v[t.outlineStrength], 0.4);
    EXPECT_EQ(v[t.highlightColor].value, glm::dvec3(1));
    EXPECT_EQ(v[t.outlineColor].value, glm::dvec3(0));
    EXPECT_EQ(v[t.edges], pixel_art::EdgeLook::reference);
    EXPECT_EQ(v[t.method], pixel_art::NormalsBy::tap9Plus);
    EXPECT_EQ(v[t.resolution], pixel_art::PixelResolution::r240);
    EXPECT_EQ(v[t.projection], pixel_art::PixelProjection::orthographic);
    EXPECT_EQ(v[t.world], pixel_art::PixelWorld::testScene);
    EXPECT_TRUE(v[t.fixVoid]);
}

TEST(ReferencePreset, OfTheNoiseHasItsConstants)
{
    const noise::NoiseTable t;
    const ParameterValues sum = preset("noise", "reference-fractal-sum", t);
    EXPECT_EQ(sum[t.kind], noise::NoiseKind::value);
    EXPECT_EQ(sum[t.frequency], 1);
    EXPECT_EQ(sum[t.stepLimit], 256);
    EXPECT_EQ(sum[t.drift], -1);  // The camera moves forward by a unit per second.
    // fbm - 0.35, with octaves that begin at 0.5: (0.484 - 0.35) / 0.484. This noise is solid above the threshold.
    EXPECT_NEAR(sum[t.threshold], (0.484375 - 0.35) / 0.484375, 1e-3);
    EXPECT_EQ(sum[t.octaves], 5);
    EXPECT_EQ(sum[t.gain], 0.5);
    EXPECT_EQ(sum[t.lacunarity], 2);
    EXPECT_EQ(sum[t.octaveRotation], 0);
    const ParameterValues sea = preset("noise", "reference-sea", t);
    EXPECT_EQ(sea[t.work], noise::NoiseWork::sea);
    EXPECT_EQ(sea[t.stepLimit], 100);
    for (const ParameterValues& v : {sum, sea}) EXPECT_EQ(v[t.look], noise::NoiseLook::reference);
}

TEST(ReferencePreset, OfThePaperLanternsHasItsNumbers)
{
    const paper_lanterns::PaperLanternsTable t;
    const ParameterValues v = preset("paper_lanterns", "reference", t);
    EXPECT_EQ(v[t.look], paper_lanterns::LakeLook::reference);
    EXPECT_EQ(v[t.paperRadius], 0.75);
    EXPECT_EQ(v[t.paperHeight], 2);
    EXPECT_EQ(v[t.paperWall], 0.06);  // A shell of 0.03 to each side.
    EXPECT_EQ(v[t.baseWidth], 2.2);   // half extents 1.1, 0.04, 1.1
    EXPECT_EQ(v[t.baseThickness], 0.08);
    EXPECT_EQ(v[t.ringWire], 0.05);
    EXPECT_EQ(v[t.lowRing], 0.08);
    EXPECT_EQ(v[t.postWire], 0.05);
    EXPECT_EQ(v[t.frameBlend], 0.1);
    EXPECT_EQ(v[t.waveHeight], 1);
    EXPECT_EQ(v[t.waveSpeed], paper_lanterns::LakeSpeed::reference);      // 2.5 radians a second for all waves.
    EXPECT_EQ(v[t.ride], paper_lanterns::LakeRide::reference);            // waterHeightRoughAt
    EXPECT_EQ(v[t.flickerPhase], paper_lanterns::LakeFlicker::together);  // Depends on TIME only.
    EXPECT_EQ(v[t.repetition], paper_lanterns::LakeRepetition::twoByTwo);
    EXPECT_EQ(v[t.turned], 0);
    EXPECT_EQ(v[t.flameHeight], 1);  // local y 0
    EXPECT_TRUE(v[t.animate]);
}

TEST(ReferencePreset, OfTheTorusMugHasItsConstants)
{
    const sdf_morph::SdfMorphTable t;
    const ParameterValues v = preset("sdf_morph", "reference", t);
    EXPECT_EQ(v[t.morph], 0);            // morph_progress
    EXPECT_EQ(v[t.stepLimit], 100);      // MAX_STEPS
    EXPECT_EQ(v[t.normalStep], 0.0005);  // GRADIENT_DT
    EXPECT_EQ(v[t.normalMethod], SdfNormal::central);
    EXPECT_EQ(v[t.relaxation], SdfRelaxation::none);
    EXPECT_EQ(v[t.bounces], 0);  // It cannot reflect itself.
    EXPECT_EQ(v[t.shadowMethod], SdfShadow::none);
    EXPECT_FALSE(v[t.conePrepass]);
    EXPECT_TRUE(v[t.animate]);  // To the mug and back.
    // EPSILON is 0.001 m in the reference. This tolerance is in pixels, and stays at half a pixel.
    EXPECT_EQ(v[t.hitTolerance], 1);
}

/// Returns the linear light (IEC 61966-2-1) of the reference's numbers, which it displays without a gamma curve.
glm::dvec3 linear(const glm::dvec3& shown)
{
    glm::dvec3 light;
    for (int i = 0; i < 3; ++i)
        light[i] = shown[i] <= 0.04045 ? shown[i] / 12.92 : std::pow((shown[i] + 0.055) / 1.055, 2.4);
    return light;
}

TEST(ReferencePreset, OfTheIceCreamHasItsPlacesAndMaterials)
{
    const ice_cream::IceCreamTable t;
    const ParameterValues v = preset("ice_cream", "reference", t);
    EXPECT_EQ(v[t.drawnOver], SdfDrawnOver::picture);  // Two triangles that cover the picture.
    const glm::dvec3 red(0.9451, 0.1324, 0.1216), green(0.1397, 0.9288, 0.0943), blue(0.1307, 0.3043, 0.9451),
        yellow(0.9670, 0.9451, 0.0642), pink(0.8431, 0.3485, 0.5084);
    const std::pair<glm::dvec3, glm::dvec3> candies[]{
        {{0.12, 1, 0.16}, red},          {{0.06, 1.2, -0.08}, green},
        {{-0.16, 0.9, 0.11}, blue},      {{-0.2, 0.84, -0.2}, yellow},
        {{-0.0745, 1.1, -0.1365}, pink},  // Moved out of the cream; see the table.
        {{0.168, 0.95, -0.156}, yellow}, {{0.01, 0.94, 0.19}, red},
        {{0.5, 1, 0.866}, green},        {{-1, 0.8, 0}, pink},
        {{0.5, 1.2, -0.866}, blue}};
    for (std::size_t i = 0; i < ice_cream::candyCount; ++i) {
        const ice_cream::CandyParameters& candy = t.candies[i];
        EXPECT_EQ(glm::dvec3(v[candy.x], v[candy.y], v[candy.z]), candies[i].first) << i;
        EXPECT_LT(glm::distance(v[candy.color].value, linear(candies[i].second)), 2e-4) << i;
        EXPECT_EQ(glm::dvec3(v[candy.halfX], v[candy.halfY], v[candy.halfZ]), glm::dvec3(0.02, 0.03, 0.01)) << i;
        EXPECT_EQ(v[candy.corner], 0.007) << i;
    }
    EXPECT_LT(glm::distance(v[t.waferColor].value, linear({0.8627, 0.6510, 0.3255})), 2e-4);
    for (const ice_cream::CreamParameters& layer : t.layers)
        EXPECT_LT(glm::distance(v[layer.color].value, linear({0.9255, 0.9294, 0.8510})), 2e-4);
    EXPECT_LT(glm::distance(v[t.groundColor].value, linear(glm::dvec3(0.9451))), 2e-4);
    EXPECT_EQ(v[t.waferRoughness], 1);
    EXPECT_EQ(v[t.creamRoughness], 0.25);
    EXPECT_EQ(v[t.candyRoughness], 0.65);
    EXPECT_EQ(v[t.highlight], ice_cream::IceCreamHighlight::blinnPhong);
    EXPECT_EQ(v[t.referenceSun].value, glm::normalize(glm::dvec3(-16, 12, 4)));
    EXPECT_LT(glm::distance(v[t.referenceSunColor].value * v[t.referenceSunStrength], glm::dvec3(1, 0.7, 0.5) / 1.2),
              1e-9);
    EXPECT_EQ(v[t.referenceAmbient].value, glm::dvec3(0.2, 0.1, 0));
    EXPECT_EQ(v[t.referenceFog], 0.0005);
    EXPECT_EQ(v[t.occlusionTaps], 5);
    EXPECT_EQ(v[t.shadowMethod], SdfShadow::improved);
    EXPECT_NEAR(std::tan(0.5 * v[t.sunWidth]), 1.0 / 32, 1e-9);  // 32 d / t
    EXPECT_EQ(v[t.stepLimit], 128);
    EXPECT_EQ(v[t.lighting], ice_cream::IceCreamLighting::reference);
    EXPECT_NEAR(v[t.orbitSpeed] * 2 * std::numbers::pi, 0.1, 1e-12);
    EXPECT_EQ(v[t.size], 1);
}

}  // namespace
}  // namespace vitrine
