#pragma once

#include "exhibits/framework/chart.h"
#include "exhibits/framework/parameters.h"
#include "exhibits/framework/prepare.h"
#include "exhibits/framework/standing.h"
#include "render/files/asset_store.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

class Subject;
struct PlanContext;

/// The table for the files that values name, or why there is none.
struct CalledTable {
    std::shared_ptr<const Parameters> table = {};  ///< Null: the values keep the one that they have.
    std::string why = {};  ///< A full sentence where a file cannot be read (`unreadableFile`); empty otherwise.
};

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

/// May let the sun through, colored: its `planShadow` then draws what it lets through, by `castGlassShadow`.
class CastsGlassShadow {
public:
    virtual ~CastsGlassShadow() = default;
    /// Whether it does so with these values, and throws no other shadow.
    [[nodiscard]] virtual bool castsGlassShadow(const ParameterValues&) const = 0;
};

/// Draws what surrounds it where it is shown alone: a ground, a sky of its own.
class HasSurroundings {
public:
    virtual ~HasSurroundings() = default;
    /// Whether it does so with these values: then it is planned wherever one looks.
    [[nodiscard]] virtual bool surrounds(const ParameterValues&) const = 0;
};

/// Shows numbers about what it draws, beside the picture.
class HasCharts {
public:
    virtual ~HasCharts() = default;
    /// Of these values, always the same charts in the same order. Any thread may call it; it may take a second.
    [[nodiscard]] virtual std::vector<Chart> charts(const ParameterValues&) const = 0;
};

/// Carries lamps. The hall may, too.
class HasLocalLights {
public:
    virtual ~HasLocalLights() = default;
    /// The lamps at this moment, in its own space; asked for however far it is out of view, and before anything is
    /// prepared. Lights of no intensity cost nothing.
    [[nodiscard]] virtual std::vector<render::LocalLight> localLights(const ExhibitState&) const = 0;
    /// Whether time may make them others, now or later, while the values stay. Those of which it does not, the probe
    /// sees light the hall, and what else moves of their exhibit is drawn without the rest of the picture.
    [[nodiscard]] virtual bool lightsChange(const ExhibitState&) const { return true; }
};

/// Has bodies that darken the floor around them and are mirrored in it.
class StandsOnFloor {
public:
    virtual ~StandsOnFloor() = default;
    /// Simple shapes for them in its own space, as they are in the mean over time: what moves does not move in the
    /// floor.
    [[nodiscard]] virtual std::vector<StandingShape> standingShapes(const ParameterValues&) const = 0;
};

/// Has bodies that do not stand on the hall's floor, and yet are seen in what reflects the hall. What stands on the
/// floor is seen there anyway.
class SeenInReflections {
public:
    virtual ~SeenInReflections() = default;
    /// Simple shapes for them in its own space, as they are at rest: what moves does not move in reflections.
    [[nodiscard]] virtual std::vector<StandingShape> reflectedShapes(const ParameterValues&) const = 0;
};

/// Turns what the building hangs up at its place.
class TurnsHangings {
public:
    virtual ~TurnsHangings() = default;
    /// How far that has turned about its own upright axis, radians; `time` in seconds.
    [[nodiscard]] virtual double turnOfHangings(const ParameterValues&, double time) const = 0;
};

/// Has further rows by the files that its values name: a scene read from a file.
class TableFromFiles {
public:
    virtual ~TableFromFiles() = default;
    /// The table for the files that these values name in rows that give rows: `parameters()` where they name none, else
    /// one made through the asset store, the same for the same files. It has the rows of `parameters()` and more; what
    /// the exhibit is given from then on has this table, so a table derived from Parameters may carry the scene that it
    /// was made of. Any thread may call it, several at once; never throws for a file that cannot be read.
    [[nodiscard]] virtual CalledTable tableFor(const ParameterValues&, render::AssetStore&) const = 0;
    /// What the table of these values was made of beside the files that its rows name, and what is read for pictures of
    /// it: paths that are watched, too.
    [[nodiscard]] virtual std::vector<std::string> furtherFiles(const ParameterValues&) const { return {}; }
};

/// The exhibit as one that does this; null where it does not.
template <typename Capability> [[nodiscard]] const Capability* capability(const Subject& subject)
{
    return dynamic_cast<const Capability*>(&subject);
}

}  // namespace vitrine
