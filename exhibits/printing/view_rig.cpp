#include "exhibits/printing/view_rig.h"

#include "exhibits/printing/sheet.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace vitrine::printing {

ViewRig::ViewRig(const PrintLayout& layout, const render::Camera& middle, glm::ivec2 viewSize,
                 const RigSettings& settings)
    : middle_(middle), count_(layout.settings().views), strength_(settings.strength)
{
    const PrintSettings& s = layout.settings();
    if (!(strength_ >= 0) || !std::isfinite(strength_))
        throw Failure(ErrorKind::usage,
                      "The baseline scale is " + shortText(strength_) + "; give 0 or more, 1 for true depth.");
    convergence_ = settings.convergence == 0 ? glm::length(middle.target - middle.eye) : settings.convergence;
    const render::View view = render::makeView(middle, {.size = viewSize});
    if (!(convergence_ > view.nearPlane) || !std::isfinite(convergence_)) {
        throw Failure(ErrorKind::usage, "The convergence plane is at " + shortText(convergence_) +
                                            " m; it must lie in front of the camera, farther than " +
                                            shortText(view.nearPlane) + " m.");
    }
    const double lever = s.sheet.thickness - s.sheet.radius;
    if (!(lever > 0)) {
        throw Failure(ErrorKind::usage,
                      "The sheet " + s.sheet.name + " is " + shortText(s.sheet.thickness) +
                          " mm thick and its lenses have a radius of " + shortText(s.sheet.radius) +
                          " mm: it cannot show views to different directions; choose a thicker sheet.");
    }

    // The line is along the side of the picture closer to the lenses' normal. On slanted lenses it is a longer way
    // across one.
    const bool across = std::abs(s.direction) <= 45;
    shift_ = across ? glm::dvec2(1, 0) : glm::dvec2(0, layout.sine() > 0 ? -1 : 1);
    line_ = glm::transpose(glm::dmat3(view.viewFromWorld)) * glm::dvec3(shift_, 0);
    step_ = layout.printPitch() / lever / count_ / std::abs(across ? layout.cosine() : layout.sine());

    scale_ = 2 * convergence_ * view.tanHalfFov.x / (s.width + 2 * s.bleed);
    freeDepth_ = std::min<double>(count_, layout.wholePixelsPerLens()) * lever;
}

render::Camera ViewRig::camera(int k) const
{
    const double tangent = ((k + 0.5) - 0.5 * count_) * step_ * strength_;
    render::Camera camera = middle_;
    const glm::dvec3 move = line_ * (tangent * convergence_);
    camera.eye += move;
    camera.target += move;
    camera.lensShift -= shift_ * tangent;
    return camera;
}

double ViewRig::baseline() const
{
    return (count_ - 1) * step_ * strength_ * convergence_;
}

DepthRange ViewRig::budget() const
{
    const double infinity = std::numeric_limits<double>::infinity();
    if (strength_ == 0 || count_ == 1) return {0, infinity};
    const double a = freeDepth_ * scale_ / (strength_ * convergence_);
    return {convergence_ / (1 + a), a < 1 ? convergence_ / (1 - a) : infinity};
}

double ViewRig::strengthThatHolds(const DepthRange& range) const
{
    if (count_ == 1) return std::numeric_limits<double>::infinity();
    const double needed = std::max({0.0, convergence_ / range.nearest - 1, 1 - convergence_ / range.farthest});
    // Slightly less, so rounding does not bring the horizon of a fitted rig back to a finite distance.
    return freeDepth_ * scale_ / convergence_ / needed * (1 - 1e-9);
}

DepthRange depthRange(const render::Image& image, double share)
{
    const auto channel = std::find(image.channelNames.begin(), image.channelNames.end(), "depth.Z");
    if (channel == image.channelNames.end()) throw std::out_of_range("a picture without the channel depth.Z");
    const auto at = static_cast<std::size_t>(channel - image.channelNames.begin());
    std::vector<float> depths;
    for (std::size_t i = at; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels))
        depths.push_back(image.pixels[i]);
    const auto left =
        static_cast<std::size_t>(static_cast<double>(depths.size()) * std::clamp(1 - share, 0.0, 1.0) / 2);
    const auto pick = [&](std::size_t n) {
        std::nth_element(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(n), depths.end());
        return static_cast<double>(depths[n]);
    };
    const std::size_t last = depths.size() - 1;
    return {pick(std::min(left, last)), pick(last - std::min(left, last))};
}

std::vector<std::string> warningsOf(const ViewRig& rig, const DepthRange& scene)
{
    const DepthRange budget = rig.budget();
    if (scene.nearest >= budget.nearest && scene.farthest <= budget.farthest) return {};
    const auto meters = [](double d) {
        return std::isinf(d) ? std::string("the horizon") : shortText(std::round(d * 1000) / 1000) + " m";
    };
    const double holds = rig.strengthThatHolds(scene);
    return {"The scene reaches from " + meters(scene.nearest) + " to " + meters(scene.farthest) +
            ", and the print holds " + meters(budget.nearest) + " to " + meters(budget.farthest) +
            " without doubled contours: what lies beyond will show steps. A baseline scale of " +
            shortText(std::floor(holds * 1000) / 1000) + " holds all of it."};
}

}  // namespace vitrine::printing
