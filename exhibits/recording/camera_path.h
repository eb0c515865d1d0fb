#pragma once

#include "render/scene/camera.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::recording {

/// Speed along a path: constant, or starting and ending at rest.
enum class Pace : std::uint8_t { constant, eased };

/// Returns the camera at `part` (0 to 1) of a motion.
using CameraMotion = std::function<render::Camera(double part)>;

/// Smooth camera path through stops: a centripetal Catmull-Rom spline (Yuksel, Schaefer and Keyser 2011,
/// "Parameterization and Applications of Catmull-Rom Curves"). It interpolates the eye, elevation and bearing of the
/// view direction, the distance to the target, and the field of view. Bearings turn the shorter way round.
///
/// So the camera never rolls or turns over. Nor does its direction pass through the eye, as it would if targets were
/// interpolated.
///
/// The length counts meters of the eye, and 1.5 m per radian of rotation of the view direction.
class CameraPath {
public:
    /// At least one stop is needed; a stop equal to the previous one is dropped. `closed` adds the way back to the
    /// first.
    CameraPath(const std::vector<render::Camera>& stops, bool closed);

    [[nodiscard]] double length() const { return lengths_.back(); }
    /// Returns the camera after a share of the length, clamped to [0, 1]. At 0 and 1 it is exactly the first or last
    /// stop.
    [[nodiscard]] render::Camera at(double share) const;
    /// Returns the index of the last passed stop, as given to the constructor.
    [[nodiscard]] std::size_t stopBefore(double share) const;

private:
    /// Eye, bearing and elevation (radians), logarithm of the distance to the target, field of view.
    using Point = std::array<double, 7>;
    static Point pointOf(const render::Camera&, double bearingBefore);
    [[nodiscard]] Point onLeg(std::size_t leg, double part) const;
    static double distance(const Point&, const Point&);

    std::vector<render::Camera> stops_;
    std::vector<std::size_t> numbers_;  ///< Index of each stop, as given.
    std::vector<Point> points_;         ///< The stops, with one more point before and after them.
    std::vector<double> lengths_;       ///< Lengths at the ends of pieces; each leg has `piecesOfLeg`.
};

/// Returns the share of the way at `part` of the time, 0 to 1; `eased` is 3 t² - 2 t³.
[[nodiscard]] double paced(Pace, double part);

/// Returns the camera rotated by `angle` about the vertical axis through its target: radians, counter-clockwise from
/// above.
[[nodiscard]] render::Camera turned(const render::Camera&, double angle);

/// Returns such a rotation as a motion. If `angle` is a whole number of turns, it begins with the camera itself and can
/// be looped. Otherwise it goes from half the angle on one side to half on the other.
[[nodiscard]] CameraMotion turntable(const render::Camera&, double angle, Pace);
[[nodiscard]] bool isWholeTurns(double angle);

}  // namespace vitrine::recording
