// Noise library: the GPU's source code, at float64. Values, derivatives, periods and spectrum of each kind.

#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace vitrine {
namespace {

namespace n64 = vitrine::glsl;
namespace n32 = vitrine::glsl32;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

/// Kind of noise in the dimensions of `V`.
template <typename V, typename I> struct Kind {
    std::string name;
    std::function<std::pair<double, V>(const I&, const V&, const I&, glm::uint)> at;
    bool zeroOnLattice = false;
    double steepest = 0;
    /// False for cellular noise, which has no derivative where two points are equally near.
    bool smooth = true;

    [[nodiscard]] std::pair<double, V> point(const V& p, glm::uint seed = 1, const I& period = I(0)) const
    {
        const V base = glm::floor(p);
        return at(I(base), p - base, period, seed);
    }
};

template <typename V, typename I, typename F>
Kind<V, I> kind(const char* name, F function, bool zero, double steepest, bool smooth = true)
{
    return {name,
            [function](const I& cell, const V& place, const I& period, glm::uint seed) {
                const auto n = function(cell, place, period, seed);
                return std::pair<double, V>(n.value, n.slope);
            },
            zero, steepest, smooth};
}

#define NOISE_OF(function, V, I)                                                                                       \
    [](const I& c, const V& f, const I& p, glm::uint s) { return n64::function(c, f, p, s); }

using Kind2 = Kind<dvec2, glm::ivec2>;
using Kind3 = Kind<dvec3, glm::ivec3>;
using Kind4 = Kind<dvec4, glm::ivec4>;

std::vector<Kind2> kinds2()
{
    return {kind<dvec2, glm::ivec2>("value", NOISE_OF(valueNoise, dvec2, glm::ivec2), false, 3.75),
            kind<dvec2, glm::ivec2>("gradient", NOISE_OF(gradientNoise, dvec2, glm::ivec2), true, 3.13),
            kind<dvec2, glm::ivec2>("simplex", NOISE_OF(simplexNoise, dvec2, glm::ivec2), false, 4.52),
            kind<dvec2, glm::ivec2>("cellular", NOISE_OF(cellularNoise, dvec2, glm::ivec2), false, 2.0, false)};
}

std::vector<Kind3> kinds3()
{
    const auto steepest = [](int k) { return n64::noiseSteepest(k); };
    return {kind<dvec3, glm::ivec3>("value", NOISE_OF(valueNoise, dvec3, glm::ivec3), false, steepest(0)),
            kind<dvec3, glm::ivec3>("gradient", NOISE_OF(gradientNoise, dvec3, glm::ivec3), true, steepest(1)),
            kind<dvec3, glm::ivec3>("simplex", NOISE_OF(simplexNoise, dvec3, glm::ivec3), false, steepest(2)),
            kind<dvec3, glm::ivec3>("cellular", NOISE_OF(cellularNoise, dvec3, glm::ivec3), false, steepest(3), false)};
}

std::vector<Kind4> kinds4()
{
    return {kind<dvec4, glm::ivec4>("value", NOISE_OF(valueNoise, dvec4, glm::ivec4), false, 3.75),
            kind<dvec4, glm::ivec4>("gradient", NOISE_OF(gradientNoise, dvec4, glm::ivec4), true, 3.67),
            kind<dvec4, glm::ivec4>("simplex", NOISE_OF(simplexNoise, dvec4, glm::ivec4), false, 6.59),
            kind<dvec4, glm::ivec4>("cellular", NOISE_OF(cellularNoise, dvec4, glm::ivec4), false, 2.0, false)};
}

template <typename V> V anyPoint(test::Random& random, double halfSize)
{
    V p;
    for (int i = 0; i < V::length(); ++i) p[i] = random.number(-halfSize, halfSize);
    return p;
}

/// Expects values within [-1, 1] that use much of this range, slopes within the stated bound, and a mean of 0.
template <typename V, typename I> void expectRange(const std::vector<Kind<V, I>>& kinds)
{
    for (const Kind<V, I>& k : kinds) {
        test::Random random(11);
        double low = 1, high = -1, sum = 0, squares = 0, steepest = 0;
        constexpr int points = 60000;
        for (int i = 0; i < points; ++i) {
            const auto [value, slope] = k.point(anyPoint<V>(random, 1000));
            low = std::min(low, value);
            high = std::max(high, value);
            sum += value;
            squares += value * value;
            steepest = std::max(steepest, glm::length(slope));
        }
        const std::string where = k.name + " in " + std::to_string(V::length()) + " dimensions";
        EXPECT_GE(low, -1) << where;
        EXPECT_LE(high, 1) << where;
        EXPECT_GT(high - low, 0.9) << where;
        EXPECT_GT(squares / points, 0.01) << where;
        EXPECT_LT(steepest, k.steepest + 1e-9) << where;
        EXPECT_GT(steepest, 0.3 * k.steepest) << where << ": the bound says too little";
        if (k.smooth) {
            EXPECT_NEAR(sum / points, 0, 0.02) << where;
        }
    }
}

TEST(Noise, StaysInItsRangeAndIsNeverSteeperThanItSays)
{
    expectRange(kinds2());
    expectRange(kinds3());
    expectRange(kinds4());
}

/// Compares derivatives with central differences at float64.
template <typename V, typename I> void expectSlopes(const std::vector<Kind<V, I>>& kinds)
{
    constexpr double step = 1e-5;
    for (const Kind<V, I>& k : kinds) {
        test::Random random(12);
        int wrong = 0;
        for (int i = 0; i < 2000; ++i) {
            const V p = anyPoint<V>(random, 50);
            const V slope = k.point(p).second;
            for (int axis = 0; axis < V::length(); ++axis) {
                V d(0);
                d[axis] = step;
                const double difference = (k.point(p + d).first - k.point(p - d).first) / (2 * step);
                wrong += std::abs(difference - slope[axis]) > 1e-6;
            }
        }
        // The nearest of two points may change within a step.
        EXPECT_LE(wrong, k.smooth ? 0 : 4) << k.name << " in " << V::length() << " dimensions";
    }
}

TEST(Noise, HasTheDerivativeThatDifferencesShow)
{
    expectSlopes(kinds2());
    expectSlopes(kinds3());
    expectSlopes(kinds4());
}

/// Expects no jump between cells, simplices or nearest points.
template <typename V, typename I> void expectContinuous(const std::vector<Kind<V, I>>& kinds)
{
    for (const Kind<V, I>& k : kinds) {
        test::Random random(13);
        double largest = 0;
        for (int i = 0; i < 20000; ++i) {
            const V p = anyPoint<V>(random, 30);
            const V d = glm::normalize(anyPoint<V>(random, 1)) * 1e-4;
            largest = std::max(largest, std::abs(k.point(p + d).first - k.point(p).first) / 1e-4);
        }
        EXPECT_LT(largest, k.steepest * 1.001) << k.name << " in " << V::length() << " dimensions";
    }
}

TEST(Noise, HasNoSeams)
{
    expectContinuous(kinds2());
    expectContinuous(kinds3());
    expectContinuous(kinds4());
}

TEST(Noise, OfTheGradientKindIsZeroAtLatticePoints)
{
    for (int i = 0; i < 200; ++i) {
        const glm::ivec3 cell(i * 7 - 300, i * 3 - 100, 50 - i);
        EXPECT_EQ(n64::gradientNoise(cell, dvec3(0), glm::ivec3(0), 5).value, 0);
        EXPECT_EQ(n64::gradientNoise(glm::ivec2(cell), dvec2(0), glm::ivec2(0), 5).value, 0);
        EXPECT_EQ(n64::gradientNoise(glm::ivec4(cell, i), dvec4(0), glm::ivec4(0), 5).value, 0);
    }
    double most = 0;
    for (int i = 0; i < 50; ++i)
        most = std::max(most, std::abs(n64::valueNoise(glm::ivec3(i), dvec3(0), glm::ivec3(0), 5).value));
    EXPECT_GT(most, 0.5) << "value noise is not, as it should be";
}

template <typename V, typename I> void expectPeriods(const std::vector<Kind<V, I>>& kinds)
{
    for (const Kind<V, I>& k : kinds) {
        test::Random random(14);
        int same = 0;
        for (int i = 0; i < 400; ++i) {
            I period, cell, far;
            V place;
            for (int axis = 0; axis < V::length(); ++axis) {
                period[axis] = 2 * (1 + static_cast<int>(random.number(0, 6)));
                cell[axis] = static_cast<int>(random.number(-20, 20));
                far[axis] = cell[axis] + period[axis] * static_cast<int>(random.number(-1e6, 1e6));
                place[axis] = random.number(0, 1);
            }
            const auto near = k.at(cell, place, period, 3);
            EXPECT_EQ(near, k.at(far, place, period, 3)) << k.name;
            same += near.first == k.at(cell, place, I(0), 3).first;
        }
        EXPECT_LT(same, 300) << k.name << ": without a period it is another noise";
    }
}

TEST(Noise, RepeatsToTheBitAfterItsPeriodAlongEveryAxis)
{
    expectPeriods(kinds2());
    expectPeriods(kinds3());
    expectPeriods(kinds4());
}

TEST(Noise, OfAnotherSeedIsUnrelated)
{
    for (const Kind3& k : kinds3()) {
        test::Random random(15);
        double product = 0, squares = 0, mean = 0;
        constexpr int points = 20000;
        std::vector<std::pair<double, double>> pairs;
        for (int i = 0; i < points; ++i) {
            const dvec3 p = random.point(500);
            pairs.emplace_back(k.point(p, 1).first, k.point(p, 2).first);
            mean += 0.5 * (pairs.back().first + pairs.back().second) / points;
        }
        for (const auto& [a, b] : pairs) {
            product += (a - mean) * (b - mean);
            squares += (a - mean) * (a - mean);
        }
        EXPECT_LT(std::abs(product / squares), 0.03) << k.name;
    }
}

/// Returns the share of the noise's power by frequency along lines of 64 cells in direction `d`, in steps of 1/64 per
/// cell.
std::vector<double> powerAlong(const Kind3& k, const dvec3& d)
{
    constexpr int samples = 512;
    constexpr double cells = 64;
    std::vector<double> power(samples / 2, 0.0);
    test::Random random(16);
    for (int line = 0; line < 40; ++line) {
        const dvec3 start = random.point(2000);
        std::vector<double> values;
        double mean = 0;
        for (int i = 0; i < samples; ++i) {
            values.push_back(k.point(start + d * (cells * i / samples)).first);
            mean += values.back() / samples;
        }
        for (int f = 1; f < samples / 2; ++f) {
            std::complex<double> sum = 0;
            for (int i = 0; i < samples; ++i) {
                const double window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / samples);
                sum += (values[static_cast<std::size_t>(i)] - mean) * window *
                       std::polar(1.0, -2 * std::numbers::pi * f * i / samples);
            }
            power[static_cast<std::size_t>(f)] += std::norm(sum);
        }
    }
    double total = 0;
    for (const double p : power) total += p;
    for (double& p : power) p /= total;
    return power;
}

double shareBetween(const std::vector<double>& power, double low, double high)
{
    double share = 0;
    for (std::size_t f = 0; f < power.size(); ++f) {
        const double frequency = static_cast<double>(f) / 64;
        if (frequency >= low && frequency < high) share += power[f];
    }
    return share;
}

/// Returns the mean square of means over cubes of four cells, relative to that of the noise: the power far below its
/// band.
double slowShare(const Kind3& k)
{
    constexpr int side = 16;
    test::Random random(22);
    double slow = 0, all = 0;
    for (int cube = 0; cube < 60; ++cube) {
        const dvec3 start = random.point(2000);
        double mean = 0;
        for (int i = 0; i < side * side * side; ++i) {
            const dvec3 offset(i % side, (i / side) % side, i / (side * side));
            const double value = k.point(start + (offset + 0.5) * (4.0 / side)).first;
            mean += value / (side * side * side);
            all += value * value / (side * side * side);
        }
        slow += mean * mean;
    }
    return slow / all;
}

TEST(Noise, HasASpectrumThatFallsOutsideItsBand)
{
    const std::vector<Kind3> kinds = kinds3();
    const dvec3 direction = glm::normalize(dvec3(0.36, 0.8, 0.48));
    const auto spectrum = [&](int k) { return powerAlong(kinds[static_cast<std::size_t>(k)], direction); };
    const auto value = spectrum(0), gradient = spectrum(1), simplex = spectrum(2);
    for (const auto* power : {&value, &gradient}) EXPECT_LT(shareBetween(*power, 2, 4), 0.001);
    EXPECT_LT(shareBetween(simplex, 3, 4), 0.001);
    // A line through a volume has slow waves even if the volume has none. Below the band, means over blocks are used
    // instead.
    EXPECT_GT(slowShare(kinds[0]), 0.008);
    EXPECT_LT(slowShare(kinds[1]), 0.1 * slowShare(kinds[0]));
    EXPECT_LT(slowShare(kinds[2]), 0.1 * slowShare(kinds[0]));
}

/// Returns the largest mean square of the derivative, relative to the smallest, along directions of the lattice and
/// between them.
double anisotropy(const Kind3& k)
{
    const std::array<dvec3, 5> directions{dvec3(1, 0, 0), dvec3(0, 0, 1), glm::normalize(dvec3(1, 1, 0)),
                                          glm::normalize(dvec3(1, 1, 1)), glm::normalize(dvec3(1, 2, 3))};
    std::array<double, 5> power{};
    test::Random random(17);
    for (int i = 0; i < 60000; ++i) {
        const dvec3 p = random.point(500);
        for (std::size_t d = 0; d < directions.size(); ++d) {
            // Differences over half a cell, because the derivative alone is isotropic for every noise with equal axes.
            const double difference = k.point(p + 0.25 * directions[d]).first - k.point(p - 0.25 * directions[d]).first;
            power[d] += difference * difference;
        }
    }
    return *std::max_element(power.begin(), power.end()) / *std::min_element(power.begin(), power.end());
}

TEST(Noise, ChangesAlikeInEveryDirection)
{
    const std::vector<Kind3> kinds = kinds3();
    EXPECT_LT(anisotropy(kinds[1]), 1.25);
    EXPECT_LT(anisotropy(kinds[2]), 1.12);
    EXPECT_LT(anisotropy(kinds[3]), 1.12);
}

/// Returns the mean square of the noise on planes of the lattice relative to that between them; 1 if the lattice is
/// invisible.
double onPlanes(const Kind3& k)
{
    test::Random random(18);
    double on = 0, between = 0;
    for (int i = 0; i < 40000; ++i) {
        dvec3 p = random.point(500);
        p.y = std::floor(p.y);
        on += std::pow(k.point(p).first, 2);
        p.y += 0.5;
        between += std::pow(k.point(p).first, 2);
    }
    return on / between;
}

TEST(Noise, OfTheSimplexKindShowsLittleOfItsLattice)
{
    const std::vector<Kind3> kinds = kinds3();
    const double gradient = onPlanes(kinds[1]), simplex = onPlanes(kinds[2]);
    EXPECT_GT(simplex, 0.9);
    EXPECT_LT(simplex, 1.1);
    EXPECT_LT(gradient, 0.8) << "gradient noise is fainter on its planes, as it should be";
}

TEST(Noise, FarFromTheOriginIsAsExactAsNearIt)
{
    test::Random random(19);
    double near = 0, far = 0, naive = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::ivec3 cell(glm::floor(random.point(30)));
        const glm::ivec3 away(10'000'019, -20'000'003, 9'999'991);
        const glm::vec3 place(random.point(0.5) + 0.5);
        const auto error = [&](const glm::ivec3& c) {
            return std::abs(n32::gradientNoise(c, place, glm::ivec3(0), 7).value -
                            n64::gradientNoise(c, dvec3(place), glm::ivec3(0), 7).value);
        };
        near = std::max(near, static_cast<double>(error(cell)));
        far = std::max(far, static_cast<double>(error(cell + away)));
        const glm::vec3 sum = glm::vec3(cell + away) + place;
        const glm::vec3 base = glm::floor(sum);
        naive = std::max(naive, std::abs(n32::gradientNoise(glm::ivec3(base), sum - base, glm::ivec3(0), 7).value -
                                         n64::gradientNoise(cell + away, dvec3(place), glm::ivec3(0), 7).value));
    }
    EXPECT_LT(near, 2e-6);
    EXPECT_LT(far, 2e-6);
    EXPECT_GT(naive, 0.1) << "cell and place in one float are lost there";
}

}  // namespace
}  // namespace vitrine
