#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/hall/hall_table.h"
#include "render/files/strict_json.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>
#include <string_view>

namespace vitrine {

/// The lamps in the coffers of the vault, as they burn.
struct VaultLamps {
    glm::dvec3 radiance{0};      ///< Of their glass, to all sides; linear Rec. 709, in the hall's units.
    std::string_view whyDark{};  ///< Where they do not burn: one sentence's part for the ledger.
};

[[nodiscard]] VaultLamps vaultLampsOf(const HallTable&, const ParameterValues&);

/// How bright lamps burn that are lit by themselves, 0 to 1: none before the sun is `lampsBegin` low, all once it has
/// set; smooth between. `sunElevation` in radians.
[[nodiscard]] double lampsShareAt(double sunElevation);
inline constexpr double lampsBegin = 0.14;  ///< Radians, 8 degrees.

/// What lamps of radiance 1 send to the hall, without color: assets/models/hall_lamps.py, which finds it, says how. On
/// the hall's lightmap it is the alpha of the sky's light; in the air it stands on the points of SunTransfer.
class LampLight {
public:
    LampLight() = default;
    /// Reads hall_lamps.json and the picture that it names. Throws Json::exception or Failure (Blame::file) when they
    /// cannot be read.
    explicit LampLight(const render::Json&);

    /// Irradiance over pi where the square of the lightmap's alpha is 1.
    [[nodiscard]] double surfaceScale() const { return surfaceScale_; }
    /// One row: the square root, over `airScale`, for side s of point i in column 6 i + s.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& air() const { return air_; }
    [[nodiscard]] double airScale() const { return airScale_; }

private:
    std::shared_ptr<const render::Texture> air_;
    double airScale_ = 1, surfaceScale_ = 1;
};

}  // namespace vitrine
