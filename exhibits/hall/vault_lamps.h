#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/hall/hall_table.h"
#include "render/files/strict_json.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>
#include <string_view>

namespace vitrine::hall {

/// Current state of the lamps in the coffers of the vault.
struct VaultLamps {
    double share = 0;            ///< Share of their full brightness by the hour, 0 to 1; that of the spotlights, too.
    glm::dvec3 radiance{0};      ///< Radiance of their glass in all directions; linear Rec. 709, in the hall's units.
    std::string_view whyDark{};  ///< Why they do not shine: part of a sentence in the frame report.
};

[[nodiscard]] VaultLamps vaultLampsOf(const HallTable&, const ParameterValues&);

/// Returns the brightness of automatic lamps, 0 to 1. It is 0 until the sun is down to `lampsBegin`, and 1 once it has
/// set, smooth between. `sunElevation` is in radians.
[[nodiscard]] double lampsShareAt(double sunElevation);
inline constexpr double lampsBegin = 0.14;  ///< Radians, 8 degrees.

/// Light in the hall from lamps of radiance 1, without color, computed by assets/models/hall_lamps.py, which describes
/// the method. On the hall's lightmap it is the alpha of the sky's light. In the air it uses the points of SunTransfer.
class LampLight {
public:
    LampLight() = default;
    /// Reads the light from the contents of hall_lamps.json and from the picture that it names. Throws Json::exception
    /// or Failure (ErrorKind::file) if they cannot be read.
    explicit LampLight(const render::Json&);

    /// Returns the irradiance over pi where the square of the lightmap's alpha is 1.
    [[nodiscard]] double surfaceScale() const { return surfaceScale_; }
    /// Returns one row: the square root of light over `airScale`, for side s of point i in column 6 i + s.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& air() const { return air_; }
    [[nodiscard]] double airScale() const { return airScale_; }

private:
    std::shared_ptr<const render::Texture> air_;
    double airScale_ = 1, surfaceScale_ = 1;
};

}  // namespace vitrine::hall
