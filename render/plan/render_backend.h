#pragma once

#include "render/image/image.h"
#include "render/plan/frame_plan.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vitrine::render {

/// Report of a drawn pass. `milliseconds` is negative if it was not measured.
struct StepReport {
    std::string name;
    std::string reason;
    Work work = Work::raster;
    double milliseconds = -1;
    ContributionBound bound;      ///< As Pass::bound.
    std::vector<Effect> effects;  ///< As Pass::effects.
    std::string variant = {};     ///< As Pass::variant.
};

/// Frame report: passes that ran, passes left out, counters and times.
struct FrameReport {
    std::vector<StepReport> ran;
    std::vector<CulledPass> skipped;
    std::map<std::string, std::int64_t> counters;  ///< Exact integers: "passes", "draws", "triangles", "programs", ...
    double milliseconds = 0;                       ///< The whole frame, measured by the clock that `clock` names.
    double wallMilliseconds = 0;                   ///< The whole frame by the wall clock: the time that the user waits.
    std::string stopped;      ///< First pass that was stopped because it took too long (Pass::unbounded), or empty.
    bool unfinished = false;  ///< Another frame is needed: slices are left, or a program is being built.
    std::string clock;        ///< "process CPU time around glFinish", ...
    bool clockTrusted = false;
    double overheadMilliseconds = 0;  ///< Cost of measuring the times; part of `milliseconds`.
};

/// Draws frame plans. The renderer implements it with OpenGL; tests replace it.
class RenderBackend {
public:
    virtual ~RenderBackend() = default;

    /// Throws Failure (ErrorKind::shader) when a program does not build; images drawn before stay readable.
    virtual FrameReport draw(const FramePlan&) = 0;
    /// Returns an image of the last frame. Throws std::out_of_range for a name that was not drawn.
    [[nodiscard]] virtual Image read(const std::string& image) = 0;
    /// State of the persistent images: pass it to Museum::plan.
    [[nodiscard]] virtual const PersistentState& persistentState() const = 0;
    /// Largest width or height of an image that it can draw, in pixels.
    [[nodiscard]] virtual int largestSide() const = 0;
};

}  // namespace vitrine::render
