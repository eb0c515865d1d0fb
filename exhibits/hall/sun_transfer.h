#pragma once

#include "render/files/strict_json.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// What the sun's light bounces to once it has come in through window and oculus, wherever the sun stands:
/// assets/models/hall_transfer.py, which finds it, says how. Parts of floor and walls that the sun can reach are
/// sources of light for the air: for the six sides (+x, -x, +y, -y, +z, -z) of small cubes at points between the walls.
/// In irradiance over pi, of a sun of irradiance 1.
class SunTransfer {
public:
    /// A part of floor or wall in the sun, and its light.
    struct Source {
        std::size_t row = 0;  ///< Of the picture of what it sends.
        double light = 0;
    };

    /// Points in the air; the first and the last are corners of the box.
    struct Grid {
        render::Box box;
        glm::ivec3 size{0};  ///< Along each axis; x runs first.
    };

    SunTransfer() = default;
    /// Reads hall_bounce.json and the pictures that it names. Throws Json::exception or Failure (Blame::file) when they
    /// cannot be read or do not fit together.
    explicit SunTransfer(const render::Json&);

    /// What the sun lights from an azimuth (as Sun's; any finite angle) and an elevation (clamped to 0 to 90 degrees),
    /// radians. Linear between four directions that were traced: it has no jumps. Empty where what comes in lights a
    /// picture by less than one level of 255.
    [[nodiscard]] std::vector<Source> at(double azimuth, double elevation) const;
    /// No place in the air has more light.
    [[nodiscard]] double most(const std::vector<Source>&) const;

    [[nodiscard]] const Grid& grid() const { return grid_; }
    /// What each source sends, a row each: the square root over `scale(row)` for side s of point i in column 6 i + s.
    /// Then three rows (red, green, blue) with the light of a sky of radiance 1, and three with the tint of the
    /// bounced light, over its mean.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& picture() const { return picture_; }
    [[nodiscard]] double scale(std::size_t row) const { return scales_[row]; }
    [[nodiscard]] std::size_t sourceCount() const { return scales_.size() - 6; }
    /// On the hall's lightmap: the square root, over `surfaceScale`, of a surface's bounced light over that of the air.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& surfaces() const { return surfaces_; }
    [[nodiscard]] double surfaceScale() const { return surfaceScale_; }

private:
    std::vector<double> elevations_;  ///< Of the grid's rows, radians, rising.
    std::size_t azimuths_ = 0;        ///< Columns, evenly around from -180 degrees.
    std::shared_ptr<const render::Texture> suns_, picture_, surfaces_;
    double sunScale_ = 1, surfaceScale_ = 1;
    std::vector<double> scales_;
    Grid grid_;
};

}  // namespace vitrine
