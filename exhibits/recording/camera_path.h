#pragma once

#include "render/scene/camera.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine {

/// How fast a path is gone along: at one speed, or from rest to rest.
enum class Pace : std::uint8_t { constant, eased };

/// Where the camera is at `part` (0 to 1) of a motion.
using CameraMotion = std::function<render::Camera(double part)>;

/// A smooth path of a camera through stops: a centripetal Catmull-Rom spline (Yuksel, Schaefer and Keyser 2011,
/// "Parameterization and Applications of Catmull-Rom Curves") of its eye, of the height and the bearing of its look, of
/// the distance to its target and of its field of view. Bearings turn the shorter way round. So it never rolls and
/// never turns over, and the look never passes through the eye, as it would if the target went straight from one to the
/// next.
///
/// Length counts meters of the eye, and 1.5 m for a radian that the look turns.
class CameraPath {
public:
    /// At least one stop; a stop like the one before it is left out. `closed`: back to the first one.
    CameraPath(const std::vector<render::Camera>& stops, bool closed);

    [[nodiscard]] double length() const { return lengths_.back(); }
    /// The camera after that share of the length, clamped to 0 to 1: at 0 and 1 the stops themselves, to the bit.
    [[nodiscard]] render::Camera at(double share) const;
    /// The stop (counted as given to the constructor) that was last passed there.
    [[nodiscard]] std::size_t stopBefore(double share) const;

private:
    /// Eye, bearing and height (radians), logarithm of the distance to the target, field of view.
    using Point = std::array<double, 7>;
    static Point pointOf(const render::Camera&, double bearingBefore);
    [[nodiscard]] Point onLeg(std::size_t leg, double part) const;
    static double distance(const Point&, const Point&);

    std::vector<render::Camera> stops_;
    std::vector<std::size_t> numbers_;  ///< Of each stop, as given.
    std::vector<Point> points_;         ///< One before the first, the stops, and one after the last.
    std::vector<double> lengths_;       ///< At the ends of pieces: `piecesOfLeg` of every leg.
};

/// The share of the way that is behind at `part` of the time, 0 to 1; `eased` is 3 t² - 2 t³.
[[nodiscard]] double paced(Pace, double part);

/// The same camera, gone round the upright axis through its target by `angle`: radians, counter-clockwise from above.
[[nodiscard]] render::Camera turned(const render::Camera&, double angle);

/// Once round like that, beginning with the camera itself, where `angle` is a whole number of turns, which can be shown
/// in a loop; otherwise from half of it on one side to half on the other.
[[nodiscard]] CameraMotion turntable(const render::Camera&, double angle, Pace);
[[nodiscard]] bool isWholeTurns(double angle);

}  // namespace vitrine
