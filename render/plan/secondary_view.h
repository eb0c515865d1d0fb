#pragma once

#include "render/plan/frame_plan.h"

#include <functional>
#include <map>
#include <string>

namespace vitrine::render {

/// Secondary view: the scene drawn again from another viewpoint, for example for the shadow map of a lamp.
struct SecondaryView {
    std::string name;                      ///< Prefix of the names of its passes and images: "lamp".
    std::string reason;                    ///< Reason of its passes, for people: Pass::reason.
    View view;                             ///< `raster.size` is the size of its images; it has no tile.
    PassPhase phase = PassPhase::prepare;  ///< Phase of all its passes: not later than the passes that read its images.
    bool depthOnly = false;  ///< Draws depth alone: the passes up to the opaque ones that write depth, without color,
                             ///< by their `Pass::depthOnly`, and the passes that prepare their inputs.
    /// Decides for a pass of the scene whether it is drawn (true) and may change it. Empty: all passes are drawn
    /// unchanged.
    std::function<bool(Pass&)> take = {};
};

/// Copies the passes of `seen` into `plan`, for another view and with images of their own. `seen` is a plan of the same
/// scene for `elsewhere.view`, not pruned. Passes that do not depend on the view are not copied: simulation, shadow
/// maps, probes, passes with a `contentHash` and passes that write only buffers. The copies read the frame's own images
/// of these passes, and of all others that `seen` reads without drawing them. Returns the new name of every image that
/// is drawn: {"radiance", "lamp.radiance"}, ...
std::map<std::string, std::string> addSecondaryView(FramePlan& plan, const FramePlan& seen,
                                                    const SecondaryView& elsewhere);

}  // namespace vitrine::render
