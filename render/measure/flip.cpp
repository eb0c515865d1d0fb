#include "render/measure/flip.h"

#include "render/parallel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace vitrine::render {
namespace {

constexpr double pi = std::numbers::pi;

using Plane = std::vector<double>;
using Kernel = std::vector<double>;  // Filter weights: odd length, the pixel in the middle.

struct Size {
    int width, height;
    [[nodiscard]] std::size_t count() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

// Rec. 709 primaries, D65 with five digits (0.31271, 0.32902), as rows: XYZ = M rgb.
constexpr double xyzFromRgb[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

glm::dmat3 matrixXyzFromRgb()
{
    glm::dmat3 m(1);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) m[column][row] = xyzFromRgb[row][column];
    return m;
}

const glm::dmat3 toXyz = matrixXyzFromRgb();
const glm::dmat3 toRgb = glm::inverse(toXyz);
const glm::dvec3 white = toXyz * glm::dvec3(1);

/// Converts to luminance and two opponent colors, linear in light: Y 0 to 100, as in the paper's YyCxCz.
glm::dvec3 opponentFromRgb(const glm::dvec3& rgb)
{
    const glm::dvec3 n = toXyz * rgb / white;
    return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}

glm::dvec3 rgbFromOpponent(const glm::dvec3& opponent)
{
    const double y = (opponent.x + 16) / 116;
    const glm::dvec3 n(y + opponent.y / 500, y, y - opponent.z / 200);
    return toRgb * (n * white);
}

/// Converts to CIELAB, with the chroma scaled by lightness after Hunt: colors are harder to distinguish in the dark.
glm::dvec3 huntLab(const glm::dvec3& rgb)
{
    const glm::dvec3 n = toXyz * rgb / white;
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const double lightness = 116 * f(n.y) - 16;
    return {lightness, 0.01 * lightness * 500 * (f(n.x) - f(n.y)), 0.01 * lightness * 200 * (f(n.y) - f(n.z))};
}

/// HyAB distance (Abasi, Amani Tehran, Fairchild 2019), made for large color differences.
double hyab(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// Sets to[x] to the sum of kernel[k] * taps[k][x], added in the order of k. Several columns are summed at once, so
/// that the compiler uses vectors.
void sumTaps(const std::vector<const double*>& taps, const Kernel& kernel, std::size_t count, double* to)
{
    constexpr std::size_t together = 8;
    std::size_t x = 0;
    for (; x + together <= count; x += together) {
        double sums[together] = {};
        for (std::size_t k = 0; k < taps.size(); ++k)
            for (std::size_t i = 0; i < together; ++i) sums[i] += kernel[k] * taps[k][x + i];
        std::copy_n(sums, together, to + x);
    }
    for (; x < count; ++x) {
        to[x] = 0;
        for (std::size_t k = 0; k < taps.size(); ++k) to[x] += kernel[k] * taps[k][x];
    }
}

/// Filters along a row or a column; beyond the border, its pixels are repeated.
Plane filteredAlong(const Plane& plane, Size size, const Kernel& kernel, bool alongX)
{
    const auto width = static_cast<std::size_t>(size.width);
    const std::size_t radius = kernel.size() / 2;
    const auto row = [&](int y) { return plane.data() + static_cast<std::size_t>(y) * width; };
    Plane result(plane.size());
    if (plane.empty()) return result;
    Plane padded(width + 2 * radius);
    std::vector<const double*> taps(kernel.size());
    for (int y = 0; y < size.height; ++y) {
        if (alongX) {
            std::copy_n(row(y), width, padded.data() + radius);
            std::fill_n(padded.data(), radius, row(y)[0]);
            std::fill_n(padded.data() + radius + width, radius, row(y)[width - 1]);
        }
        for (std::size_t k = 0; k < taps.size(); ++k) {
            const int v = std::clamp(y + static_cast<int>(k) - static_cast<int>(radius), 0, size.height - 1);
            taps[k] = alongX ? padded.data() + k : row(v);
        }
        sumTaps(taps, kernel, width, result.data() + static_cast<std::size_t>(y) * width);
    }
    return result;
}

Plane filtered(const Plane& plane, Size size, const Kernel& alongX, const Kernel& alongY)
{
    return filteredAlong(filteredAlong(plane, size, alongX, true), size, alongY, false);
}

template <typename Weight> Kernel kernelOf(int radius, const Weight& weight)
{
    Kernel kernel;
    for (int k = -radius; k <= radius; ++k) kernel.push_back(weight(static_cast<double>(k)));
    return kernel;
}

double sumOf(const Kernel& kernel)
{
    double sum = 0;
    for (const double k : kernel) sum += k;
    return sum;
}

/// Sum of two Gaussians, the paper's contrast sensitivity of a channel: amplitude a, falloff b in degrees squared.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity luminance{1, 0.0047, 0, 1e-5};
constexpr Sensitivity redGreen{1, 0.0053, 0, 1e-5};
constexpr Sensitivity blueYellow{34.1, 0.04, 13.5, 0.025};

/// Filters a channel by the eye's contrast sensitivity: the kernel a1 sqrt(pi / b1) exp(-pi² d² / b1) + ... over the
/// distance d in degrees, normalized to sum 1.
Plane seen(const Plane& plane, Size size, const Sensitivity& s, double pixelsPerDegree)
{
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(blueYellow.b1 / (2 * pi * pi)) * pixelsPerDegree));
    const auto gaussian = [&](double b) {
        return kernelOf(radius,
                        [&](double k) { return std::exp(-pi * pi * k * k / (pixelsPerDegree * pixelsPerDegree * b)); });
    };
    const Kernel g1 = gaussian(s.b1);
    const Kernel g2 = gaussian(s.b2);
    const double w1 = s.a1 * std::sqrt(pi / s.b1);
    const double w2 = s.a2 * std::sqrt(pi / s.b2);
    const double total = w1 * sumOf(g1) * sumOf(g1) + w2 * sumOf(g2) * sumOf(g2);
    Plane result = filtered(plane, size, g1, g1);
    for (double& v : result) v *= w1 / total;
    if (w2 > 0) {
        const Plane second = filtered(plane, size, g2, g2);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += second[i] * (w2 / total);
    }
    return result;
}

/// Scales the positive weights to sum 1 and the negative ones to sum -1.
Kernel balanced(Kernel kernel)
{
    double positive = 0;
    double negative = 0;
    for (const double k : kernel) (k > 0 ? positive : negative) += k;
    for (double& k : kernel) k /= k > 0 ? positive : -negative;
    return kernel;
}

/// Strength of edges and points per pixel, of the achromatic channel scaled to [0, 1].
struct Features {
    Plane edges, points;
};

Features features(const Plane& y, Size size, double pixelsPerDegree)
{
    constexpr double width = 0.082;  // Degrees: width of the features that are noticed, from the paper.
    const double sigma = 0.5 * width * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gauss = [&](double k) { return std::exp(-k * k / (2 * sigma * sigma)); };
    Kernel smooth = kernelOf(radius, gauss);
    const double sum = sumOf(smooth);
    for (double& k : smooth) k /= sum;
    const Kernel edge = balanced(kernelOf(radius, [&](double k) { return -k * gauss(k); }));
    const Kernel point = balanced(kernelOf(radius, [&](double k) { return (k * k / (sigma * sigma) - 1) * gauss(k); }));

    const auto magnitude = [&](const Kernel& kernel) {
        Plane x = filtered(y, size, kernel, smooth);
        const Plane down = filtered(y, size, smooth, kernel);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::hypot(x[i], down[i]);
        return x;
    };
    return {magnitude(edge), magnitude(point)};
}

/// A picture as perceived: filtered colors in Hunt-adjusted CIELAB, and features.
struct Seen {
    std::vector<glm::dvec3> lab;
    Features features;
};

Seen look(const Image& image, double pixelsPerDegree)
{
    const Size size{image.width, image.height};
    Plane channels[3] = {Plane(size.count()), Plane(size.count()), Plane(size.count())};
    Plane gray(size.count());
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, ++i) {
            const bool isGray = image.channels < 3;
            const double alpha =
                image.channels == 2 || image.channels >= 4 ? static_cast<double>(image.at(x, y, isGray ? 1 : 3)) : 1.0;
            glm::dvec3 rgb(0);
            for (int c = 0; c < 3; ++c) {
                const double v = static_cast<double>(image.at(x, y, isGray ? 0 : c)) * alpha;
                rgb[c] = v > 0 ? std::min(v, 1.0) : 0.0;  // NaN becomes 0, too.
            }
            const glm::dvec3 opponent = opponentFromRgb(rgb);
            for (int c = 0; c < 3; ++c) channels[c][i] = opponent[c];
            gray[i] = (opponent.x + 16) / 116;
        }
    }
    Seen result;
    result.features = features(gray, size, pixelsPerDegree);
    const Plane y = seen(channels[0], size, luminance, pixelsPerDegree);
    const Plane cx = seen(channels[1], size, redGreen, pixelsPerDegree);
    const Plane cz = seen(channels[2], size, blueYellow, pixelsPerDegree);
    for (std::size_t p = 0; p < size.count(); ++p)
        result.lab.push_back(huntLab(glm::clamp(rgbFromOpponent({y[p], cx[p], cz[p]}), glm::dvec3(0), glm::dvec3(1))));
    return result;
}

/// Maps color differences to [0, 1]. Most of that range is used for the differences that occur in practice.
double colorError(double difference)
{
    constexpr double exponent = 0.7;
    constexpr double knee = 0.4;
    constexpr double atKnee = 0.95;
    static const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), exponent);
    const double d = std::pow(difference, exponent);
    if (d < knee * largest) return d * atKnee / (knee * largest);
    return std::min(atKnee + (d - knee * largest) / (largest - knee * largest) * (1 - atKnee), 1.0);
}

}  // namespace

Image flipMap(const Image& reference, const Image& test, double pixelsPerDegree)
{
    assert(reference.width == test.width && reference.height == test.height && pixelsPerDegree > 0);
    Seen a, b;
    onThreads(2, [&](std::size_t i) { (i == 0 ? a : b) = look(i == 0 ? reference : test, pixelsPerDegree); });
    Image map(reference.width, reference.height, 1);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const double feature = std::max(std::abs(a.features.edges[i] - b.features.edges[i]),
                                        std::abs(a.features.points[i] - b.features.points[i]));
        const double noticed = std::sqrt(std::min(feature / std::numbers::sqrt2, 1.0));
        map.pixels[i] = static_cast<float>(std::pow(colorError(hyab(a.lab[i], b.lab[i])), 1 - noticed));
    }
    return map;
}

double meanOfMap(const Image& map)
{
    double sum = 0;
    for (const float error : map.pixels) sum += error;
    return map.empty() ? 0 : sum / static_cast<double>(map.pixels.size());
}

double flip(const Image& reference, const Image& test, double pixelsPerDegree)
{
    return meanOfMap(flipMap(reference, test, pixelsPerDegree));
}

}  // namespace vitrine::render
