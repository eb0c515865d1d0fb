#include "exhibits/hall/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vitrine {
namespace {

// Lengths are in kilometers, coefficients per kilometer.
constexpr double groundRadius = 6360;
constexpr double airRadius = 6460;
const glm::dvec3 rayleighScattering{5.802e-3, 13.558e-3, 33.1e-3};
constexpr double mieScattering = 3.996e-3;
constexpr double mieExtinction = 8.396e-3;
const glm::dvec3 ozoneAbsorption{0.650e-3, 1.881e-3, 0.085e-3};
constexpr double mieForward = 0.8;  ///< Mean cosine of the scattering angle of haze.

/// Densities of molecules, haze and ozone, relative to the place where each is densest.
struct AirDensity {
    double molecules, haze, ozone;
};

AirDensity airDensity(double height)
{
    return {std::exp(-height / 8), std::exp(-height / 1.2), std::max(1 - std::abs(height - 25) / 15, 0.0)};
}

glm::dvec3 extinction(const AirDensity& air)
{
    return rayleighScattering * air.molecules + glm::dvec3(mieExtinction * air.haze) + ozoneAbsorption * air.ozone;
}

/// Returns the distance along a ray to a sphere of radius `sphere` around the center of the earth. The ray begins at
/// `radius` from the center; `up` is the cosine of its angle to the vertical. Negative if the sphere is missed or lies
/// behind.
double distanceToSphere(double radius, double up, double sphere)
{
    const double b = radius * up;
    const double discriminant = b * b - radius * radius + sphere * sphere;
    if (discriminant < 0) return -1;
    const double root = std::sqrt(discriminant);
    return radius > sphere ? -b - root : -b + root;
}

/// Returns the transmittance from the sun to a place; 0 in the shadow of the earth.
glm::dvec3 sunTransmittance(const glm::dvec3& place, const glm::dvec3& towardsSun)
{
    const double radius = glm::length(place);
    const double up = glm::dot(place, towardsSun) / radius;
    if (distanceToSphere(radius, up, groundRadius) > 0 && up < 0) return glm::dvec3(0);
    constexpr int steps = 24;
    const double step = distanceToSphere(radius, up, airRadius) / steps;
    glm::dvec3 depth(0);
    for (int i = 0; i < steps; ++i)
        depth += extinction(airDensity(glm::length(place + towardsSun * ((i + 0.5) * step)) - groundRadius)) * step;
    return glm::exp(-depth);
}

/// Table over height and the cosine of the angle between sun and vertical, interpolated bilinearly.
class HeightAndSun {
public:
    HeightAndSun(int heights, int cosines) : heights_(heights), cosines_(cosines)
    {
        cells_.resize(static_cast<std::size_t>(heights) * static_cast<std::size_t>(cosines));
    }
    /// Heights of rows in kilometers, and cosines of columns. Both are denser where the air changes most: near the
    /// ground, and for a sun at the horizon.
    [[nodiscard]] double height(int row) const
    {
        const double share = static_cast<double>(row) / (heights_ - 1);
        return (airRadius - groundRadius) * share * share;
    }
    [[nodiscard]] double cosine(int column) const
    {
        const double share = 2.0 * column / (cosines_ - 1) - 1;
        return share * std::abs(share);
    }
    glm::dvec3& cell(int row, int column)
    {
        return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(cosines_) +
                      static_cast<std::size_t>(column)];
    }
    [[nodiscard]] glm::dvec3 at(double height, double cosine) const
    {
        const double top = airRadius - groundRadius;
        const double row = std::sqrt(std::clamp(height / top, 0.0, 1.0)) * (heights_ - 1);
        const double root = std::sqrt(std::min(std::abs(cosine), 1.0));
        const double column = (std::copysign(root, cosine) + 1) / 2 * (cosines_ - 1);
        const int r = std::min(static_cast<int>(row), heights_ - 2);
        const int c = std::min(static_cast<int>(column), cosines_ - 2);
        const auto index = static_cast<std::size_t>(r * cosines_ + c);
        const auto below = static_cast<std::size_t>(cosines_);
        return glm::mix(glm::mix(cells_[index], cells_[index + 1], column - c),
                        glm::mix(cells_[index + below], cells_[index + below + 1], column - c), row - r);
    }
    template <typename Value> void fill(const Value& value)
    {
        for (int row = 0; row < heights_; ++row)
            for (int column = 0; column < cosines_; ++column) cell(row, column) = value(height(row), cosine(column));
    }

private:
    int heights_, cosines_;
    std::vector<glm::dvec3> cells_;
};

glm::dvec3 towards(double cosine)
{
    return {std::sqrt(std::max(1 - cosine * cosine, 0.0)), cosine, 0};
}

/// Returns the table of the transmittance from the sun to a height.
const HeightAndSun& sunlight()
{
    static const HeightAndSun table = [] {
        HeightAndSun made(32, 65);
        made.fill([](double height, double cosine) {
            return sunTransmittance({0, groundRadius + height, 0}, towards(cosine));
        });
        return made;
    }();
    return table;
}

/// Returns multiply scattered light as isotropic radiance: Hillaire 2020, section 5.5.
glm::dvec3 manyTimesScattered(double height, double cosine)
{
    constexpr int directions = 48, steps = 12;
    constexpr double isotropic = 1 / (4 * std::numbers::pi);
    const glm::dvec3 groundAlbedo(0.3);
    const glm::dvec3 from{0, groundRadius + height, 0};
    const glm::dvec3 sun = towards(cosine);
    glm::dvec3 twice(0), again(0);
    for (int i = 0; i < directions; ++i) {
        // The golden angle distributes the directions evenly over the sphere.
        const double up = 1 - (2 * i + 1.0) / directions;
        const double turn = i * 2.39996322972865332;
        const double flat = std::sqrt(1 - up * up);
        const glm::dvec3 direction{flat * std::cos(turn), up, flat * std::sin(turn)};
        const double ground = distanceToSphere(from.y, up, groundRadius);
        const bool down = up < 0 && ground > 0;
        const double step = (down ? ground : distanceToSphere(from.y, up, airRadius)) / steps;
        glm::dvec3 through(1);
        for (int k = 0; k < steps; ++k) {
            const glm::dvec3 place = from + direction * ((k + 0.5) * step);
            const double radius = glm::length(place);
            const AirDensity air = airDensity(std::max(radius - groundRadius, 0.0));
            const glm::dvec3 scattering = rayleighScattering * air.molecules + glm::dvec3(mieScattering * air.haze);
            const glm::dvec3 kept = glm::exp(-extinction(air) * step);
            const glm::dvec3 here = through * scattering * (1.0 - kept) / glm::max(extinction(air), glm::dvec3(1e-12));
            twice += here * sunlight().at(radius - groundRadius, glm::dot(place, sun) / radius) * isotropic;
            again += here;
            through *= kept;
        }
        if (!down) continue;
        const glm::dvec3 at = glm::normalize(from + direction * ground);
        const double lit = std::max(glm::dot(at, sun), 0.0);
        twice += through * groundAlbedo * sunlight().at(0, lit) * (lit / std::numbers::pi);
    }
    return twice / (directions * 1.0) / (1.0 - again / (directions * 1.0));
}

const HeightAndSun& skylight()
{
    static const HeightAndSun table = [] {
        HeightAndSun made(12, 33);
        made.fill(manyTimesScattered);
        return made;
    }();
    return table;
}

}  // namespace

glm::dvec3 clearSkyRadiance(double sunElevation, double elevation, double fromSun)
{
    const glm::dvec3 towardsSun{std::cos(sunElevation), std::sin(sunElevation), 0};
    const double along = std::cos(elevation);
    const glm::dvec3 direction{along * std::cos(fromSun), std::sin(elevation), along * std::sin(fromSun)};
    const glm::dvec3 eye{0, groundRadius + 0.2, 0};
    const double ground = distanceToSphere(eye.y, direction.y, groundRadius);
    const double end = direction.y < 0 && ground > 0 ? ground : distanceToSphere(eye.y, direction.y, airRadius);

    const double cosine = glm::dot(direction, towardsSun);
    const double rayleighPhase = 3 / (16 * std::numbers::pi) * (1 + cosine * cosine);
    const double g = mieForward;
    // Cornette and Shanks 1992, "Physically reasonable analytic expression for the single-scattering phase function".
    const double miePhase = 3 / (8 * std::numbers::pi) * (1 - g * g) * (1 + cosine * cosine) /
                            ((2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5));
    constexpr int steps = 48;
    glm::dvec3 depth(0), sum(0);
    double last = 0;
    for (int i = 1; i <= steps; ++i) {
        // Steps are shorter near the eye, where the air is densest.
        const double share = static_cast<double>(i) / steps;
        const double next = end * share * share;
        const double step = next - last;
        const glm::dvec3 place = eye + direction * (last + 0.5 * step);
        last = next;
        const double radius = glm::length(place);
        const double up = glm::dot(place, towardsSun) / radius;
        const AirDensity air = airDensity(std::max(radius - groundRadius, 0.0));
        const glm::dvec3 here = extinction(air) * step;
        const glm::dvec3 once =
            rayleighScattering * (air.molecules * rayleighPhase) + glm::dvec3(mieScattering * air.haze * miePhase);
        const glm::dvec3 all = rayleighScattering * air.molecules + glm::dvec3(mieScattering * air.haze);
        const glm::dvec3 light =
            sunlight().at(radius - groundRadius, up) * once + skylight().at(radius - groundRadius, up) * all;
        sum += light * glm::exp(-(depth + 0.5 * here)) * step;
        depth += here;
    }
    return sum;
}

namespace {

/// Returns the ratio of two sky colors at half the saturation, since the hall's own sky is paler than clear air.
glm::dvec3 tintOf(const glm::dvec3& color, const glm::dvec3& reference)
{
    const glm::dvec3 factor = color / reference;
    const double bright = glm::dot(factor, glm::dvec3(0.2126, 0.7152, 0.0722));
    return glm::sqrt(factor * bright);
}

}  // namespace

SkyTint skyTint(double sunElevation)
{
    // The view is well beside the sun, so its glow does not count as sky. lib/sky.glsl adds the glow.
    constexpr double low = 0.06, beside = 0.6;
    const auto zenith = [](double sun) { return clearSkyRadiance(sun, std::numbers::pi / 2, 0); };
    const auto away = [](double sun) { return clearSkyRadiance(sun, low, std::numbers::pi - beside); };
    static const glm::dvec3 referenceZenith = zenith(referenceSunElevation);
    static const glm::dvec3 referenceHorizon = away(referenceSunElevation);
    const glm::dvec3 horizon = away(sunElevation);
    const glm::dvec3 more = glm::max(clearSkyRadiance(sunElevation, low, beside) - horizon, glm::dvec3(0));
    return {tintOf(zenith(sunElevation), referenceZenith), tintOf(horizon, referenceHorizon),
            more / glm::dot(referenceHorizon, glm::dvec3(0.2126, 0.7152, 0.0722))};
}

}  // namespace vitrine
