#pragma once

#include "render/plan/frame_plan.h"

#include <functional>
#include <map>
#include <string>

namespace vitrine::render {

/// The scene seen from elsewhere: where from, and what is done with what is seen.
struct Elsewhere {
    std::string name;                      ///< "lake.mirror": goes before the names of its passes and images.
    std::string reason;                    ///< Of its passes.
    View view;                             ///< `raster.size` is that of its images; no tile.
    PassPhase phase = PassPhase::prepare;  ///< When all of it is drawn: before whoever reads it.
    bool mirrored = false;                 ///< Seen by a `mirroredView`: front faces run the other way round.
    bool depthOnly = false;  ///< Only what hides what: passes that write depth, without color, up to the opaque
                             ///< ones, by their `Pass::depthOnly`, and what they need.
    /// What of the scene belongs here, and what is changed of it: false leaves a pass out. Empty: all of it.
    std::function<bool(Pass&)> take = {};
};

/// Copies what `seen` draws into `plan`, for another view and into images of its own. `seen` is a plan of the same
/// scene for `elsewhere.view`, unpruned. What does not depend on the view stays the frame's own: simulation, shadow
/// maps and probes, what is kept under a key, what only writes buffers, and whatever `seen` reads without drawing it.
/// Returns the new name of every image that it draws: {"radiance", "lake.mirror.radiance"}, ...
std::map<std::string, std::string> addElsewhere(FramePlan& plan, const FramePlan& seen, const Elsewhere& elsewhere);

/// What is seen in a mirror: a point of the mirror shows what this view has at the same place of the picture. `plane`
/// in world space, unit normal: dot(plane, (p, 1)) = 0. What lies behind the mirror, seen from the eye, is clipped
/// away.
[[nodiscard]] View mirroredView(const View&, const glm::dvec4& plane);

/// What is seen through a portal: the picture that `view` has of a world in which the exit lies where the entry is.
/// `exitFromEntry` turns and moves without scaling; `exitPlane` (world space, unit normal towards where one looks)
/// clips away what lies before the exit.
[[nodiscard]] View portalView(const View&, const glm::dmat4& exitFromEntry, const glm::dvec4& exitPlane);

}  // namespace vitrine::render
