#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/hall/hall_scene.h"
#include "exhibits/hall/hall_table.h"

#include <memory>

namespace vitrine {

/// The building: light, walls, shadows, reflections, and the way the picture is developed.
class Hall final : public Exhibit {
public:
    using Table = HallTable;

    explicit Hall(std::shared_ptr<const HallModel> model) : model_(std::move(model)) {}

    [[nodiscard]] std::string_view name() const override { return "hall"; }
    [[nodiscard]] std::string_view title() const override { return hallTitle; }
    [[nodiscard]] std::string_view summary() const override { return hallSummary; }
    [[nodiscard]] int place() const override { return 0; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;

    /// The user's panorama and object.
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;

    /// The hall under these values, which must outlive it, with what was prepared (null: nothing).
    [[nodiscard]] HallScene scene(const ParameterValues&, bool alone, const PreparedPart* prepared) const;

    /// Who stands where: read once, when the museum opens.
    void setGuests(std::vector<Guest> guests);

private:
    Table table_;
    std::shared_ptr<const HallModel> model_;
    std::shared_ptr<const PlaqueText> text_;
    std::vector<Guest> guests_;
};

}  // namespace vitrine
