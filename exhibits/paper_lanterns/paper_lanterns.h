#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/paper_lanterns/paper_lanterns_table.h"

namespace vitrine::paper_lanterns {

/// A lake at night behind a deep frame, with paper lanterns up to the horizon. Start reading with the parameters, then
/// lake_scene.h (positions and motion) and shaders/paper_lanterns: water.glsl and lantern.glsl (geometry), walk.glsl
/// (ray traversal), water_and_paper.glsl and paper.glsl (lighting).
class PaperLanterns final : public Exhibit, public HasButton, public HasSurroundings, public HasLocalLights {
public:
    using Table = PaperLanternsTable;

    [[nodiscard]] std::string_view name() const override { return "paper_lanterns"; }
    [[nodiscard]] std::string_view title() const override { return "Paper Lanterns"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A lake at night with lanterns to the horizon; a ray tests only those that it passes.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "release a lantern with the button, then raise the moon.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "set a lantern free"; }
    [[nodiscard]] int place() const override { return 9; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Returns the opening of the frame.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    [[nodiscard]] double nextChangeOf(const ExhibitState&) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState&) const override;
    /// Returns false: the glow is the sum of many lanterns, whose flicker cancels out.
    [[nodiscard]] bool lightsChange(const ExhibitState&) const override { return false; }
    [[nodiscard]] bool castsShadow() const override { return false; }
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    Table table_;
};

}  // namespace vitrine::paper_lanterns
