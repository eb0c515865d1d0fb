#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/lenticular/lenticular_table.h"

#include <memory>
#include <numbers>

namespace vitrine::lenticular {

/// A glossy card with strips of many views under a sheet of cylindrical lenses, which show each eye a different view.
/// Its two prints scroll like a billboard. Each is a set of views, or the raster of a file that `vitrine print` wrote.
class Lenticular final : public Exhibit, public HasButton, public StandsOnFloor, public HasLocalLights {
public:
    using Table = LenticularTable;

    [[nodiscard]] std::string_view name() const override { return "lenticular"; }
    [[nodiscard]] std::string_view title() const override { return "Lenticular Card"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Sixteen pictures in one print: which one the lenses show depends on where you stand.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "walk past it, then go so near that you see its lenses.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "show the other print"; }
    [[nodiscard]] int place() const override { return 2; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const override;
    /// Prepares the prints in the card, as read and as the shader samples them.
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] double nextChangeOf(const ExhibitState&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] std::vector<StandingShape> standingShapes(const ParameterValues&) const override;
    /// Returns the lamp that is aimed at the card, which lights its surroundings.
    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState&) const override;
    [[nodiscard]] bool lightsChange(const ExhibitState&) const override { return false; }
    void planShadow(const PlanContext&, render::FramePlan&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    Table table_;
};

/// Returns how many prints have scrolled by at `time`. The number is whole while a print rests, for the share `hold` of
/// each period, and then eases to the next. It is 0 at time 0 and for infinite or NaN times.
[[nodiscard]] double scrollAt(double time, double period, double hold);

/// Returns the seconds from `time` to the next change of `scrollAt`: 0 while it scrolls, infinite for infinite or NaN
/// times.
[[nodiscard]] double scrollRest(double time, double period, double hold);

/// Returns the center of the card's front in exhibit space. The card stands on the ledge of its stand and leans against
/// its bar.
[[nodiscard]] glm::dvec3 cardMiddle();

/// Angle by which the card leans back, in radians. Vertical lenses spread the reflection of a lamp to a streak at one
/// height, as a mirror would show it. At this angle, that height is on the card: below the subject for the first view,
/// and between its edges for a standing visitor 1.9 to 4.8 m away.
inline constexpr double cardLean = 18.5 * std::numbers::pi / 180;

/// Returns the position of the lamp that is aimed at the card, in exhibit space: in the hall, at the foot of the vault
/// on the opposite side.
[[nodiscard]] glm::dvec3 cardLamp();

/// Returns the transform from the card's space, with the center of the front at the origin, x to the right, y up along
/// the front and z towards the viewer.
[[nodiscard]] glm::dmat4 exhibitFromCard();

}  // namespace vitrine::lenticular
