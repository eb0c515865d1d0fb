#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/stands_alone.h"
#include "exhibits/noise/noise_table.h"

namespace vitrine::noise {

/// Four works made of noise behind a deep frame: a field, a sum of octaves, a sea and a sky of clouds. Start reading
/// with the parameters, then noise_scene.h (motion and its periods) and the shaders of the works. The noise itself is
/// in shaders/lib/noise.glsl and its neighbors.
class Noise final : public Exhibit, public HasButton, public HasSurroundings, public HasCharts, public StandsAlone {
public:
    using Table = NoiseTable;

    [[nodiscard]] std::string_view name() const override { return "noise"; }
    [[nodiscard]] std::string_view title() const override { return "Noise"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Four works made of noise: a field, its octaves, a sea and a sky of clouds.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "choose the sea and press the button, then choose the clouds.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "let time run"; }
    [[nodiscard]] int place() const override { return 6; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Returns the opening of the frame.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] std::vector<Chart> charts(const ParameterValues&) const override;
    [[nodiscard]] bool castsShadow() const override { return false; }
    void plan(const PlanContext&, render::FramePlan&) const override;
    [[nodiscard]] ParameterValues standAloneValues(const ParameterValues&) const override;
    [[nodiscard]] StandAloneNumbers standAloneNumbers(const ParameterValues&) const override;

private:
    Table table_;
};

}  // namespace vitrine::noise
