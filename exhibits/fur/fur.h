#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/fur/coat.h"
#include "exhibits/fur/fur_table.h"

#include <array>
#include <memory>

namespace vitrine::fur {

struct FurScene;

/// Three furry bodies in a pit that jump when the red button is pressed. Shell texturing: the skin is drawn many times,
/// each time a little farther out, and only the pixels inside a strand are kept.
class Fur final : public Exhibit, public HasButton, public HasLocalLights, public SeenInReflections {
public:
    using Table = FurTable;

    Fur();

    [[nodiscard]] std::string_view name() const override { return "fur"; }
    [[nodiscard]] std::string_view title() const override { return "Fur with Physics"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Fur of many layers: the skin is drawn again and again, a little further out. No hair is stored.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "press the button, then look across the fur towards the window.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "make them jump"; }
    [[nodiscard]] int place() const override { return 3; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] render::Box boundsOf(const ExhibitState&) const override;
    /// Prepares the user's model, the skins with their fins, and the states of the bodies.
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const override;
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    [[nodiscard]] double nextChangeOf(const ExhibitState&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    /// Returns the lamp above the pit, which lights the surroundings of the bodies.
    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState&) const override;
    [[nodiscard]] bool lightsChange(const ExhibitState&) const override { return false; }
    /// Returns a cylinder for each body at rest, coat included. The user's model is not considered.
    [[nodiscard]] std::vector<StandingShape> reflectedShapes(const ParameterValues&) const override;
    void planShadow(const PlanContext&, render::FramePlan&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

private:
    struct Prepared;
    /// Adds the simulation to the frame report, once in a plan: shadow and picture both read its state.
    void planMotion(const PlanContext&, render::FramePlan&) const;
    [[nodiscard]] FurScene sceneOf(const PlanContext&, std::uint32_t seed) const;
    void findMotion(const PrepareContext&, Prepared&) const;

    Table table_;
    std::array<std::shared_ptr<const render::Mesh>, furBodyCount> skins_;
};

}  // namespace vitrine::fur
