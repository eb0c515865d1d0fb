#include "exhibits/kit/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

namespace vitrine {
namespace clear_sky {

// Lengths are in kilometers, coefficients per kilometer.
constexpr double groundRadius = 6360;
constexpr double airRadius = 6460;
const glm::dvec3 rayleighScattering{5.802e-3, 13.558e-3, 33.1e-3};
constexpr double mieScattering = 3.996e-3;
constexpr double mieExtinction = 8.396e-3;
const glm::dvec3 ozoneAbsorption{0.650e-3, 1.881e-3, 0.085e-3};
/// Haze beyond that of clear air absorbs a tenth of the light that it takes.
constexpr double furtherMieScattering = 3.996e-3, furtherMieExtinction = 4.44e-3;
constexpr double mieForward = 0.8;  ///< Mean cosine of the scattering angle of haze.

/// Haze in the air, as a multiple of that of clear air.
struct Haze {
    double scattering = mieScattering, extinction = mieExtinction;  ///< Per kilometer, where it is densest.

    explicit Haze(double amount)
        : scattering(mieScattering + (amount - 1) * furtherMieScattering),
          extinction(mieExtinction + (amount - 1) * furtherMieExtinction)
    {
    }
};

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
    /// Calls `valuesAt(height)` for each row, and the function of the cosine that it returns for each cell.
    template <typename ValuesAt> void fill(const ValuesAt& valuesAt)
    {
        for (int row = 0; row < heights_; ++row) {
            const auto valueAt = valuesAt(height(row));
            for (int column = 0; column < cosines_; ++column) cell(row, column) = valueAt(cosine(column));
        }
    }

private:
    int heights_, cosines_;
    std::vector<glm::dvec3> cells_;
};

/// Light in the air of one haze: the transmittance from the sun, and the multiply scattered light.
struct LitAir {
    Haze haze;
    HeightAndSun sunlight{32, 65}, skylight{12, 33};

    explicit LitAir(double amount);
};

namespace {

/// Densities of molecules, haze and ozone, relative to the place where each is densest.
struct AirDensity {
    double molecules, haze, ozone;
};

AirDensity airDensity(double height)
{
    return {std::exp(-height / 8), std::exp(-height / 1.2), std::max(1 - std::abs(height - 25) / 15, 0.0)};
}

glm::dvec3 extinction(const AirDensity& air, const Haze& haze)
{
    return rayleighScattering * air.molecules + glm::dvec3(haze.extinction * air.haze) + ozoneAbsorption * air.ozone;
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
glm::dvec3 sunTransmittance(const glm::dvec3& place, const glm::dvec3& towardsSun, const Haze& haze)
{
    const double radius = glm::length(place);
    const double up = glm::dot(place, towardsSun) / radius;
    if (distanceToSphere(radius, up, groundRadius) > 0 && up < 0) return glm::dvec3(0);
    constexpr int steps = 24;
    const double step = distanceToSphere(radius, up, airRadius) / steps;
    glm::dvec3 depth(0);
    for (int i = 0; i < steps; ++i)
        depth +=
            extinction(airDensity(glm::length(place + towardsSun * ((i + 0.5) * step)) - groundRadius), haze) * step;
    return glm::exp(-depth);
}

glm::dvec3 towards(double cosine)
{
    return {std::sqrt(std::max(1 - cosine * cosine, 0.0)), cosine, 0};
}

/// Paths through the air in all directions from one height, for the multiply scattered light there as isotropic
/// radiance: Hillaire 2020, section 5.5. They are the same for every sun.
class AirPaths {
public:
    AirPaths(double height, const Haze& haze)
    {
        constexpr int steps = 12;
        const glm::dvec3 from{0, groundRadius + height, 0};
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
                const glm::dvec3 scattering =
                    rayleighScattering * air.molecules + glm::dvec3(haze.scattering * air.haze);
                const glm::dvec3 lost = extinction(air, haze);
                const glm::dvec3 kept = glm::exp(-lost * step);
                const glm::dvec3 here = through * scattering * (1.0 - kept) / glm::max(lost, glm::dvec3(1e-12));
                lit_.push_back({place, radius, here});
                again_ += here;
                through *= kept;
            }
            if (down) grounds_.push_back({glm::normalize(from + direction * ground), through});
        }
    }

    [[nodiscard]] glm::dvec3 scattered(double cosine, const HeightAndSun& sunlight) const
    {
        constexpr double isotropic = 1 / (4 * std::numbers::pi);
        const glm::dvec3 groundAlbedo(0.3);
        const glm::dvec3 sun = towards(cosine);
        glm::dvec3 twice(0);
        for (const Lit& at : lit_)
            twice += at.share * sunlight.at(at.radius - groundRadius, glm::dot(at.place, sun) / at.radius) * isotropic;
        for (const Ground& at : grounds_) {
            const double up = std::max(glm::dot(at.normal, sun), 0.0);
            twice += at.through * groundAlbedo * sunlight.at(0, up) * (up / std::numbers::pi);
        }
        return twice / (directions * 1.0) / (1.0 - again_ / (directions * 1.0));
    }

private:
    static constexpr int directions = 48;
    /// Part of a path, and the share of the light there that comes from it.
    struct Lit {
        glm::dvec3 place;
        double radius;
        glm::dvec3 share;
    };
    /// End of a path on the ground, and the share of the light that comes from there.
    struct Ground {
        glm::dvec3 normal, through;
    };

    std::vector<Lit> lit_;
    std::vector<Ground> grounds_;
    glm::dvec3 again_{0};  ///< Share of the light around that the air scatters once more.
};

/// Returns the light in air with this haze. The last few are kept. Thread-safe.
std::shared_ptr<const LitAir> litAir(double haze)
{
    constexpr std::size_t kept = 4;
    static std::mutex mutex;
    static std::list<std::pair<double, std::shared_ptr<const LitAir>>> last;
    const std::lock_guard lock(mutex);
    for (auto air = last.begin(); air != last.end(); ++air)
        if (air->first == haze) {
            last.splice(last.begin(), last, air);
            return air->second;
        }
    last.emplace_front(haze, std::make_shared<const LitAir>(haze));
    if (last.size() > kept) last.pop_back();
    return last.front().second;
}

}  // namespace

LitAir::LitAir(double amount) : haze(amount)
{
    sunlight.fill([&](double height) {
        return [this, height](double cosine) {
            return sunTransmittance({0, groundRadius + height, 0}, towards(cosine), haze);
        };
    });
    skylight.fill([&](double height) {
        return [this, paths = AirPaths(height, haze)](double cosine) { return paths.scattered(cosine, sunlight); };
    });
}

}  // namespace clear_sky

ClearSky::ClearSky(double sunElevation, double haze)
    : air_(clear_sky::litAir(std::isfinite(haze) ? std::clamp(haze, 0.0, 1000.0) : 1.0)), sunElevation_(sunElevation)
{
}

glm::dvec3 ClearSky::sunlight(double height) const
{
    using namespace clear_sky;
    // High up, the sun shines from below the level horizon. The disk sets over its own width.
    const double dip = height > 1 ? std::acos(groundRadius / (groundRadius + height)) : 0;
    const double risen = std::clamp((sunElevation_ + dip) / 0.0093 + 0.5, 0.0, 1.0);
    const double up = std::sin(std::max(sunElevation_, 1e-4 - dip));
    return sunTransmittance({0, groundRadius + height, 0}, towards(up), air_->haze) * (risen * risen * (3 - 2 * risen));
}

glm::dvec3 ClearSky::radiance(double elevation, double fromSun) const
{
    using namespace clear_sky;
    const double sunElevation = sunElevation_;
    const Haze& haze = air_->haze;
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
        const glm::dvec3 here = extinction(air, haze) * step;
        const glm::dvec3 once =
            rayleighScattering * (air.molecules * rayleighPhase) + glm::dvec3(haze.scattering * air.haze * miePhase);
        const glm::dvec3 all = rayleighScattering * air.molecules + glm::dvec3(haze.scattering * air.haze);
        const glm::dvec3 light =
            air_->sunlight.at(radius - groundRadius, up) * once + air_->skylight.at(radius - groundRadius, up) * all;
        sum += light * glm::exp(-(depth + 0.5 * here)) * step;
        depth += here;
    }
    return sum;
}

glm::dvec3 clearSkyRadiance(double sunElevation, double elevation, double fromSun)
{
    return ClearSky(sunElevation).radiance(elevation, fromSun);
}

}  // namespace vitrine
