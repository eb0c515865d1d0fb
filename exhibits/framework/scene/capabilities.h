#pragma once

#include "exhibits/framework/scene/chart.h"
#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/scene/standing_shape.h"
#include "exhibits/framework/table/parameters.h"
#include "render/files/asset_store.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"
#include "render/text/message.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

class SceneObject;
struct PlanContext;

/// Parameters that the files in the values add, or the reason why there are none.
struct DynamicParameters {
    std::shared_ptr<const Parameters> table = {};  ///< Null: the values keep their parameters.
    Message why = {};  ///< A full sentence if a file cannot be read (`unreadableFile`); else empty.
};

// Optional capabilities of exhibits. An exhibit derives from Exhibit and from the class of each capability that it has.

/// Capability: a red button at the exhibit's place in the hall.
class HasButton {
public:
    virtual ~HasButton() = default;
    [[nodiscard]] virtual std::string_view buttonText() const = 0;  ///< Text after "E – "; never empty.
    /// Applies a press to the values; returns whether anything changed. The time of the last press is also in
    /// ExhibitState.
    virtual bool press(ParameterValues&) const { return false; }
    /// Returns a full sentence that says why the button is disabled with these values, and what to do; empty if it can
    /// be pressed. A disabled button offers no E, and the window shows the sentence instead.
    [[nodiscard]] virtual Message whyDisabled(const ParameterValues&) const { return {}; }
};

/// Capability: consists only of light, drawn over the frame. It casts no shadow. Where it moves, the whole picture may
/// change.
class OverFrame {
public:
    virtual ~OverFrame() = default;
    /// Called after every exhibit has planned its passes, before the sky.
    virtual void planOverFrame(const PlanContext&, render::FramePlan&) const = 0;
};

/// Capability: transmits colored sunlight. Its `planShadow` then draws the transmitted light, by `castGlassShadow`.
class CastsGlassShadow {
public:
    virtual ~CastsGlassShadow() = default;
    /// Returns true if, with these values, all of its shadow is transmitted light.
    [[nodiscard]] virtual bool castsGlassShadow(const ParameterValues&) const = 0;
};

/// Capability: draws its own surroundings if it is shown alone: a ground, a sky.
class HasSurroundings {
public:
    virtual ~HasSurroundings() = default;
    /// Returns whether it does so with these values. If so, it is planned for every view direction.
    [[nodiscard]] virtual bool surrounds(const ParameterValues&) const = 0;
};

/// Capability: charts with numbers about its picture.
class HasCharts {
public:
    virtual ~HasCharts() = default;
    /// Returns the charts for these values, always the same ones in the same order. Thread-safe; may take a second.
    [[nodiscard]] virtual std::vector<Chart> charts(const ParameterValues&) const = 0;
};

/// Capability: local lights. The hall may have it, too.
class HasLocalLights {
public:
    virtual ~HasLocalLights() = default;
    /// Returns the lamps at this time, in its own space. Called even if the exhibit is out of view, and before anything
    /// is prepared. Lamps of intensity 0 cost nothing.
    [[nodiscard]] virtual std::vector<render::LocalLight> localLights(const ExhibitState&) const = 0;
    /// Returns true if the lamps can change over time at constant parameters. Constant lamps are captured by the
    /// reflection probe, and do not force the whole picture to be redrawn when the exhibit moves.
    [[nodiscard]] virtual bool lightsChange(const ExhibitState&) const { return true; }
};

/// Capability: bodies that darken the floor around them and are reflected in it.
class StandsOnFloor {
public:
    virtual ~StandsOnFloor() = default;
    /// Returns simple shapes of the bodies in its own space, averaged over time. They are not updated while bodies
    /// move, because that would not be visible in the floor's shadows and reflections.
    [[nodiscard]] virtual std::vector<StandingShape> standingShapes(const ParameterValues&) const = 0;
};

/// Capability: bodies that do not stand on the hall's floor, but are visible in reflections of the hall. Bodies on the
/// floor are visible there anyway.
class SeenInReflections {
public:
    virtual ~SeenInReflections() = default;
    /// Returns simple shapes of the bodies in its own space, in their rest position: movement is not visible in
    /// reflections.
    [[nodiscard]] virtual std::vector<StandingShape> reflectedShapes(const ParameterValues&) const = 0;
};

/// Capability: its surface may be a mirror, in which works behind openings in the walls are recognized.
class MirrorsSurroundings {
public:
    virtual ~MirrorsSurroundings() = default;
    /// Returns whether it is a mirror with these values. Its passes then call SceneLighting::mirrorWorks.
    [[nodiscard]] virtual bool mirrors(const ParameterValues&) const = 0;
};

/// Largest roughness of a mirror: above it, reflected pictures are blurred beyond recognition.
inline constexpr double mirrorRoughness = 0.3;

/// Capability: rotates the objects that the building hangs at its place.
class TurnsHangings {
public:
    virtual ~TurnsHangings() = default;
    /// Returns their rotation around their vertical axis, radians; `time` in seconds.
    [[nodiscard]] virtual double turnOfHangings(const ParameterValues&, double time) const = 0;
};

/// Capability: further parameters from files that its values name, for example a scene.
class TableFromFiles {
public:
    virtual ~TableFromFiles() = default;
    /// Returns the parameters for the files that these values name: `parameters()` if they name none. Otherwise,
    /// parameters made through the asset store, the same object for the same files. They contain those of
    /// `parameters()` and more. The exhibit then receives values with these parameters; so a class derived from
    /// Parameters may carry the scene it was made from. Thread-safe; never throws for a file that cannot be read.
    [[nodiscard]] virtual DynamicParameters dynamicParameters(const ParameterValues&, render::AssetStore&) const = 0;
    /// Returns further files that the parameters or pictures of these values depend on, besides those that the values
    /// name. They are watched for changes, too.
    [[nodiscard]] virtual std::vector<std::string> furtherFiles(const ParameterValues&) const { return {}; }
};

/// Returns the subject as that capability; null if it does not have it.
template <typename Capability> [[nodiscard]] const Capability* capability(const SceneObject& subject)
{
    return dynamic_cast<const Capability*>(&subject);
}

}  // namespace vitrine
