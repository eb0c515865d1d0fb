#pragma once

#include "render/plan/history.h"

namespace vitrine {

struct PlanContext;
namespace render {
class FramePlan;
struct FrameReport;
}  // namespace render

/// Capability: draws from the state of the frame before, and plans only the steps that are missing.
class ContinuesState {
public:
    virtual ~ContinuesState() = default;
    /// Does what `Exhibit::plan` does, and is called in its place for the main view. `kept`: content of the renderer's
    /// persistent images. The picture must not depend on it, unless a parameter says so.
    virtual void planFrom(const PlanContext&, const render::PersistentState& kept, render::FramePlan&) const = 0;
    /// Called after a frame was drawn.
    virtual void wasDrawn(const render::FrameReport&) const {}
};

}  // namespace vitrine
