#pragma once

#include "exhibits/printing/print_layout.h"
#include "render/image/image.h"
#include "render/scene/camera.h"

#include <string>
#include <vector>

namespace vitrine::printing {

/// A stretch of distances along the view axis, in meters; `farthest` may be infinite.
struct DepthRange {
    double nearest = 0;
    double farthest = 0;
};

/// How the cameras of a rig stand.
struct RigSettings {
    double strength = 1;  ///< Baseline against the one that shows depth in its true measure; 0: all in one place.
    double convergence =
        0;  ///< Meters along the view axis to what lies in the plane of the print; 0: to the camera's target.
};

/// The cameras that take a print's views: on a line across the lenses, all looking the same way, with shifted
/// frusta (not toed in), so that the convergence plane falls on the same pixels in every view.
///
/// Strips of equal width are equal steps of the tangent of the eye's angle, so the cameras stand at equal
/// distances: view k where an eye that looks at the convergence plane as at the print would have to be,
/// X = C tan(theta), with tan(theta) = ((k + 1/2)/N - 1/2) p' / (t - r) by the ray through the lens's center of
/// curvature (p' pitch of the strips, t thickness, r radius, C distance of the plane). View 0 is the leftmost, for
/// lenses nearer to the horizontal the topmost. Depth near the plane is then as deep as the picture is wide.
class ViewRig {
public:
    /// `middle` is the camera in the middle of the line; its lens shift is kept. `viewSize` is in pixels: its shape
    /// decides how much of the plane is seen. Throws Failure (Blame::usage) for a strength that is negative or not
    /// finite, a convergence plane not in front of the camera, or a sheet thinner than its radius.
    ViewRig(const PrintLayout&, const render::Camera& middle, glm::ivec2 viewSize, const RigSettings& = {});

    [[nodiscard]] int count() const { return count_; }
    /// The camera of view `k`, from 0.
    [[nodiscard]] render::Camera camera(int k) const;
    /// Meters from the first camera to the last.
    [[nodiscard]] double baseline() const;
    [[nodiscard]] double convergence() const { return convergence_; }
    [[nodiscard]] double strength() const { return strength_; }
    /// Meters of the scene, in the convergence plane, per millimeter of print.
    [[nodiscard]] double scale() const { return scale_; }

    /// What shows without doubled contours: where neighboring views that the print can tell apart differ by no more
    /// than one lens. Near the plane that is N (t - r) of print each way, which is N t/n for a sheet in focus (2 N t/n
    /// in all: D. Weissman's figure); beyond, by the rig's own perspective: from C / (1 + a) to C / (1 - a) with
    /// a = N (t - r) scale / (strength C).
    [[nodiscard]] DepthRange budget() const;
    /// The largest strength whose budget holds `range`; infinite when all of it lies in the plane.
    [[nodiscard]] double strengthThatHolds(const DepthRange&) const;

private:
    render::Camera middle_;
    glm::dvec3 line_{1, 0, 0};  ///< Unit length, world space: where view numbers grow.
    glm::dvec2 shift_{1, 0};    ///< The same in the picture, right and up.
    int count_ = 1;
    double convergence_ = 1, strength_ = 1, scale_ = 1;
    double step_ = 0;       ///< Of tan(theta) from view to view, at strength 1, along the line.
    double freeDepth_ = 0;  ///< Of the print, each way, at strength 1, in millimeters: N (t - r).
};

/// The distances that hold `share` of the pixels of the channel "depth.Z", as many left out at either end. Throws
/// std::out_of_range when there is no such channel.
[[nodiscard]] DepthRange depthRange(const render::Image&, double share = 0.99);

/// Full sentences on depth that the print cannot hold, with what to do.
[[nodiscard]] std::vector<std::string> warningsOf(const ViewRig&, const DepthRange& scene);

}  // namespace vitrine::printing
