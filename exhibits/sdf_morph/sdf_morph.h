#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"

#include <memory>

namespace vitrine {

/// A torus that melts into a mug and back: a signed distance field, marched inside its bounding mesh among
/// rasterized geometry. This folder is the exemplar of an exhibit; it is written to be read in this order:
/// the table (what can be set), this file, the shape (what the numbers mean), the passes (what is drawn).
class SdfMorph final : public Exhibit {
public:
    using Table = SdfMorphTable;

    [[nodiscard]] std::string_view name() const override { return "sdf_morph"; }
    [[nodiscard]] std::string_view title() const override { return "Torus to Mug"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "One body with one hole: a distance field, found anew by every ray.";
    }
    [[nodiscard]] std::string_view tryThis() const override { return "melt it, then look for the window in its side."; }
    [[nodiscard]] std::string_view buttonText() const override { return "let it melt"; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    /// The mesh that the object is compared with: the same for the same shape, whoever asks.
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    void planShadow(const PlanContext&, render::FramePlan&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    Table table_;
};

/// The morph at `time` of an object that starts at `morph` and melts `speed` times a second to the mug and
/// back: a triangle wave, since the melt itself is eased. Exactly `morph` at time 0; any finite time.
[[nodiscard]] double morphAt(double morph, double speed, double time);

}  // namespace vitrine
