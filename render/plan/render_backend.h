#pragma once

#include "render/image/image.h"
#include "render/plan/frame_plan.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vitrine::render {

/// One step of a frame that was drawn. `milliseconds` is negative where it was not measured.
struct StepReport {
    std::string name;
    std::string reason;
    Work work = Work::raster;
    double milliseconds = -1;
    ContributionBound bound;      ///< As Pass::bound.
    std::vector<Effect> effects;  ///< As Pass::effects.
    std::string variant = {};     ///< As Pass::variant.
};

/// The ledger of one frame.
struct FrameReport {
    std::vector<StepReport> ran;
    std::vector<CulledPass> skipped;
    std::map<std::string, std::int64_t> counters;  ///< Exact integers: "passes", "draws", "triangles", "programs", ...
    double milliseconds = 0;                       ///< The whole frame, by the clock named by `clock`.
    double wallMilliseconds = 0;                   ///< The same by the wall clock: what a visitor waits.
    bool unfinished = false;  ///< Another frame is called for: parts are left, or a program is being built.
    std::string clock;        ///< "process CPU time around glFinish", ...
    bool clockTrusted = false;
    double overheadMilliseconds = 0;  ///< What taking the times cost; part of `milliseconds`.
};

/// Draws frame plans. The renderer implements it with OpenGL; tests replace it.
class RenderBackend {
public:
    virtual ~RenderBackend() = default;

    /// Throws Failure (Blame::shader) when a program does not build; what was drawn before stays readable.
    virtual FrameReport draw(const FramePlan&) = 0;
    /// An image of the last frame; throws std::out_of_range for a name that was not drawn.
    [[nodiscard]] virtual Image read(const std::string& image) = 0;
    /// What the kept images hold: pass these to Museum::plan.
    [[nodiscard]] virtual const PersistentState& persistentState() const = 0;
    /// Largest side of an image that it can draw, in pixels.
    [[nodiscard]] virtual int largestSide() const = 0;
};

}  // namespace vitrine::render
