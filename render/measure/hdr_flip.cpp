#include "render/measure/hdr_flip.h"

#include "render/measure/color_at.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vitrine::render {
namespace hdr {
namespace {

/// Coefficients of the curve (a x² + b x) / (c x² + d x + e), with the factor 0.6 that cancels its pre-exposure.
constexpr double a = 0.6 * 0.6 * 2.51, b = 0.6 * 0.03, c = 0.6 * 0.6 * 2.43, d = 0.6 * 0.59, e = 0.14;
constexpr double shown = 0.85;  ///< Display value of the brightest and of the median luminance.

/// Returns the light that the curve shows as `shown`: the positive root of a quadratic equation.
double lightShown()
{
    const double p = (b - d * shown) / (a - c * shown), q = -e * shown / (a - c * shown);
    return -0.5 * p + std::sqrt(0.25 * p * p - q);
}

glm::dvec3 lightAt(const Image& image, int x, int y)
{
    constexpr double largest = 65504;
    glm::dvec3 light = colorAt(image, x, y);
    for (int i = 0; i < 3; ++i) light[i] = light[i] > 0 ? std::min(light[i], largest) : 0;
    return light;
}

Image atExposure(const Image& image, double stops)
{
    Image mapped(image.width, image.height, 3);
    const double factor = std::exp2(stops);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec3 light = factor * lightAt(image, x, y);
            for (int i = 0; i < 3; ++i) mapped.at(x, y, i) = static_cast<float>(hdrFlipToneCurve(light[i]));
        }
    return mapped;
}

/// Returns the median: of an even number of values, the mean of the two in the middle.
double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace
}  // namespace hdr

double hdrFlipToneCurve(double light)
{
    using namespace hdr;
    return std::clamp((a * light * light + b * light) / (c * light * light + d * light + e), 0.0, 1.0);
}

std::vector<double> hdrFlipExposures(const Image& reference)
{
    std::vector<double> luminances;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            luminances.push_back(glm::dot(hdr::lightAt(reference, x, y), glm::dvec3(0.2126, 0.7152, 0.0722)));
    if (luminances.empty()) return {0, 0};
    constexpr double least = std::numeric_limits<float>::epsilon();  // Keeps a black picture's exposures finite.
    const double start =
        std::log2(hdr::lightShown() / std::max(*std::max_element(luminances.begin(), luminances.end()), least));
    const double stop = std::log2(hdr::lightShown() / std::max(hdr::medianOf(luminances), least));
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    std::vector<double> exposures;
    for (int i = 0; i < count; ++i) exposures.push_back(start + (stop - start) * i / (count - 1));
    return exposures;
}

Image hdrFlipMap(const Image& reference, const Image& test, double pixelsPerDegree)
{
    assert(reference.width == test.width && reference.height == test.height);
    Image largest(reference.width, reference.height, 1);
    for (const double stops : hdrFlipExposures(reference)) {
        const Image errors = flipMap(hdr::atExposure(reference, stops), hdr::atExposure(test, stops), pixelsPerDegree);
        std::transform(errors.pixels.begin(), errors.pixels.end(), largest.pixels.begin(), largest.pixels.begin(),
                       [](float x, float y) { return std::max(x, y); });
    }
    return largest;
}

double hdrFlip(const Image& reference, const Image& test, double pixelsPerDegree)
{
    return meanOfMap(hdrFlipMap(reference, test, pixelsPerDegree));
}

}  // namespace vitrine::render
