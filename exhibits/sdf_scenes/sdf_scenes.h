#pragma once

#include "exhibits/framework/scene/dragged_parameters.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/stands_alone.h"
#include "exhibits/framework/scene/tree.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"

#include <filesystem>

namespace vitrine::scenes {

/// A scene of SDF shapes from a file, seen through a deep frame, with more than 25 public functions because it
/// implements six capabilities. Its tree is compiled to a shader of its own; its parameters become sliders. Read
/// scene.h first, then shown_scene.h (data derived once per scene) and shaders/sdf_scenes/scene.frag.
class SdfScenes final : public Exhibit,
                        public HasButton,
                        public HasSurroundings,
                        public TableFromFiles,
                        public HasDraggedParameters,
                        public HasTree,
                        public StandsAlone {
public:
    using Table = SdfScenesTable;

    /// Starts with the scene file `first` (default: a shipped scene), used while the values name no file. If it cannot
    /// be read, a sphere replaces it, and `dynamicParameters` reports the reason.
    explicit SdfScenes(const std::filesystem::path& first = {});
    [[nodiscard]] std::string_view name() const override { return "sdf_scenes"; }
    [[nodiscard]] std::string_view title() const override { return "SDF Scenes"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A file of shapes becomes a shader; its numbers become sliders.";
    }
    [[nodiscard]] std::string_view tryThis() const override
    {
        return "load a preset, then drag the sliders of its scene.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "let time run"; }
    [[nodiscard]] int place() const override { return 5; }
    [[nodiscard]] bool isComplete() const override { return true; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// Returns the box of the opening.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    /// Returns a camera at the position of the scene's camera.
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] Message whyDisabled(const ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] bool castsShadow() const override { return false; }
    [[nodiscard]] DynamicParameters dynamicParameters(const ParameterValues&, render::AssetStore&) const override;
    [[nodiscard]] std::vector<std::string> furtherFiles(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

    [[nodiscard]] std::vector<DraggedLine> draggedLines(const ExhibitState&, const glm::dvec3& eye) const override;
    [[nodiscard]] double valueUnder(const ExhibitState&, std::size_t row, const render::Ray&) const override;

    // HasTree
    [[nodiscard]] Tree tree(const ParameterValues&) const override;
    [[nodiscard]] std::optional<TreeParameters> parametersOf(const ParameterValues&,
                                                             std::string_view node) const override;
    [[nodiscard]] EditedTree edited(const ParameterValues&, const TreeEdit&, render::AssetStore&) const override;
    [[nodiscard]] ParameterValues withParameter(const ParameterValues&, std::string_view node, std::size_t row,
                                                const Value&, render::AssetStore&) const override;
    [[nodiscard]] ParameterValues withPlace(const ParameterValues&, std::string_view node, const TreePlace& from,
                                            const TreePlace& to, render::AssetStore&) const override;
    [[nodiscard]] std::string pick(const ExhibitState&, const render::Ray&) const override;
    [[nodiscard]] std::optional<TreePlace> placeOf(const ExhibitState&, std::string_view node) const override;
    [[nodiscard]] std::shared_ptr<const TreeShape> shapeOf(const ExhibitState&, std::string_view node) const override;
    [[nodiscard]] DocumentPlace document(const ParameterValues&) const override;
    [[nodiscard]] std::string documentText(const ParameterValues&) const override;
    [[nodiscard]] bool isDocument(const std::string& text) const override;

    // StandsAlone
    [[nodiscard]] ParameterValues standAloneValues(const ParameterValues&) const override;
    [[nodiscard]] StandAloneNumbers standAloneNumbers(const ParameterValues&) const override;

    /// Returns the scene of the values' table; the first scene if that has none.
    [[nodiscard]] const ShownScene& shown(const ParameterValues&) const;

private:
    /// Returns all numbers of the scene at a time of the exhibit's clock. The parameter `look` replaces the file's look
    /// if it names one.
    [[nodiscard]] std::vector<double> numbersAt(const ParameterValues&, double time) const;
    /// Returns the values with another document, and the table made for it.
    [[nodiscard]] ParameterValues withText(const ParameterValues&, std::string text, render::AssetStore&) const;
    /// Returns the placement of the scene behind the frame at a time.
    [[nodiscard]] Portal portalAt(const ParameterValues&, double time) const;
    /// The same, given the result of `numbersAt` for that time.
    [[nodiscard]] Portal portalAt(const ParameterValues&, double time, const std::vector<double>& numbers) const;

    /// Adds one pass: for the whole opening, or for the half on the portal's side with the values of that half.
    void planPart(const std::string& name, const ParameterValues&, const Portal&, const PlanContext&,
                  render::FramePlan&) const;

    Table table_;
    std::shared_ptr<const ShownScene> first_;
    Message whyNotFirst_;
};

}  // namespace vitrine::scenes
