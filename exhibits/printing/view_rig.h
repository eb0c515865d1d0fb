#pragma once

#include "exhibits/printing/print_layout.h"
#include "render/image/image.h"
#include "render/scene/camera.h"

#include <string>
#include <vector>

namespace vitrine::printing {

/// Interval of distances along the view axis, in meters; `farthest` may be infinite.
struct DepthRange {
    double nearest = 0;
    double farthest = 0;
};

/// Arrangement of the cameras of a rig.
struct RigSettings {
    double strength = 1;     ///< Baseline relative to the one that shows true depth; 0: all at one place.
    double convergence = 0;  ///< Meters along the view axis to the plane of the print; 0: to the camera's target.
};

/// Cameras for the views of a print: on a line across the lenses, all with the same direction, and with shifted frusta
/// (not toed in). So the convergence plane is on the same pixels in every view.
///
/// Strips of equal width are equal steps of the tangent of the eye's angle, so the cameras have equal distances. View k
/// is at X = C tan(theta), with tan(theta) = ((k + 1/2)/N - 1/2) p' / (t - r). There an eye would have to be that looks
/// at the convergence plane as at the print. The formula uses the ray through the lens's center of curvature. p' is the
/// pitch of the strips, t the thickness, r the radius, C the distance of the plane.
///
/// View 0 is the leftmost, or the topmost for lenses closer to horizontal. Depth near the plane is then to scale with
/// the width of the picture.
class ViewRig {
public:
    /// `middle` is the camera in the middle of the line; its lens shift is kept. `viewSize` is in pixels; its shape
    /// determines how much of the plane is visible. Throws Failure (ErrorKind::usage) for a strength that is negative
    /// or not finite, a convergence plane not in front of the camera, or a sheet thinner than its radius.
    ViewRig(const PrintLayout&, const render::Camera& middle, glm::ivec2 viewSize, const RigSettings& = {});

    [[nodiscard]] int count() const { return count_; }
    /// Returns the camera of view `k`, from 0.
    [[nodiscard]] render::Camera camera(int k) const;
    /// Returns the meters from the first camera to the last.
    [[nodiscard]] double baseline() const;
    [[nodiscard]] double convergence() const { return convergence_; }
    [[nodiscard]] double strength() const { return strength_; }
    /// Returns meters of the scene, in the convergence plane, per millimeter of print.
    [[nodiscard]] double scale() const { return scale_; }

    /// Returns the depth range without doubled contours, where neighboring views that the print can distinguish differ
    /// by at most one lens. Near the plane that is N (t - r) of print each way. For a sheet in focus it is N t/n (2 N
    /// t/n in all: D. Weissman's figure). Farther away the rig's perspective counts: the range is C / (1 + a) to C / (1
    /// - a) with a = N (t - r) scale / (strength C).
    [[nodiscard]] DepthRange budget() const;
    /// Returns the largest strength whose budget contains `range`; infinite if all of it is in the plane.
    [[nodiscard]] double strengthThatHolds(const DepthRange&) const;

private:
    render::Camera middle_;
    glm::dvec3 line_{1, 0, 0};  ///< Unit vector in world space along which view numbers increase.
    glm::dvec2 shift_{1, 0};    ///< The same direction in the picture, right and up.
    int count_ = 1;
    double convergence_ = 1, strength_ = 1, scale_ = 1;
    double step_ = 0;       ///< Step of tan(theta) from view to view along the line, at strength 1.
    double freeDepth_ = 0;  ///< Depth on the print each way, at strength 1, in millimeters: N (t - r).
};

/// Returns the distances that contain `share` of the pixels of the channel "depth.Z", with equally many left out at
/// both ends. Throws std::out_of_range if there is no such channel.
[[nodiscard]] DepthRange depthRange(const render::Image&, double share = 0.99);

/// Returns full sentences on depth that the print cannot show, with what to do.
[[nodiscard]] std::vector<std::string> warningsOf(const ViewRig&, const DepthRange& scene);

}  // namespace vitrine::printing
