#include "exhibits/printing/optics.h"

#include "exhibits/printing/lens_cpu.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

/// Returns the sheet as the shader library's lens, at float64. The formulas are shared by the print and the card.
glsl::LensShape shapeOf(const Sheet& sheet)
{
    return {sheet.pitch(), sheet.radius, sheet.thickness, sheet.conic, sheet.index};
}

}  // namespace

double sag(const Sheet& sheet, double x0)
{
    return glsl::lensSag(shapeOf(sheet), x0);
}

std::optional<LensHit> trace(const Sheet& sheet, double x0, double theta)
{
    const glsl::LensRay ray = glsl::lensTrace(shapeOf(sheet), x0, std::sin(theta), std::cos(theta));
    if (!(ray.weight > 0)) return std::nullopt;
    return LensHit{ray.x, ray.weight, ray.depth, std::atan(ray.tanPsi)};
}

double paraxial(const Sheet& sheet, double x0, double theta)
{
    return glsl::lensParaxial(shapeOf(sheet), x0, theta);
}

double effectiveIndex(double index, double beta)
{
    return glsl::lensIndexAskew(index, std::sin(beta));
}

Aperture aperture(const Sheet& sheet, double theta, double beta, int parts)
{
    Sheet skewed = sheet;
    skewed.index = effectiveIndex(sheet.index, beta);
    Aperture result;
    result.parts.reserve(static_cast<std::size_t>(parts));
    const double pitch = sheet.pitch();
    double total = 0;
    std::optional<LensHit> left = trace(skewed, -pitch / 2, theta);
    for (int i = 0; i < parts; ++i) {
        const double middle = pitch * ((i + 0.5) / parts - 0.5);
        const std::optional<LensHit> at = trace(skewed, middle, theta);
        const std::optional<LensHit> right = trace(skewed, pitch * ((i + 1.0) / parts - 0.5), theta);
        if (at) {
            const double from = left ? left->x : at->x;
            const double to = right ? right->x : at->x;
            result.parts.push_back({from, to, at->weight, at->depth, at->psi});
            total += at->weight;
            result.mean += at->weight * at->x;
            result.rms += at->weight * at->x * at->x;
        }
        left = right;
    }
    if (!(total > 0)) return {};
    for (Aperture::Part& part : result.parts) part.share /= total;
    result.mean /= total;
    result.rms = std::sqrt(std::max(result.rms / total - result.mean * result.mean, 0.0));
    return result;
}

double zoneByChiefRay(const Sheet& sheet)
{
    return 2 * std::atan2(sheet.pitch() / 2, sheet.thickness - sheet.radius);
}

double zoneByAperture(const Sheet& sheet)
{
    double low = 0;
    double high = 1.4;  // 80 degrees.
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (aperture(sheet, middle).mean > -sheet.pitch() / 2 ? low : high) = middle;
    }
    return low + high;
}

}  // namespace vitrine::printing
