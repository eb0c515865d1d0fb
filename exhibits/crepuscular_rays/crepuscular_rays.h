#pragma once

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/offers_comparisons.h"

namespace vitrine::crepuscular_rays {

/// Sunbeams through the tall window, drawn over the finished frame. They are smeared from the sky in screen space, or
/// marched through the hall's air. Start reading with the parameters, then `planOverFrame`, then sun_in_picture.h
/// (position of the sun), screen_rays.cpp and air_beams.cpp (the passes).
class CrepuscularRays final : public Exhibit,
                              public HasButton,
                              public OverFrame,
                              public TurnsHangings,
                              public OffersComparisons {
public:
    using Table = CrepuscularRaysTable;

    [[nodiscard]] std::string_view name() const override { return "crepuscular_rays"; }
    [[nodiscard]] std::string_view title() const override { return "Crepuscular Rays"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Sunbeams: the sky blurred across the picture, or rays marched through dusty air.";
    }
    [[nodiscard]] std::string_view tryThis() const override { return "walk until the banner breaks the beam."; }
    [[nodiscard]] std::string_view buttonText() const override { return "let the mobile turn"; }
    [[nodiscard]] int place() const override { return 4; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Returns the bounds of the window, which is what a click selects. The beams reach farther.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    /// Returns the distance to the panes; they span the opening from wall to wall.
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    bool press(ParameterValues&) const override;
    void planOverFrame(const PlanContext&, render::FramePlan&) const override;
    [[nodiscard]] double turnOfHangings(const ParameterValues&, double time) const override;
    /// Offers comparisons with the other technique and with the hall without beams.
    [[nodiscard]] std::vector<OfferedComparison> comparisons() const override;

private:
    Table table_;
};

}  // namespace vitrine::crepuscular_rays
