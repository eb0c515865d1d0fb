#pragma once

#include "render/files/strict_json.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::hall {

/// Bounced sunlight in the hall for every direction of the sun, computed by assets/models/hall_transfer.py, which
/// describes the method. Parts of floor and walls that the sun can reach are sources of light for the air. Light in the
/// air is stored for the six sides (+x, -x, +y, -y, +z, -z) of small cubes at grid points. Values are irradiance over
/// pi, for a sun of irradiance 1.
class SunTransfer {
public:
    /// Sunlit part of floor or wall, and its light.
    struct Source {
        std::size_t row = 0;  ///< Row of `picture()` with the light that it sends.
        double light = 0;
    };

    /// Grid of points in the air; the first and the last are corners of the box.
    struct Grid {
        render::Box box;
        glm::ivec3 size{0};  ///< Points along each axis; x varies fastest.
    };

    SunTransfer() = default;
    /// Reads the light from the contents of hall_bounce.json and from the pictures that it names. Throws
    /// Json::exception or Failure (ErrorKind::file) if they cannot be read or do not match.
    explicit SunTransfer(const render::Json&);

    /// Returns the sources lit by the sun from a direction in radians: an azimuth as in Sun (any finite angle), and an
    /// elevation, clamped to the range in the file. Interpolates bilinearly between traced directions, so there are no
    /// jumps. Empty if less than one level of 255 comes in.
    [[nodiscard]] std::vector<Source> at(double azimuth, double elevation) const;
    /// Returns an upper bound on the light of these sources anywhere in the air.
    [[nodiscard]] double most(const std::vector<Source>&) const;

    [[nodiscard]] const Grid& grid() const { return grid_; }
    /// Returns the light that each source sends. Each source has one row: the square root of light over `scale(row)`,
    /// for side s of point i in column 6 i + s. Three more rows (red, green, blue) are the light of a sky of radiance
    /// 1. The last three are the tint of the bounced light relative to its mean.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& picture() const { return picture_; }
    [[nodiscard]] double scale(std::size_t row) const { return scales_[row]; }
    [[nodiscard]] std::size_t sourceCount() const { return scales_.size() - 6; }
    /// Returns a texture in the coordinates of the hall's lightmap: the square root, over `surfaceScale`, of a
    /// surface's bounced light relative to the air's.
    [[nodiscard]] const std::shared_ptr<const render::Texture>& surfaces() const { return surfaces_; }
    [[nodiscard]] double surfaceScale() const { return surfaceScale_; }

private:
    std::vector<double> elevations_;  ///< Elevations of the table's rows, radians, increasing.
    std::size_t azimuths_ = 0;        ///< Number of columns, evenly spaced from -180 degrees.
    std::shared_ptr<const render::Texture> suns_, picture_, surfaces_;
    double sunScale_ = 1, surfaceScale_ = 1;
    std::vector<double> scales_;
    Grid grid_;
};

}  // namespace vitrine::hall
