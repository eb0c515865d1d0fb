#pragma once

#include "exhibits/kit/sdf_exhibit.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"

namespace vitrine::sdf_morph {

/// A torus that melts into a mug and back: a signed distance field, marched inside its bounding box among rasterized
/// geometry. This folder is the example of an exhibit. Read it in this order: the parameters, this file, sdf_morph.cpp
/// (meaning of the numbers), then the kit's sdf_exhibit.h and sdf_passes.cpp (passes).
class SdfMorph final : public SdfExhibit, public HasButton, public StandsOnFloor {
public:
    using Table = SdfMorphTable;

    SdfMorph() : SdfExhibit({.field = "sdf_morph/field.glsl"}) {}

    [[nodiscard]] std::string_view name() const override { return "sdf_morph"; }
    [[nodiscard]] std::string_view title() const override { return "Torus to Mug"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A torus that melts into a mug: a distance field, sphere traced for every pixel.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "press the button to melt it, then find the window mirrored in its side.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "let it melt"; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] SdfBody body(const ParameterValues&, double time) const override;
    [[nodiscard]] std::vector<StandingShape> standingShapes(const ParameterValues&) const override;

private:
    [[nodiscard]] const SdfParameters& rows() const override { return table_; }
    [[nodiscard]] const SdfMaterialParameters* materialParameters() const override { return &table_; }
    [[nodiscard]] render::Box boxOverTime(const ParameterValues&) const override;

    Table table_;
};

/// Returns the morph at `time` of an object that starts at `morph` and melts `speed` times a second to the mug and
/// back. It is a triangle wave, since the melt itself is eased. Exactly `morph` at time 0 and for infinite or NaN
/// times.
[[nodiscard]] double morphAt(double morph, double speed, double time);

}  // namespace vitrine::sdf_morph
