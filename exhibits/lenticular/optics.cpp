#include "exhibits/lenticular/optics.h"

#include <algorithm>
#include <cmath>

namespace vitrine::lenticular {
namespace {

/// 1 - (1+K) x^2/r^2, of which the surface takes the root.
double underRoot(const Sheet& sheet, double x)
{
    return 1 - (1 + sheet.conic) * x * x / (sheet.radius * sheet.radius);
}

/// Whether the next lens towards the eye hides the surface at x0: the ray must pass that lens where it is
/// tangent to it. `side` is 1 or -1, where the eye is.
bool hidden(const Sheet& sheet, double x0, double theta)
{
    const double side = theta < 0 ? -1 : 1;
    const double angle = std::abs(theta);
    const double half = sheet.pitch() / 2;
    const double cotangent = std::cos(angle) / std::sin(angle);
    const double steepest = half / (sheet.radius * std::sqrt(underRoot(sheet, half)));
    if (!(cotangent < steepest)) return false;  // No part of the next lens rises above this ray.
    const double touch = cotangent * sheet.radius / std::sqrt(1 + cotangent * cotangent * (1 + sheet.conic));
    const auto offset = [&](double x, double depth) { return x * std::cos(angle) + depth * std::sin(angle); };
    return offset(side * x0, sag(sheet, x0)) > offset(sheet.pitch() - touch, sag(sheet, touch));
}

}  // namespace

double sag(const Sheet& sheet, double x0)
{
    return x0 * x0 / (sheet.radius * (1 + std::sqrt(std::max(underRoot(sheet, x0), 0.0))));
}

std::optional<Landing> trace(const Sheet& sheet, double x0, double theta)
{
    const double q = underRoot(sheet, x0);
    if (!(q > 0)) return std::nullopt;
    const double phi = std::atan(x0 / (sheet.radius * std::sqrt(q)));
    const double incidence = theta - phi;
    const double facing = std::cos(incidence);
    if (!(facing > 0) || std::abs(incidence) >= 1.5707963267948966 || hidden(sheet, x0, theta)) return std::nullopt;
    const double psi = phi + std::asin(std::sin(incidence) / sheet.index);
    const double depth = sheet.thickness - sag(sheet, x0);
    return Landing{x0 - depth * std::tan(psi), facing / std::cos(phi), depth, psi};
}

double chiefRay(const Sheet& sheet, double theta)
{
    return -(sheet.thickness - sheet.radius) * std::tan(theta);
}

double paraxial(const Sheet& sheet, double x0, double theta)
{
    const double focus = sheet.index * sheet.radius / (sheet.index - 1);
    return x0 * (1 - sheet.thickness / focus) - sheet.thickness / sheet.index * theta;
}

double effectiveIndex(double index, double beta)
{
    const double sine = std::sin(beta);
    return std::sqrt(index * index - sine * sine) / std::cos(beta);
}

Aperture aperture(const Sheet& sheet, double theta, double beta, int parts)
{
    Sheet skewed = sheet;
    skewed.index = effectiveIndex(sheet.index, beta);
    Aperture result;
    result.parts.reserve(static_cast<std::size_t>(parts));
    const double pitch = sheet.pitch();
    double total = 0;
    std::optional<Landing> left = trace(skewed, -pitch / 2, theta);
    for (int i = 0; i < parts; ++i) {
        const double middle = pitch * ((i + 0.5) / parts - 0.5);
        const std::optional<Landing> at = trace(skewed, middle, theta);
        const std::optional<Landing> right = trace(skewed, pitch * ((i + 1.0) / parts - 0.5), theta);
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

double zoneThroughTop(const Sheet& sheet)
{
    return 2 * std::asin(std::min(1.0, sheet.index * std::sin(std::atan(sheet.pitch() / (2 * sheet.thickness)))));
}

double zoneByExtremeRay(const Sheet& sheet)
{
    const double half = sheet.pitch() / 2;
    const double slope = std::asin(std::min(1.0, half / sheet.radius));
    const double body = sheet.thickness - sag(sheet, half);
    const double inside = slope - std::atan(sheet.pitch() / body);
    return 2 * (slope - std::asin(std::clamp(sheet.index * std::sin(inside), -1.0, 1.0)));
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

}  // namespace vitrine::lenticular
