#pragma once

#include "exhibits/ice_cream/ice_cream_table.h"
#include "exhibits/kit/sdf_exhibit.h"

namespace vitrine::ice_cream {

/// A soft serve in a wafer with candies: a union of thirty-five solids, of which each point evaluates only the few that
/// can be nearest. Start reading with the parameters, then ice_cream_shape.cpp (meaning of the numbers),
/// shaders/ice_cream/solids.glsl (the field) and sprinkles.cpp. The passes in ice_cream.cpp are added to the march in
/// exhibits/kit.
class IceCream final : public SdfExhibit, public HasButton, public HasSurroundings {
public:
    using Table = IceCreamTable;

    IceCream()
        : SdfExhibit({.field = "ice_cream/field.glsl",
                      .material = "ice_cream/material.glsl",
                      .shading = "ice_cream/shading.glsl"})
    {
    }

    [[nodiscard]] std::string_view name() const override { return "ice_cream"; }
    [[nodiscard]] std::string_view title() const override { return "Soft Serve"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A distance field of 35 solids; each point evaluates only the few that matter there.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "build it up stage by stage, then add sprinkles.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "let it turn"; }
    [[nodiscard]] int place() const override { return 8; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Includes the backdrop, which is drawn whenever it may be visible.
    [[nodiscard]] render::Box boundsOf(const ExhibitState&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] SdfBody body(const ParameterValues&, double time) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override;

private:
    [[nodiscard]] const SdfParameters& rows() const override { return table_; }
    [[nodiscard]] bool isGlass(const ParameterValues&) const override;
    [[nodiscard]] render::Box boxOverTime(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepareBody(const PrepareContext&) const override;
    void complete(SdfBody&, const PreparedPart*) const override;
    void planBeside(const SdfScene&, render::FramePlan&) const override;

    Table table_;
};

}  // namespace vitrine::ice_cream
