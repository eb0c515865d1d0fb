#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/lenticular/lenticular_table.h"

#include <memory>

namespace vitrine {

/// A glossy card that one walks past: strips of many views under a sheet of cylindrical lenses, which show
/// each eye another view. Two prints roll by, like a billboard's. Either is a set of views, or the very raster
/// of a file that `vitrine print` wrote.
class Lenticular final : public Exhibit, public HasButton, public StandsOnFloor, public HasLocalLights {
public:
    using Table = LenticularTable;

    [[nodiscard]] std::string_view name() const override { return "lenticular"; }
    [[nodiscard]] std::string_view title() const override { return "Lenticular Card"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Sixteen pictures in one print: the lenses choose, by where you stand.";
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
    /// The prints that lie in the card, as read and as the shader samples them.
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] double nextChangeOf(const ExhibitState&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] std::vector<StandingShape> standingShapes(const ParameterValues&) const override;
    /// The lamp that is aimed at the card, on what is beside it.
    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState&) const override;
    [[nodiscard]] bool lightsChange(const ExhibitState&) const override { return false; }
    void planShadow(const PlanContext&, render::FramePlan&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    Table table_;
};

/// How many prints have rolled by at `time`: whole while one rests, for the share `hold` of each period, then
/// eased to the next. 0 at time 0; time that is not finite counts as 0.
[[nodiscard]] double scrollAt(double time, double period, double hold);

/// Seconds from `time` to the next change of `scrollAt`: 0 while it rolls.
[[nodiscard]] double scrollRest(double time, double period, double hold);

/// The middle of the card's front, in the exhibit's space: the card stands on the ledge of its stand.
[[nodiscard]] glm::dvec3 cardMiddle();

}  // namespace vitrine
