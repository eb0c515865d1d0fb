#pragma once

#include "exhibits/framework/scene/dragged_parameters.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/table/measured_table.h"
#include "exhibits/pixel_art/pixel_art_table.h"

namespace vitrine::pixel_art {

/// A screen in its frame that shows a small world in large pixels: normals found from depth alone, lines of one pixel,
/// a palette. Start reading with the parameters, then pixel_passes.h (passes and their order), small_world.h, palette.h
/// and shaders/pixel_art/normals.glsl.
class PixelArt final : public Exhibit,
                       public HasButton,
                       public HasSurroundings,
                       public HasDraggedParameters,
                       public MeasuresTable {
public:
    using Table = PixelArtTable;
    struct Prepared;

    [[nodiscard]] std::string_view name() const override { return "pixel_art"; }
    [[nodiscard]] std::string_view title() const override { return "Pixel Art"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Pixel art from 3D: normals from depth, lines one pixel wide, few colors.";
    }
    [[nodiscard]] std::string_view tryThis() const override { return "step aside, then change the palette."; }
    [[nodiscard]] std::string_view buttonText() const override { return "let time run"; }
    [[nodiscard]] int place() const override { return 7; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Returns the opening of the frame.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    /// Returns the divider where it is visible on the screen in the hall.
    [[nodiscard]] std::vector<DraggedLine> draggedLines(const ExhibitState&, const glm::dvec3& eye) const override;
    /// Returns the value for the nearest whole texel of the small picture.
    [[nodiscard]] double valueUnder(const ExhibitState&, std::size_t row, const render::Ray&) const override;
    [[nodiscard]] std::string_view tableTitle() const override { return "Methods of normals from depth"; }
    [[nodiscard]] std::unique_ptr<TableMeasurement> measureTable(const ParameterValues&) const override;
    [[nodiscard]] bool castsShadow() const override { return false; }
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    Table table_;
};

}  // namespace vitrine::pixel_art
