// Pictures of the works behind the noise frame, compared with the same noise at float64 and with each other.

#include "exhibits/noise/noise_scene.h"
#include "exhibits/study/study_picture.h"
#include "render/glsl/cpu.h"
#include "tests/support/gallery.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine::noise {
namespace {

using namespace test;
using glm::dvec3;

/// Small picture of one work, alone.
struct WorkShot : ExhibitShot<NoiseTable> {
    explicit WorkShot(NoiseWork work, NoiseLook look = NoiseLook::physical) : ExhibitShot("noise")
    {
        size(96, 60);
        set(table().work, work).set(table().look, look);
    }
};

const NoiseTable& noiseTable()
{
    return WorkShot::table();
}

class NoiseWorks : public GlTest {};

constexpr NoiseWork allWorks[] = {NoiseWork::field, NoiseWork::fractal, NoiseWork::sea, NoiseWork::clouds};

TEST_F(NoiseWorks, AreFourThatDifferAndMove)
{
    for (const NoiseLook look : {NoiseLook::physical, NoiseLook::reference}) {
        std::vector<Picture> pictures;
        for (const NoiseWork work : allWorks) {
            WorkShot shot(work, look);
            pictures.push_back(shot.take());
            EXPECT_GT(pictures.back().mean(), 0.01);
            shot.values().set(noiseTable().moment, 3.0);
            EXPECT_GT(colorDifference(pictures.back(), shot.take()), 1e-4) << static_cast<int>(work);
        }
        for (std::size_t i = 0; i < pictures.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) EXPECT_GT(colorDifference(pictures[i], pictures[j]), 1e-3);
    }
}

TEST_F(NoiseWorks, StayFiniteAtAnyTimeAndPlace)
{
    for (const NoiseLook look : {NoiseLook::physical, NoiseLook::reference})
        for (const NoiseWork work : allWorks)
            for (const double moment : {0.0, 1e6, -1e6}) {
                WorkShot shot(work, look);
                shot.values().set(noiseTable().moment, moment);
                shot.values().set(noiseTable().distance, 1e7);
                shot.values().set(noiseTable().sunElevation, moment > 0 ? -0.08 : 1.5);
                EXPECT_EQ(notFinite(shot.take().image, 4), "") << static_cast<int>(work) << ' ' << moment;
            }
}

/// Returns the threshold minus the sum of octaves at float64, positive in the empty space that is kept around the eye.
/// `block` gives the offset of the octaves.
double outsideAt(const ParameterValues& values, const NoiseBlock& block, const dvec3& p, double clear)
{
    const auto kind = static_cast<int>(values[noiseTable().kind]);
    const auto seed = static_cast<glm::uint>(values[noiseTable().seed]);
    const glm::dmat3 turn = glsl::noiseRotation(values[noiseTable().octaveRotation]) * values[noiseTable().lacunarity];
    glm::dmat3 domain(values[noiseTable().frequency]);
    double amplitude = 1.0 / static_cast<double>(block.amplitudes), sum = 0;
    for (int i = 0; i < block.octaves; ++i) {
        const auto octave = static_cast<std::size_t>(i);
        sum += amplitude * glsl::noiseNear(kind, domain * p, glm::ivec3(block.cells[octave]),
                                           dvec3(block.places[octave]), glm::ivec3(FIELD_REPEAT), seed)
                               .value;
        domain = turn * domain;
        amplitude *= values[noiseTable().gain];
    }
    return values[noiseTable().threshold] - sum + clear;
}

/// Comparison of a picture of the field's distances with small uniform steps and bisection at float64, which need no
/// bound.
struct FieldCheck {
    int checked = 0, missed = 0, early = 0;
};

FieldCheck checkField(WorkShot& shot)
{
    const NoiseBlock block = noiseBlock(noiseTable(), shot.values(), 0, {0, 1, 0}, 0);
    const Picture p = shot.take();
    FieldCheck check;
    for (int y = 2; y < p.height(); y += 5)
        for (int x = 2; x < p.width(); x += 5) {
            const dvec3 ray = p.view.direction(
                glm::dvec2(x + 0.5, p.height() - y - 0.5) / glm::dvec2(p.width(), p.height()) * 2.0 - 1.0);
            const dvec3 d = glm::normalize(ray);
            const double start = p.view.nearPlane * glm::length(ray);
            const double seen = std::min(p.depth(x, y) * glm::length(ray), 1e9);
            for (double t = start + 0.02; t < 12; t += 0.002) {
                const double clear = std::clamp(1.4 - (t - start) / 6, 0.0, 1.0);
                if (outsideAt(shot.values(), block, p.view.eye + d * t, clear) > 0) continue;
                ++check.checked;
                check.missed += seen > 1.01 * t;
                check.early += seen < 0.99 * t;
                break;
            }
        }
    return check;
}

WorkShot exactShot(NoiseWork work)
{
    WorkShot shot(work);
    shot.values().set(noiseTable().boundShare, 1.0);
    shot.values().set(noiseTable().stepLimit, 1024);
    shot.values().set(noiseTable().hitTolerance, 0.05);
    // All octaves are resolved: fading with the distance would change the sum.
    shot.values().set(noiseTable().octaves, 3);
    return shot;
}

TEST_F(NoiseWorks, TheFieldIsWhereTheNoiseAtFloat64CrossesItsThreshold)
{
    for (const NoiseLookup lookup : {NoiseLookup::evaluated, NoiseLookup::baked})
        for (const NoiseKind kind : {NoiseKind::value, NoiseKind::gradient, NoiseKind::simplex}) {
            WorkShot shot = exactShot(NoiseWork::field);
            shot.values().set(noiseTable().kind, kind);
            shot.values().set(noiseTable().fieldNoise, lookup);
            const FieldCheck check = checkField(shot);
            EXPECT_GT(check.checked, 100);
            EXPECT_EQ(check.missed, 0) << static_cast<int>(kind);
            // A grazing ray may end within its tolerance.
            EXPECT_LE(check.early, 0.03 * check.checked) << static_cast<int>(kind);
        }
}

TEST_F(NoiseWorks, NoRayPassesThroughTheSumOfOctavesByTheWholeBounds)
{
    for (const NoiseSumKind sum : {NoiseSumKind::fbm, NoiseSumKind::ridged}) {
        WorkShot shot = exactShot(NoiseWork::fractal);
        shot.values().set(noiseTable().sum, sum);
        if (sum == NoiseSumKind::fbm) {
            const FieldCheck check = checkField(shot);
            EXPECT_GT(check.checked, 100);
            EXPECT_EQ(check.missed, 0);
            EXPECT_LE(check.early, 0.05 * check.checked);
        }
        shot.values().set(noiseTable().fieldNoise, NoiseLookup::evaluated);
        const Picture evaluated = shot.take();
        shot.values().set(noiseTable().fieldNoise, NoiseLookup::baked);
        const Picture baked = shot.take();
        int off = 0;
        baked.each([&](int x, int y) { off += std::abs(baked.depth(x, y) / evaluated.depth(x, y) - 1) > 0.01; });
        EXPECT_LT(off, 0.02 * 96 * 60) << static_cast<int>(sum);
    }
    // Control: a tenth of the bound misses surfaces.
    WorkShot shot = exactShot(NoiseWork::fractal);
    shot.values().set(noiseTable().boundShare, 0.1);
    EXPECT_GT(checkField(shot).missed, 0);
}

TEST_F(NoiseWorks, OfTheDerivativeHasTheNormalsOfDifferences)
{
    for (const NoiseWork work : {NoiseWork::field, NoiseWork::fractal}) {
        WorkShot shot(work);
        shot.values().set(noiseTable().haze, 0.0);
        if (work == NoiseWork::fractal) shot.values().set(noiseTable().warp, 0.5);
        const Picture derivative = shot.take();
        shot.values().set(noiseTable().normals, NoiseNormal::differences);
        const Picture differences = shot.take();
        int compared = 0;
        double sum = 0;
        derivative.each([&](int x, int y) {
            if (derivative.depth(x, y) > 10) return;
            ++compared;
            sum += 1 - glm::dot(derivative.normal(x, y), differences.normal(x, y));
        });
        EXPECT_GT(compared, 300);
        EXPECT_LT(sum / compared, work == NoiseWork::field ? 2e-3 : 0.05) << static_cast<int>(work);
    }
}

/// Returns the share of the surface between 9 and 14 m, behind the space that is kept free around the eye, at which the
/// noise at float64 differs from its threshold.
double shareOff(double distance)
{
    WorkShot shot(NoiseWork::field);
    const double frequency = shot.values()[noiseTable().frequency];
    shot.values().set(noiseTable().distance, distance);
    shot.values().set(noiseTable().boundShare, 1.0);
    shot.values().set(noiseTable().stepLimit, 1024);
    shot.values().set(noiseTable().hitTolerance, 0.05);
    const Picture p = shot.take();
    int surface = 0, off = 0;
    p.each([&](int x, int y) {
        const dvec3 ray =
            p.view.direction(glm::dvec2(x + 0.5, p.height() - y - 0.5) / glm::dvec2(p.width(), p.height()) * 2.0 - 1.0);
        const double t = p.depth(x, y) * glm::length(ray);
        if (!(t > 9 && t < 14)) return;
        ++surface;
        const dvec3 at = frequency * (p.view.eye + ray * p.depth(x, y) + dvec3(distance, 0, 0));
        const dvec3 base = glm::floor(at);
        const double n = glsl::gradientNoise(glm::ivec3(base), at - base, glm::ivec3(FIELD_REPEAT), 1).value;
        off += std::abs(n - shot.values()[noiseTable().threshold]) > 0.02;
    });
    EXPECT_GT(surface, 300);
    return static_cast<double>(off) / surface;
}

TEST_F(NoiseWorks, OfTheFieldAreAsSharpTenThousandKilometersFromTheOrigin)
{
    EXPECT_LT(shareOff(0), 0.01);
    EXPECT_LT(shareOff(1e7), 0.01);
}

/// Returns the height of tall waves over a place at float64. The origin of that water is found by iteration.
double tallHeight(const NoiseBlock& block, double chop, const glm::dvec2& p)
{
    glm::dvec2 moved(0);
    double height = 0;
    for (int k = 0; k < 24; ++k) {
        const glm::dvec2 q = p - moved;
        moved = glm::dvec2(0);
        height = 0;
        for (int i = 0; i < block.tallWaves; ++i) {
            const glm::dvec4 w(block.wave[static_cast<std::size_t>(i)]);
            const glm::dvec2 vector(w);
            const double phase = glm::dot(vector, q) - w.w;
            moved -= vector / glm::length(vector) * (chop * w.z * std::sin(phase));
            height += w.z * std::cos(phase);
        }
    }
    return height;
}

TEST_F(NoiseWorks, TheSeaIsWhereItsWavesAtFloat64Are)
{
    for (const double wind : {7.5, 18.0})
        for (const double share : {0.45, 1.0}) {
            WorkShot shot(NoiseWork::sea);
            shot.values().set(noiseTable().windSpeed, wind);
            shot.values().set(noiseTable().eyeHeight, wind);
            shot.values().set(noiseTable().boundShare, share);
            shot.values().set(noiseTable().seaSteps, 256);
            shot.values().set(noiseTable().hitTolerance, 0.05);
            const NoiseBlock block = noiseBlock(noiseTable(), shot.values(), 0, {0, 1, 0}, 0);
            const Picture p = shot.take();
            int checked = 0, missed = 0, early = 0;
            for (int y = p.height() / 2 + 3; y < p.height(); y += 2)
                for (int x = 1; x < p.width(); x += 3) {
                    const dvec3 ray = p.view.direction(
                        glm::dvec2(x + 0.5, p.height() - y - 0.5) / glm::dvec2(p.width(), p.height()) * 2.0 - 1.0);
                    const dvec3 d = glm::normalize(ray);
                    const dvec3 eye = p.view.eye + dvec3(0, wind, 0);
                    const double seen = std::min(p.depth(x, y) * glm::length(ray), 1e9);
                    // Farther waves fade, by less than a pixel.
                    for (double t = wind; t < 8 * wind; t += 0.0015 * wind) {
                        const dvec3 at = eye + d * t;
                        if (at.y > block.seaTop) continue;
                        if (at.y > tallHeight(block, shot.values()[noiseTable().chop], {at.x, at.z})) continue;
                        ++checked;
                        missed += seen > 1.004 * t + 0.02;
                        early += seen < 0.996 * t - 0.03;
                        break;
                    }
                }
            EXPECT_GT(checked, 200) << wind;
            EXPECT_EQ(missed, 0) << wind << ", " << share;
            // If the water is steeper than the reduced bound, a grazing ray may end on a crest.
            EXPECT_LE(early, share < 1 ? 0.01 * checked : 0) << wind << ", " << share;
        }
}

TEST_F(NoiseWorks, OfTheSeaMeetTheHorizonWhereItIs)
{
    WorkShot shot(NoiseWork::sea);
    shot.values().set(noiseTable().windSpeed, 2.0);
    const Picture p = shot.take();
    int wrong = 0;
    p.each([&](int x, int y) {
        const double up = 1 - 2 * (y + 0.5) / p.height();
        if (std::abs(up) < 0.06) return;
        wrong += (p.depth(x, y) < 1e6) != (up < 0);
    });
    EXPECT_EQ(wrong, 0);
}

/// Returns the mean change per pixel and channel, as displayed, if the view moves by a pixel.
double shimmer(NoiseWork work, int samples)
{
    WorkShot shot(work);
    shot.request.frame.raster.size = {160, 100};
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.samples = samples;
    const Picture before = shot.take();
    shot.request.frame.camera.lensShift.y = 2 * before.view.tanHalfFov.y / before.height();
    const Picture after = shot.take();
    double sum = 0;
    before.each([&](int x, int y) { sum += glm::length(after.color(x, y) - before.color(x, y)); });
    return sum / (before.width() * before.height());
}

TEST_F(NoiseWorks, ShimmerLittleMoreWithOneSampleThanWith64)
{
    EXPECT_LT(shimmer(NoiseWork::sea, 1), 1.5 * shimmer(NoiseWork::sea, 64));
    EXPECT_LT(shimmer(NoiseWork::field, 1), 1.5 * shimmer(NoiseWork::field, 64));
    EXPECT_LT(shimmer(NoiseWork::fractal, 1), 1.5 * shimmer(NoiseWork::fractal, 64));
    EXPECT_LT(shimmer(NoiseWork::clouds, 1), 1.5 * shimmer(NoiseWork::clouds, 64));
}

TEST_F(NoiseWorks, OfTheCloudsAreAsBrightWithAnyNumberOfSteps)
{
    const auto meanWith = [](int steps, NoiseMarch march) {
        WorkShot shot(NoiseWork::clouds);
        shot.values().set(noiseTable().cloudSteps, steps);
        shot.values().set(noiseTable().bakeSize, 64);
        shot.values().set(noiseTable().march, march);
        shot.request.samples = 8;
        return shot.take().mean();
    };
    const double fine = meanWith(512, NoiseMarch::bounded);
    for (const int steps : {64, 96, 128, 256})
        EXPECT_NEAR(meanWith(steps, NoiseMarch::bounded) / fine, 1, 0.005) << steps;
    // Control: a plain sum of uniform steps does not.
    EXPECT_GT(std::abs(meanWith(64, NoiseMarch::halved) / fine - 1), 0.01);
}

TEST_F(NoiseWorks, OfCloudsAtRestConvergeAndOweNothingToWhatWasDrawnBefore)
{
    WorkShot shot(NoiseWork::clouds);
    shot.values().set(noiseTable().bakeSize, 64);
    const auto with = [&](int samples) {
        shot.request.samples = samples;
        return shot.take();
    };
    const Picture fine = with(64), one = with(1);
    EXPECT_LT(colorDifference(with(16), fine), 0.5 * colorDifference(one, fine));
    // A cut to another view, and back.
    shot.request.frame.camera.eye.x += 0.5;
    EXPECT_GT(colorDifference(with(1), one), 0);
    shot.request.frame.camera.eye.x -= 0.5;
    EXPECT_EQ(colorDifference(with(1), one), 0);
}

TEST_F(NoiseWorks, OfBakedCloudsComeNearerToTheEvaluatedOnesTheFinerTheVolumeIs)
{
    WorkShot shot(NoiseWork::clouds);
    shot.request.frame.raster.size = {48, 30};
    shot.values().set(noiseTable().cloudNoise, NoiseLookup::evaluated);
    const Picture evaluated = shot.take();
    shot.values().set(noiseTable().cloudNoise, NoiseLookup::baked);
    double last = 1;
    for (const int size : {16, 48, 160}) {
        shot.values().set(noiseTable().bakeSize, size);
        const double error = colorDifference(evaluated, shot.take());
        EXPECT_LT(error, last) << size;
        last = error;
    }
    EXPECT_LT(last, 0.05);
}

// The steps towards the sun are those of one integral: its integrand does not depend on their number.
TEST_F(NoiseWorks, OfCloudsHaveTheSameLightInFewStepsTowardsTheSun)
{
    WorkShot shot(NoiseWork::clouds);
    shot.request.frame.raster.size = {96, 60};
    shot.values().set(noiseTable().bakeSize, 64);
    shot.values().set(noiseTable().jitter, false);
    const auto with = [&](int count) {
        shot.values().set(noiseTable().lightSteps, count);
        return shot.take();
    };
    const double fine = with(64).mean();
    EXPECT_NEAR(with(8).mean() / fine, 1, 0.025);
    EXPECT_GT(with(2).mean() / fine, 1.05) << "control";
}

/// Clouds with counted lookups of noise.
struct CloudShot : WorkShot {
    CloudShot() : WorkShot(NoiseWork::clouds) { request.frame.channels.evaluations = true; }
    Picture with(NoiseMarch march, int steps, double tolerance)
    {
        set(table().march, march).set(table().cloudSteps, steps).set(table().cloudTolerance, tolerance);
        return take();
    }
    Picture exact()
    {
        set(table().jitter, false).set(table().lightSteps, 64);
        const Picture picture = with(NoiseMarch::bounded, 512, 0);
        set(table().jitter, true).set(table().lightSteps, table().initial()[table().lightSteps]);
        return picture;
    }
};

/// Returns the difference of a pixel of two pictures as a share of white.
glm::dvec3 shownDifference(const Picture& a, const Picture& b, int x, int y)
{
    const auto shown = [](const glm::dvec3& radiance) { return radiance / (1.0 + radiance); };
    return shown(a.color(x, y)) - shown(b.color(x, y));
}

/// Returns the root of the mean of its square.
double shownError(const Picture& a, const Picture& b)
{
    double sum = 0;
    a.each([&](int x, int y) {
        const glm::dvec3 away = shownDifference(a, b, x, y);
        sum += glm::dot(away, away) / 3;
    });
    return std::sqrt(sum / (a.width() * a.height()));
}

std::int64_t lookups(const Picture& picture)
{
    return study::channelTotal(picture.image, "evaluations");
}

// For the same error, strides that are short in clouds and long between them take less than half of the lookups of
// equal steps; interpolation where clouds are smooth leaves less than a fifth of them.
TEST_F(NoiseWorks, OfCloudsCostLessThanAFifthOfEqualSteps)
{
    CloudShot shot;
    shot.size(640, 360);
    const ParameterValues initial = noiseTable().initial();
    const int steps = initial[noiseTable().cloudSteps];
    const Picture fine = shot.exact();
    const Picture equal = shot.with(NoiseMarch::halved, 4 * steps, 0);
    const Picture marched = shot.with(NoiseMarch::bounded, 5 * steps / 4, 0);
    const Picture interpolated = shot.with(NoiseMarch::bounded, 5 * steps / 4, initial[noiseTable().cloudTolerance]);
    const double error = shownError(equal, fine);
    EXPECT_LE(shownError(marched, fine), error);
    EXPECT_LE(shownError(interpolated, fine), error);
    EXPECT_LT(lookups(marched), lookups(equal) / 2);
    EXPECT_LT(lookups(interpolated), lookups(equal) / 5);
}

// Clouds that are interpolated between rays differ from marched ones by less than the tolerance.
TEST_F(NoiseWorks, OfCloudsBetweenRaysStayWithinTheTolerance)
{
    CloudShot shot;
    shot.size(320, 180);
    shot.set(noiseTable().jitter, false);
    const auto shareBeyond = [&](double tolerance, const Picture& other) {
        int beyond = 0;
        const Picture marched = shot.with(NoiseMarch::bounded, 64, 0);
        marched.each([&](int x, int y) {
            const glm::dvec3 away = glm::abs(shownDifference(marched, other, x, y));
            beyond += std::max({away.r, away.g, away.b}) > tolerance;
        });
        return beyond / (320.0 * 180.0);
    };
    const Picture some = shot.with(NoiseMarch::bounded, 64, 0.08), all = shot.with(NoiseMarch::bounded, 64, 1);
    EXPECT_LT(shareBeyond(0.08, some), 1e-3);
    EXPECT_GT(shareBeyond(0.08, all), 2e-3) << "control";
    EXPECT_LT(lookups(all), lookups(some));
    EXPECT_LT(3 * lookups(some) / 2, lookups(shot.with(NoiseMarch::bounded, 64, 0)));
}

// The blocks of pixels that share a ray lie on the grid of the whole picture.
TEST_F(NoiseWorks, OfCloudsAreTheSameInTiles)
{
    for (const bool inHall : {false, true}) {
        WorkShot shot(NoiseWork::clouds);
        shot.size(61, 45);
        shot.request.samples = 2;
        if (inHall) shot.inHall();
        const Picture whole = shot.take();
        shot.request.largestTile = 17;
        const Picture tiled = shot.take();
        // Walls beside the frame are rounded differently.
        EXPECT_LE(largestDifference(whole.image, tiled.image), inHall ? 1e-5 : 0);
    }
}

// A driver that ends all loops of a group of pixels after so many iterations must not leave the clouds out.
TEST_F(NoiseWorks, OfCloudsHaveThemWithTheMostStepsToo)
{
    WorkShot shot(NoiseWork::clouds);
    shot.request.frame.raster.size = {48, 30};
    shot.values().set(noiseTable().cloudSteps, 512);
    shot.values().set(noiseTable().lightSteps, 64);
    shot.values().set(noiseTable().cloudOctaves, 6);
    const Picture baked = shot.take();
    shot.values().set(noiseTable().cloudNoise, NoiseLookup::evaluated);
    const Picture evaluated = shot.take();
    shot.values().set(noiseTable().coverage, 0.0);
    const double all = colorDifference(shot.take(), baked);
    EXPECT_GT(all, 0.02) << "control";
    EXPECT_LT(colorDifference(evaluated, baked), 0.25 * all);
}

}  // namespace
}  // namespace vitrine::noise
