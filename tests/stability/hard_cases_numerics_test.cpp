// Arithmetic that all exhibits depend on. Each test first shows the failure of the plain formula.

#include "exhibits/sdf_morph/sdf_morph.h"
#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/stability/fields.h"
#include "tests/stability/flush_to_zero.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace vitrine {
namespace {

using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;

TEST(HardCases, TotalReflectionIsAllTheLightAndNoDirectionIsNaN)
{
    // From glass into air. refract() has no result beyond the critical angle.
    const vec3 normal(0, 1, 0);
    int total = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double sine = i / 2000.0;
        const double cosine = std::sqrt(1 - sine * sine);
        const vec3 ray(float(sine), float(-cosine), 0);
        const vec3 through = glm::refract(ray, normal, 1.5F);
        const float mirrored = f32::fresnelDielectric(float(cosine), 1 / 1.5F);
        if (through == vec3(0)) {
            ++total;
            EXPECT_FLOAT_EQ(glm::length(glm::reflect(ray, normal)), 1);
            if (1.5 * sine > 1 + 1e-6) {
                EXPECT_EQ(mirrored, 1);
            }
            continue;
        }
        EXPECT_NEAR(glm::length(through), 1, 1e-5);
        // Transmitted light from the amplitudes of the two polarizations (Fresnel 1823), and not as 1 - R.
        const double behind = std::sqrt(std::max(1 - 2.25 * sine * sine, 0.0));
        const double s = 2 * 1.5 * cosine / (1.5 * cosine + behind);
        const double p = 2 * 1.5 * cosine / (cosine + 1.5 * behind);
        const double transmitted = behind / (1.5 * cosine) * 0.5 * (s * s + p * p);
        EXPECT_NEAR(f64::fresnelDielectric(cosine, 1 / 1.5) + transmitted, 1, 1e-5) << sine;
        EXPECT_GE(mirrored, 0);
        EXPECT_LE(mirrored, 1);
    }
    EXPECT_GT(total, 600);
}

TEST(HardCases, ADayLaterTimeStillMovesSixtyTimesASecond)
{
    // Around a million seconds, a float has steps of a sixteenth of a second.
    std::set<float> naive;
    std::set<double> ours;
    std::set<float> oursAsUniform;
    for (int frame = 0; frame < 60; ++frame) {
        const double time = 1e6 + frame / 60.0;
        naive.insert(static_cast<float>(time));
        ours.insert(sdf_morph::morphAt(0.3, 0.08, time));
        oursAsUniform.insert(static_cast<float>(sdf_morph::morphAt(0.3, 0.08, time)));
    }
    EXPECT_LT(naive.size(), 20U);
    EXPECT_EQ(ours.size(), 60U);
    EXPECT_EQ(oursAsUniform.size(), 60U);
    // After a whole number of periods (12.5 s at 0.08 Hz) the value is the same.
    for (const double time : {0.1, 3.7, 12.0})
        EXPECT_NEAR(sdf_morph::morphAt(0.3, 0.08, 1e6 + time), sdf_morph::morphAt(0.3, 0.08, time), 1e-9);
}

TEST(HardCases, NumbersThatGpusFlushToZeroMakeNoDifference)
{
    if (!test::canFlushToZero()) GTEST_SKIP() << "this processor keeps denormal numbers";
    // A product below the normal range: GPUs flush it to zero, CPUs do not.
    volatile float tiny = 1e-20F;
    EXPECT_NE(tiny * tiny, 0);
    {
        const test::FlushToZero asOnTheGpu;
        EXPECT_EQ(tiny * tiny, 0);
    }
    // Sizes and distances of this magnitude, in all functions that divide by values which may underflow.
    const auto answers = [&] {
        std::vector<float> found;
        const float t = tiny;
        for (const float k : {t, t * t, 1e-38F, 1e-45F}) {
            found.push_back(f32::sdfSmoothUnion(0.5F, 0.5F + k, k));
            found.push_back(f32::sdfSmoothUnionExponential(0.5F, 0.5F, k));
            found.push_back(f32::sdfCapsule(vec3(1), vec3(0), vec3(k, 0, 0), 0.2F));
            found.push_back(f32::sdfEllipsoid(vec3(1, 0.5F, 0), vec3(k, 1, 1)));
            found.push_back(f32::sdfCappedCone(vec3(1, 0.5F, 0), k, k, 0.2F));
            found.push_back(f32::sdfTriangle(vec3(1), vec3(0), vec3(k, 0, 0), vec3(0, k, 0)));
            found.push_back(f32::safeNormalize(vec3(k, 0, 0), vec3(0, 1, 0)).y);
            found.push_back(f32::smoothStep(0, k, 0.5F));
            found.push_back(f32::powPositive(k, 0.5F) < 1e-9F ? 0.0F : 1.0F);
        }
        return found;
    };
    const std::vector<float> kept = answers();
    std::vector<float> flushed;
    {
        const test::FlushToZero asOnTheGpu;
        flushed = answers();
    }
    ASSERT_EQ(kept.size(), flushed.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        EXPECT_TRUE(std::isfinite(kept[i]) && std::isfinite(flushed[i])) << i;
        EXPECT_NEAR(kept[i], flushed[i], 1e-6) << i;
    }
}

TEST(HardCases, HalfGrayIsEncodedOnceOnItsWayToAFileAndBack)
{
    const auto twice = [](double linear) { return render::srgbFromLinear(render::srgbFromLinear(linear)); };
    const double linear = render::linearFromSrgb(128 / 255.0);
    EXPECT_GT(std::abs(255 * twice(linear) - 128), 50);  // Encoded twice.
    EXPECT_GT(std::abs(255 * linear - 128), 50);         // Never encoded.

    const test::TemporaryFolder folder;
    const render::Image gray(4, 4, 3, static_cast<float>(linear));
    for (const auto& [name, format] :
         {std::pair("a.png", render::PictureFormat::png8), std::pair("b.png", render::PictureFormat::png16),
          std::pair("c.tif", render::PictureFormat::tiff8)}) {
        render::writePicture(folder / name, gray, format);
        EXPECT_NEAR(render::readImage(folder / name, {.raw = true}).at(1, 1, 0) * 255, 128, 1) << name;
        EXPECT_NEAR(render::readImage(folder / name).at(1, 1, 0), linear, linear * 0.01) << name;
    }
    render::writePicture(folder / "d.exr", gray, render::PictureFormat::exr);
    EXPECT_EQ(render::readImage(folder / "d.exr").at(1, 1, 0), static_cast<float>(linear));
}

}  // namespace
}  // namespace vitrine
