// FLIP compared with a second implementation of its paper's equations. That one uses 64-bit floats, every filter as one
// dense square of weights, and colors from the chromaticities of Rec. 709, and shares nothing with
// render/measure/flip.cpp. The pictures of the authors' published numbers (a mean of 0.159691 for their pair at 67
// pixels per degree) are not in this repository.

#include "render/measure/flip.h"
#include "tests/support/made_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace vitrine {
namespace {

using render::Image;
using test::made;
using Color = std::array<double, 3>;
using Matrix = std::array<Color, 3>;  // Rows.

using std::numbers::pi;

Color times(const Matrix& m, const Color& v)
{
    Color result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) result[row] += m[row][column] * v[column];
    return result;
}

double determinant(const Matrix& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Solves m x = v by Cramer's rule.
Color solved(const Matrix& m, const Color& v)
{
    Color result{};
    for (std::size_t column = 0; column < 3; ++column) {
        Matrix replaced = m;
        for (std::size_t row = 0; row < 3; ++row) replaced[row][column] = v[row];
        result[column] = determinant(replaced) / determinant(m);
    }
    return result;
}

/// Returns the XYZ of a color of chromaticity (x, y) and luminance 1.
Color chromaticity(double x, double y)
{
    return {x / y, 1, (1 - x - y) / y};
}

/// Returns the matrix of ITU-R BT.709 from its primaries and D65. The white point has the five digits of CIE 15, as in
/// the matrix that FLIP's authors publish. Four digits (0.3127, 0.3290) would change a pixel by 5e-5.
Matrix xyzFromRgb()
{
    const std::array<Color, 3> primaries{chromaticity(0.64, 0.33), chromaticity(0.30, 0.60), chromaticity(0.15, 0.06)};
    Matrix m{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) m[row][column] = primaries[column][row];
    const Color share = solved(m, chromaticity(0.31271, 0.32902));
    for (Color& row : m)
        for (std::size_t column = 0; column < 3; ++column) row[column] *= share[column];
    return m;
}

const Matrix toXyz = xyzFromRgb();
const Color whitePoint = times(toXyz, {1, 1, 1});

struct Map {
    int width = 0, height = 0;
    std::vector<Color> values;

    [[nodiscard]] const Color& at(int x, int y) const
    {
        const int column = x < 0 ? 0 : x >= width ? width - 1 : x;
        const int row = y < 0 ? 0 : y >= height ? height - 1 : y;
        return values[static_cast<std::size_t>(row * width + column)];
    }
};

using Weight = std::function<double(int dx, int dy)>;

/// Returns the weighted mean of one channel around a pixel, with a dense square of weights.
double gathered(const Map& map, std::size_t channel, int x, int y, int radius, const Weight& weight)
{
    double sum = 0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) sum += weight(dx, dy) * map.at(x + dx, y + dy)[channel];
    return sum;
}

double total(int radius, const Weight& weight)
{
    double sum = 0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) sum += weight(dx, dy);
    return sum;
}

/// Converts to the linearized CIELAB space in which the paper filters (YyCxCz).
Color opponent(const Color& rgb)
{
    const Color xyz = times(toXyz, rgb);
    const double x = xyz[0] / whitePoint[0];
    const double y = xyz[1] / whitePoint[1];
    const double z = xyz[2] / whitePoint[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color rgbOfOpponent(const Color& c)
{
    const double y = (c[0] + 16) / 116;
    return solved(toXyz, {(c[1] / 500 + y) * whitePoint[0], y * whitePoint[1], (y - c[2] / 200) * whitePoint[2]});
}

Color labAfterHunt(const Color& rgb)
{
    const Color xyz = times(toXyz, rgb);
    const auto root = [&](std::size_t i) {
        const double t = xyz[i] / whitePoint[i];
        return t > 216.0 / 24389 ? std::pow(t, 1.0 / 3) : (24389.0 / 27 * t + 16) / 116;
    };
    const double lightness = 116 * root(1) - 16;
    return {lightness, lightness * 5 * (root(0) - root(1)), lightness * 2 * (root(1) - root(2))};
}

double distance(const Color& a, const Color& b)
{
    return std::fabs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

Map opponentMap(const Image& image)
{
    Map map{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            map.values.push_back(opponent({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}));
    return map;
}

/// Filters a pixel by the contrast sensitivity of the eye: each channel with the inverse Fourier transform of its
/// function.
Color seenAt(const Map& map, int x, int y, double ppd)
{
    struct Term {
        double a1, b1, a2, b2;
    };
    constexpr std::array<Term, 3> channels{{{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    Color seen{};
    for (std::size_t c = 0; c < 3; ++c) {
        const Term t = channels[c];
        const Weight weight = [&](int dx, int dy) {
            const double square = (dx * dx + dy * dy) / (ppd * ppd);
            return t.a1 * std::sqrt(pi / t.b1) * std::exp(-pi * pi * square / t.b1) +
                   t.a2 * std::sqrt(pi / t.b2) * std::exp(-pi * pi * square / t.b2);
        };
        seen[c] = gathered(map, c, x, y, radius, weight) / total(radius, weight);
    }
    Color rgb = rgbOfOpponent(seen);
    for (double& v : rgb) v = v < 0 ? 0 : v > 1 ? 1 : v;
    return labAfterHunt(rgb);
}

/// Returns the strength of edges (first derivative of a Gaussian) or points (second derivative) of the achromatic
/// channel, scaled to [0, 1].
double featureAt(const Map& map, int x, int y, double ppd, bool points)
{
    const double sigma = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto along = [&](bool horizontal) {
        const Weight plain = [&](int dx, int dy) {
            const double d = horizontal ? dx : dy;
            return (points ? d * d / (sigma * sigma) - 1 : -d) * std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
        };
        const double positive = total(radius, [&](int dx, int dy) { return std::max(plain(dx, dy), 0.0); });
        const double negative = -total(radius, [&](int dx, int dy) { return std::min(plain(dx, dy), 0.0); });
        const Weight balanced = [&](int dx, int dy) {
            const double w = plain(dx, dy);
            return w > 0 ? w / positive : w / negative;
        };
        // Applies to (Y + 16) / 116. The sum of the weights is 0, so the 16 cancels.
        return gathered(map, 0, x, y, radius, balanced) / 116;
    };
    const double h = along(true);
    const double v = along(false);
    return std::sqrt(h * h + v * v);
}

double errorAt(const Map& reference, const Map& test, int x, int y, double ppd)
{
    const double top = std::pow(distance(labAfterHunt({0, 1, 0}), labAfterHunt({0, 0, 1})), 0.7);
    const double d = std::pow(distance(seenAt(reference, x, y, ppd), seenAt(test, x, y, ppd)), 0.7);
    const double color = d < 0.4 * top ? 0.95 / (0.4 * top) * d : 0.95 + (d - 0.4 * top) / (0.6 * top) * 0.05;
    const double edges = std::fabs(featureAt(reference, x, y, ppd, false) - featureAt(test, x, y, ppd, false));
    const double points = std::fabs(featureAt(reference, x, y, ppd, true) - featureAt(test, x, y, ppd, true));
    const double feature = std::sqrt(std::max(edges, points) / std::sqrt(2.0));
    return std::pow(color, 1 - feature);
}

Image noisePicture(unsigned seed, int width, int height)
{
    std::mt19937 random(seed);
    return made(width, height, [&](int, int, int) { return static_cast<float>(random() >> 8U) * 0x1p-24F; });
}

/// Returns a picture of two colors, divided by a line through (x, y).
Image step(Color left, Color right, double x, double y, double angle)
{
    return made(26, 22, [=](int px, int py, int c) {
        const bool beyond = (px - x) * std::cos(angle) + (py - y) * std::sin(angle) > 0;
        return static_cast<float>((beyond ? right : left)[static_cast<std::size_t>(c)]);
    });
}

/// Returns the largest difference of the two implementations over all pixels. The map has 32-bit floats.
double largestDeparture(const Image& reference, const Image& test, double ppd)
{
    const Image map = render::flipMap(reference, test, ppd);
    const Map a = opponentMap(reference);
    const Map b = opponentMap(test);
    double largest = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            largest = std::max(largest, std::fabs(errorAt(a, b, x, y, ppd) - static_cast<double>(map.at(x, y))));
    return largest;
}

constexpr double float32Rounding = 1e-7;

TEST(FlipPaper, NoiseIsWhatTheEquationsSay)
{
    for (const unsigned seed : {1U, 2U, 3U})
        EXPECT_LT(largestDeparture(noisePicture(seed, 24, 18), noisePicture(seed + 10, 24, 18), 67), float32Rounding)
            << seed;
}

TEST(FlipPaper, NoiseIsWhatTheEquationsSayNearAndFar)
{
    for (const double ppd : {12.0, 30.5, 90.0})
        EXPECT_LT(largestDeparture(noisePicture(4, 16, 16), noisePicture(5, 16, 16), ppd), float32Rounding) << ppd;
}

TEST(FlipPaper, EdgesThatMoveOrTurnAreWhatTheEquationsSay)
{
    const Color dark{0.1, 0.12, 0.3};
    const Color bright{0.9, 0.7, 0.2};
    EXPECT_LT(largestDeparture(step(dark, bright, 13, 11, 0), step(dark, bright, 14, 11, 0), 67), float32Rounding);
    EXPECT_LT(largestDeparture(step(dark, bright, 13, 11, 0.3), step(dark, bright, 13, 11, 0.8), 67), float32Rounding);
    EXPECT_LT(largestDeparture(step({0, 0, 0}, {1, 1, 1}, 8, 8, 1.2), step({0, 0, 0}, {0, 0, 0}, 0, 0, 0), 67),
              float32Rounding);
}

TEST(FlipPaper, PicturesSmallerThanTheFiltersRepeatTheirEdge)
{
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 2), std::pair(1, 17)})
        EXPECT_LT(largestDeparture(noisePicture(6, width, height), noisePicture(7, width, height), 67), float32Rounding)
            << width << 'x' << height;
}

TEST(FlipPaper, AWrongFilterWouldBeSeen)
{
    // Negative control: at another viewing distance the filter differs, by much more than rounding.
    const Image a = noisePicture(8, 16, 16);
    const Image b = noisePicture(9, 16, 16);
    const Image map = render::flipMap(a, b, 66);
    EXPECT_GT(std::fabs(errorAt(opponentMap(a), opponentMap(b), 8, 8, 67) - static_cast<double>(map.at(8, 8))),
              100 * float32Rounding);
}

}  // namespace
}  // namespace vitrine
