#pragma once

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/your_shader/your_shader_table.h"

namespace vitrine {

/// A shader that a visitor brings, on a screen in a frame. Start reading with guest_shader.h (what a shader is),
/// guest_work.h (what is drawn of it) and guest_passes.h (steps and buffers).
class YourShader final : public Exhibit, public HasSurroundings, public TableFromFiles, public ContinuesState {
public:
    using Table = YourShaderTable;

    [[nodiscard]] std::string_view name() const override { return "your_shader"; }
    [[nodiscard]] std::string_view title() const override { return "Your Shader"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A shader of your own on a screen; its inputs become sliders.";
    }
    [[nodiscard]] std::string_view tryThis() const override { return "name a file of yours, or load a preset."; }
    [[nodiscard]] int place() const override { return 10; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    [[nodiscard]] double nextChangeOf(const ExhibitState&) const override;
    [[nodiscard]] bool castsShadow() const override { return false; }
    [[nodiscard]] DynamicParameters dynamicParameters(const ParameterValues&, render::AssetStore&) const override;
    [[nodiscard]] std::vector<std::string> furtherFiles(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;
    void planFrom(const PlanContext&, const render::PersistentState& kept, render::FramePlan&) const override;

private:
    Table table_;
};

}  // namespace vitrine
