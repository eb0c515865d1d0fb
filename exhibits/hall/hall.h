#pragma once

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/hall/hall_scene.h"
#include "exhibits/hall/hall_table.h"

#include <memory>

namespace vitrine::hall {

/// The building: light, walls, shadows, reflections and tone mapping.
class Hall final : public SceneObject, public HasLocalLights {
public:
    /// Creates the hall with these exhibits in it. Throws Failure (ErrorKind::file) if the font of the plaques cannot
    /// be read.
    Hall(std::shared_ptr<const HallModel>, std::vector<ExhibitSlot>);

    [[nodiscard]] std::string_view name() const override { return "hall"; }
    [[nodiscard]] std::string_view title() const override { return hallTitle; }
    [[nodiscard]] std::string_view summary() const override { return hallSummary; }
    [[nodiscard]] const HallTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;

    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState&) const override;
    [[nodiscard]] bool lightsChange(const ExhibitState&) const override { return false; }

    /// Reads the user's panorama and objects. Thread-safe.
    [[nodiscard]] std::shared_ptr<const PreparedHall> prepare(const ParameterValues&, render::AssetStore&) const;

    /// Returns the hall's state for these values, which must outlive it, and what was prepared for it (null: nothing).
    [[nodiscard]] HallScene scene(const ParameterValues&, bool alone, const PreparedHall* prepared) const;

    /// Returns these values for the first pictures of a window, which are soon replaced: the reflection probe and the
    /// sun's shadow map are limited in size, because drawing them takes longer than the rest of such a picture.
    [[nodiscard]] ParameterValues whileOpening(const ParameterValues&) const;

private:
    HallTable table_;
    std::shared_ptr<const HallModel> model_;
    std::vector<ExhibitSlot> exhibits_;
    std::shared_ptr<const PlaqueText> text_;
};

}  // namespace vitrine::hall
