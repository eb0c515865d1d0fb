#pragma once

#include "exhibits/framework/parameters.h"
#include "render/plan/frame_plan.h"

#include <string_view>

namespace vitrine {

class Subject;
struct PlanContext;

// What only some exhibits do. An exhibit derives from each class whose work it does, beside Exhibit.

/// Has a red button at its place.
class HasButton {
public:
    virtual ~HasButton() = default;
    [[nodiscard]] virtual std::string_view buttonText() const = 0;  ///< After "E – "; never empty.
    /// What a press does to the values; returns whether anything changed. The moment of the last press is in
    /// ExhibitState, besides.
    virtual bool press(ParameterValues&) const { return false; }
};

/// Is made of light alone and laid over the frame. It throws no shadow, and where it moves the whole picture may
/// change.
class OverFrame {
public:
    virtual ~OverFrame() = default;
    /// Called when every exhibit has planned its part, before the sky.
    virtual void planOverFrame(const PlanContext&, render::FramePlan&) const = 0;
};

/// Turns what the building hangs up at its place.
class TurnsHangings {
public:
    virtual ~TurnsHangings() = default;
    /// How far that has turned about its own upright axis, radians; `time` in seconds.
    [[nodiscard]] virtual double turnOfHangings(const ParameterValues&, double time) const = 0;
};

/// The exhibit as one that does this; null where it does not.
template <typename Capability> [[nodiscard]] const Capability* capability(const Subject& subject)
{
    return dynamic_cast<const Capability*>(&subject);
}

}  // namespace vitrine
