// Error of noise interpolated between texels, compared with the bound that rays rely on.

#include "render/glsl/cpu.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

namespace n64 = vitrine::glsl;
using glm::dvec3;
using glm::ivec3;

constexpr int texels = 8;  ///< Texels along a cell.

double lookedUp(int kind, const dvec3& p)
{
    const dvec3 q = p * static_cast<double>(texels) - 0.5;
    const dvec3 base = glm::floor(q), f = q - base;
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner(i & 1, (i >> 1) & 1, i >> 2);
        const dvec3 w = glm::mix(1.0 - f, f, corner);
        const dvec3 at = (base + corner + 0.5) / static_cast<double>(texels);
        sum += w.x * w.y * w.z * n64::noiseNear(kind, at, ivec3(0), dvec3(0), ivec3(16), 3).value;
    }
    return sum;
}

TEST(NoiseLookedUp, IsOffByNoMoreThanItsBound)
{
    for (int kind = 0; kind < 4; ++kind) {
        test::Random random(31);
        double most = 0;
        for (int i = 0; i < 60000; ++i) {
            const dvec3 p = random.point(16);
            const double exact = n64::noiseNear(kind, p, ivec3(0), dvec3(0), ivec3(16), 3).value;
            most = std::max(most, std::abs(lookedUp(kind, p) - exact));
        }
        EXPECT_LT(most, n64::noiseLookedUpError(kind) - 0.003) << kind;
        EXPECT_GT(most, 0.15 * n64::noiseLookedUpError(kind)) << kind << ": the bound says too little";
    }
}

/// Weight of a lattice point along an axis, and its product with the offset: exact, and interpolated between two
/// texels.
struct AxisPart {
    double weight, ramp, weightLooked, rampLooked;
};

AxisPart axisPart(int texel, double share, int lattice)
{
    const auto weight = [](double d) { return std::abs(d) < 1 ? 1 - n64::noiseFade(std::abs(d)) : 0; };
    const double a = (texel - 0.5) / texels - lattice, b = a + 1.0 / texels, x = a + share / texels;
    return {weight(x), weight(x) * x, weight(a) * (1 - share) + weight(b) * share,
            weight(a) * a * (1 - share) + weight(b) * b * share};
}

/// Returns the largest possible errors of value and gradient noise at this place, over all choices at the surrounding
/// lattice points.
std::array<double, 2> worstAt(const ivec3& texel, const dvec3& share)
{
    double value = 0, gradient = 0;
    for (int i = 0; i < 64; ++i) {
        const AxisPart x = axisPart(texel.x, share.x, i % 4 - 1);
        const AxisPart y = axisPart(texel.y, share.y, i / 4 % 4 - 1);
        const AxisPart z = axisPart(texel.z, share.z, i / 16 - 1);
        value += std::abs(x.weight * y.weight * z.weight - x.weightLooked * y.weightLooked * z.weightLooked);
        std::array<double, 3> along{
            std::abs(x.ramp * y.weight * z.weight - x.rampLooked * y.weightLooked * z.weightLooked),
            std::abs(x.weight * y.ramp * z.weight - x.weightLooked * y.rampLooked * z.weightLooked),
            std::abs(x.weight * y.weight * z.ramp - x.weightLooked * y.weightLooked * z.rampLooked)};
        std::sort(along.begin(), along.end());
        gradient += n64::GRADIENT_SCALE_3 * (along[1] + along[2]);  // Gradients lie along two axes.
    }
    return {value, gradient};
}

TEST(NoiseLookedUp, IsOffByNoMoreForTheWorstChoiceAtAllLatticePoints)
{
    constexpr int steps = 6;
    std::array<double, 2> worst{};
    // By symmetry, half of the cell with sorted axes is sufficient.
    for (int x = 0; x <= texels / 2; ++x)
        for (int y = 0; y <= x; ++y)
            for (int z = 0; z <= y; ++z)
                for (int i = 0; i <= steps * steps * steps - 1; ++i) {
                    const dvec3 share = dvec3(i % steps, i / steps % steps, i / steps / steps) / (steps - 1.0);
                    const std::array<double, 2> at = worstAt({x, y, z}, share);
                    for (std::size_t k = 0; k < 2; ++k) worst[k] = std::max(worst[k], at[k]);
                }
    // The margin of 0.003 is for half-precision texels and for filters.
    EXPECT_LT(worst[0], n64::noiseLookedUpError(n64::NOISE_VALUE) - 0.003);
    EXPECT_LT(worst[1], n64::noiseLookedUpError(n64::NOISE_GRADIENT) - 0.003);
    EXPECT_GT(worst[1], 0.8 * n64::noiseLookedUpError(n64::NOISE_GRADIENT));
    // Bounds of simplex noise by its curvature, of cellular noise by its slope.
    EXPECT_LT(3 * n64::noiseMostCurved(n64::NOISE_SIMPLEX) / (8 * texels * texels),
              n64::noiseLookedUpError(n64::NOISE_SIMPLEX) - 0.003);
    EXPECT_LT(n64::noiseSteepest(n64::NOISE_CELLULAR) * std::sqrt(3.0) / 2 / texels,
              n64::noiseLookedUpError(n64::NOISE_CELLULAR) - 0.003);
}

}  // namespace
}  // namespace vitrine
