#include "render/measure/metrics.h"

#include "render/image/srgb.h"
#include "render/measure/color_at.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine::render {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double distance(double a, double b)
{
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(a - b);
    return std::isnan(d) ? infinite : d;
}

glm::dvec3 distances(const Image& a, const Image& b, int x, int y)
{
    const glm::dvec3 p = colorAt(a, x, y);
    const glm::dvec3 q = colorAt(b, x, y);
    return {distance(p.x, q.x), distance(p.y, q.y), distance(p.z, q.z)};
}

bool differsVisibly(const glm::dvec3& p, const glm::dvec3& q)
{
    for (int c = 0; c < 3; ++c) {
        // Uses unrounded codes, so that a difference in rounding alone does not count.
        const double d =
            distance(srgbFromLinear(std::clamp(p[c], 0.0, 1.0)), srgbFromLinear(std::clamp(q[c], 0.0, 1.0)));
        if (d > 1.0 / 255 || std::isfinite(p[c]) != std::isfinite(q[c])) return true;
    }
    return false;
}

template <typename Visit> void eachPixel(const Image& image, const Visit& visit)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) visit(x, y);
}

[[maybe_unused]] bool sameSize(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height;
}

/// Returns the amount of reference light that a relative error is divided by; 0 where it is not finite.
double lightOf(double component)
{
    return std::isfinite(component) ? std::abs(component) : 0;
}

double shareOf(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

}  // namespace

double ColorDifference::psnr() const
{
    return rmse > 0 ? -20 * std::log10(rmse) : infinite;
}

ColorDifference colorDifference(const Image& a, const Image& b)
{
    assert(sameSize(a, b));
    ColorDifference result;
    double squares = 0;
    double beyond = 0;
    double shares = 0, relativeSquares = 0;
    eachPixel(a, [&](int x, int y) {
        const glm::dvec3 d = distances(a, b, x, y);
        squares += glm::dot(d, d);
        const glm::dvec3 reference = colorAt(a, x, y);
        for (int c = 0; c < 3; ++c) {
            if (d[c] == 0) continue;  // Also where both are infinite.
            const double light = lightOf(reference[c]);
            shares += d[c] / (light + relativeFloor);
            relativeSquares += d[c] * d[c] / (light * light + relativeFloor);
        }
        result.max = std::max({result.max, d.x, d.y, d.z});
        if (differsVisibly(colorAt(a, x, y), colorAt(b, x, y))) beyond += 1;
    });
    const double pixels = static_cast<double>(a.width) * a.height;
    result.rmse = std::sqrt(shareOf(squares, 3 * pixels));
    result.beyond = shareOf(beyond, pixels);
    result.mape = shareOf(shares, 3 * pixels);
    result.relativeMse = shareOf(relativeSquares, 3 * pixels);
    return result;
}

NormalDifference normalDifference(const Image& a, const Image& b, int first)
{
    assert(sameSize(a, b));
    NormalDifference result;
    double both = 0;
    double either = 0;
    const auto normal = [first](const Image& image, int x, int y) {
        return glm::dvec3(image.at(x, y, first), image.at(x, y, first + 1), image.at(x, y, first + 2));
    };
    eachPixel(a, [&](int x, int y) {
        const glm::dvec3 p = normal(a, x, y);
        const glm::dvec3 q = normal(b, x, y);
        const bool hasP = glm::length(p) >= 0.5;
        const bool hasQ = glm::length(q) >= 0.5;
        either += hasP || hasQ ? 1 : 0;
        if (!hasP || !hasQ) return;
        both += 1;
        // Accurate for small angles, unlike the arc cosine of a rounded product.
        const double degrees = std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q)) * 180 / std::numbers::pi;
        result.mean += degrees;
        result.max = std::max(result.max, degrees);
    });
    result.mean = shareOf(result.mean, both);
    result.missing = shareOf(either - both, either);
    return result;
}

DepthDifference depthDifference(const Image& a, const Image& b, int channel)
{
    assert(sameSize(a, b));
    DepthDifference result;
    double squares = 0;
    double both = 0;
    double either = 0;
    eachPixel(a, [&](int x, int y) {
        const double p = a.at(x, y, channel);
        const double q = b.at(x, y, channel);
        either += std::isfinite(p) || std::isfinite(q) ? 1 : 0;
        if (!std::isfinite(p) || !std::isfinite(q)) return;
        both += 1;
        squares += (p - q) * (p - q);
        result.max = std::max(result.max, std::abs(p - q));
    });
    result.rms = std::sqrt(shareOf(squares, both));
    result.missing = shareOf(either - both, either);
    return result;
}

Image relativeDifferenceMap(const Image& a, const Image& b)
{
    assert(sameSize(a, b));
    Image map(a.width, a.height, 1);
    eachPixel(a, [&](int x, int y) {
        const glm::dvec3 d = distances(a, b, x, y), reference = colorAt(a, x, y);
        double sum = 0;
        for (int c = 0; c < 3; ++c)
            if (d[c] != 0) sum += d[c] / (lightOf(reference[c]) + relativeFloor);
        map.at(x, y) = static_cast<float>(sum / 3);
    });
    return map;
}

Image differenceMap(const Image& a, const Image& b)
{
    assert(sameSize(a, b));
    Image map(a.width, a.height, 1);
    eachPixel(a, [&](int x, int y) {
        const glm::dvec3 d = distances(a, b, x, y);
        map.at(x, y) = static_cast<float>(std::sqrt(glm::dot(d, d) / 3));
    });
    return map;
}

Image heatMap(const Image& errors, double full)
{
    // Color stops with even steps of lightness, sRGB-encoded.
    static const std::array<glm::dvec3, 6> stations{glm::dvec3(0.02, 0.02, 0.04), glm::dvec3(0.24, 0.07, 0.42),
                                                    glm::dvec3(0.57, 0.16, 0.43), glm::dvec3(0.87, 0.33, 0.23),
                                                    glm::dvec3(0.98, 0.65, 0.18), glm::dvec3(1.0, 0.99, 0.90)};
    Image picture(errors.width, errors.height, 3);
    eachPixel(errors, [&](int x, int y) {
        const double error = errors.at(x, y);
        glm::dvec3 color(0.2, 0.8, 0.3);
        if (std::isfinite(error)) {
            const double place = std::clamp(error / full, 0.0, 1.0) * static_cast<double>(stations.size() - 1);
            const auto below = std::min(static_cast<std::size_t>(place), stations.size() - 2);
            color = glm::mix(stations[below], stations[below + 1], place - static_cast<double>(below));
        }
        for (int c = 0; c < 3; ++c) picture.at(x, y, c) = static_cast<float>(linearFromSrgb(color[c]));
    });
    return picture;
}

Image signedDifference(const Image& reference, const Image& test, double gain)
{
    assert(sameSize(reference, test));
    Image picture(reference.width, reference.height, 3);
    eachPixel(reference, [&](int x, int y) {
        const glm::dvec3 p = colorAt(reference, x, y);
        const glm::dvec3 q = colorAt(test, x, y);
        for (int c = 0; c < 3; ++c) {
            const double d = srgbFromLinear(std::clamp(q[c], 0.0, 1.0)) - srgbFromLinear(std::clamp(p[c], 0.0, 1.0));
            picture.at(x, y, c) = static_cast<float>(linearFromSrgb(std::clamp(0.5 + 0.5 * gain * d, 0.0, 1.0)));
        }
    });
    return picture;
}

}  // namespace vitrine::render
