#include "render/measure/structure.h"

#include "render/image/srgb.h"
#include "render/measure/color_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vitrine::render {
namespace ssim {
namespace {

constexpr int radius = 5;  // Radius of the window, in pixels.

struct LumaPlane {
    int width = 0, height = 0;
    std::vector<double> values;

    LumaPlane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    [[nodiscard]] double& at(int x, int y)
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] double at(int x, int y) const
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

std::array<double, radius + 1> window()
{
    std::array<double, radius + 1> weights{};
    for (int i = 0; i <= radius; ++i) weights.at(static_cast<std::size_t>(i)) = std::exp(-0.5 * i * i / (1.5 * 1.5));
    return weights;
}

/// Returns the mean under the window along one direction, of the values that are inside of the plane.
LumaPlane blurred(const LumaPlane& plane, int dx, int dy)
{
    static const std::array<double, radius + 1> weights = window();
    LumaPlane result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0, all = 0;
            for (int i = -radius; i <= radius; ++i) {
                const int u = x + i * dx, v = y + i * dy;
                if (u < 0 || v < 0 || u >= plane.width || v >= plane.height) continue;
                const double weight = weights.at(static_cast<std::size_t>(std::abs(i)));
                sum += weight * plane.at(u, v);
                all += weight;
            }
            result.at(x, y) = sum / all;
        }
    return result;
}

LumaPlane blurred(const LumaPlane& plane)
{
    return blurred(blurred(plane, 1, 0), 0, 1);
}

LumaPlane product(const LumaPlane& a, const LumaPlane& b)
{
    LumaPlane result(a.width, a.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
    return result;
}

double luma(const glm::dvec3& c)
{
    const auto code = [](double linear) { return srgbFromLinear(std::clamp(linear, 0.0, 1.0)); };
    return 0.2126 * code(c.x) + 0.7152 * code(c.y) + 0.0722 * code(c.z);
}

bool isFinite(const glm::dvec3& c)
{
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

/// Returns the luma of both pictures. A pixel that is finite in one of them only is black in one and white in the
/// other.
std::pair<LumaPlane, LumaPlane> lumas(const Image& reference, const Image& test)
{
    std::pair<LumaPlane, LumaPlane> both{{reference.width, reference.height}, {reference.width, reference.height}};
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const glm::dvec3 a = colorAt(reference, x, y), b = colorAt(test, x, y);
            both.first.at(x, y) = isFinite(a) ? luma(a) : 0;
            both.second.at(x, y) = isFinite(b) ? luma(b) : 0;
            if (isFinite(a) == isFinite(b)) continue;
            both.first.at(x, y) = 0;
            both.second.at(x, y) = 1;
        }
    return both;
}

}  // namespace
}  // namespace ssim

Image dissimilarityMap(const Image& reference, const Image& test)
{
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const auto [a, b] = ssim::lumas(reference, test);
    const ssim::LumaPlane meanA = ssim::blurred(a), meanB = ssim::blurred(b);
    const ssim::LumaPlane aa = ssim::blurred(ssim::product(a, a)), bb = ssim::blurred(ssim::product(b, b)),
                          ab = ssim::blurred(ssim::product(a, b));
    Image map(reference.width, reference.height, 1);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double p = meanA.values[i], q = meanB.values[i];
        const double variances = std::max(aa.values[i] - p * p, 0.0) + std::max(bb.values[i] - q * q, 0.0);
        const double covariance = ab.values[i] - p * q;
        const double similarity = (2 * p * q + c1) * (2 * covariance + c2) / ((p * p + q * q + c1) * (variances + c2));
        map.pixels[i] = static_cast<float>(0.5 - 0.5 * std::clamp(similarity, -1.0, 1.0));
    }
    return map;
}

double dissimilarity(const Image& reference, const Image& test)
{
    const Image map = dissimilarityMap(reference, test);
    const int margin = std::min(map.width, map.height) > 2 * ssim::radius ? ssim::radius : 0;
    double sum = 0;
    for (int y = margin; y < map.height - margin; ++y)
        for (int x = margin; x < map.width - margin; ++x) sum += static_cast<double>(map.at(x, y));
    const double count = static_cast<double>(map.width - 2 * margin) * (map.height - 2 * margin);
    return count > 0 ? sum / count : 0;
}

}  // namespace vitrine::render
