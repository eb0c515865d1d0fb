#pragma once

#include "exhibits/framework/dragged_rows.h"
#include "exhibits/framework/exhibit.h"
#include "exhibits/framework/tree.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"

#include <filesystem>

namespace vitrine {

/// A scene of shapes from a file, behind a deep frame: its tree becomes a shader of its own, its parameters sliders.
/// Read scene.h, then shown_scene.h (what is made of a scene once) and shaders/sdf_scenes/scene.frag.
class SdfScenes final : public Exhibit,
                        public HasButton,
                        public HasSurroundings,
                        public TableFromFiles,
                        public HasDraggedRows,
                        public HasTree {
public:
    using Table = SdfScenesTable;

    /// With another scene than the shipped one while the values name none. Where it cannot be read, a sphere takes its
    /// place, and `tableFor` says why.
    explicit SdfScenes(const std::filesystem::path& first = {});
    [[nodiscard]] std::string_view name() const override { return "sdf_scenes"; }
    [[nodiscard]] std::string_view title() const override { return "SDF Scenes"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "A file of shapes becomes a shader; its numbers become sliders.";
    }
    [[nodiscard]] std::string_view tryThis() const override { return "load a preset, then drag what is its own."; }
    [[nodiscard]] std::string_view buttonText() const override { return "let time run"; }
    [[nodiscard]] int place() const override { return 5; }
    [[nodiscard]] const Table& parameters() const override { return table_; }
    /// The opening.
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override;
    [[nodiscard]] bool surrounds(const ParameterValues&) const override { return true; }
    /// Where the scene's camera stands.
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    bool press(ParameterValues&) const override;
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues&) const override;
    [[nodiscard]] bool castsShadow() const override { return false; }
    [[nodiscard]] CalledTable tableFor(const ParameterValues&, render::AssetStore&) const override;
    [[nodiscard]] std::vector<std::string> furtherFiles(const ParameterValues&) const override;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const override;
    void plan(const PlanContext&, render::FramePlan&) const override;

    [[nodiscard]] std::vector<DraggedLine> draggedLines(const ExhibitState&, const glm::dvec3& eye) const override;
    [[nodiscard]] double valueUnder(const ExhibitState&, std::size_t row, const render::Ray&) const override;

    // Its tree: sdf_scenes_tree.cpp.
    [[nodiscard]] Tree tree(const ParameterValues&) const override;
    [[nodiscard]] std::optional<TreeRows> rowsOf(const ParameterValues&, std::string_view node) const override;
    [[nodiscard]] EditedTree edited(const ParameterValues&, const TreeEdit&, render::AssetStore&) const override;
    [[nodiscard]] ParameterValues withRow(const ParameterValues&, std::string_view node, std::size_t row, const Value&,
                                          render::AssetStore&) const override;
    [[nodiscard]] ParameterValues withPlace(const ParameterValues&, std::string_view node, const TreePlace& from,
                                            const TreePlace& to, render::AssetStore&) const override;
    [[nodiscard]] std::string pick(const ExhibitState&, const render::Ray&) const override;
    [[nodiscard]] std::optional<TreePlace> placeOf(const ExhibitState&, std::string_view node) const override;
    [[nodiscard]] std::shared_ptr<const TreeShape> shapeOf(const ExhibitState&, std::string_view node) const override;
    [[nodiscard]] TreeDocument document(const ParameterValues&) const override;
    [[nodiscard]] std::string documentText(const ParameterValues&) const override;
    [[nodiscard]] bool isDocument(const std::string& text) const override;

private:
    /// Of these values' table, or the one that is there at first.
    [[nodiscard]] const scenes::ShownScene& shown(const ParameterValues&) const;
    /// All numbers of the scene at that time of the exhibit's clock, its look in place of the file's where asked for.
    [[nodiscard]] std::vector<double> numbersAt(const ParameterValues&, double time) const;
    /// With another document, and the table of it.
    [[nodiscard]] ParameterValues withText(const ParameterValues&, std::string text, render::AssetStore&) const;
    /// Where the scene lies behind the frame at that time.
    [[nodiscard]] Portal portalAt(const ParameterValues&, double time) const;
    /// The same with `numbersAt` of that time, where these are there already.
    [[nodiscard]] Portal portalAt(const ParameterValues&, double time, const std::vector<double>& numbers) const;

    /// One pass: of all, or of the half on the portal's side with the values of that half.
    void planPart(const std::string& name, const ParameterValues&, const Portal&, const PlanContext&,
                  render::FramePlan&) const;

    Table table_;
    std::shared_ptr<const scenes::ShownScene> first_;
    std::string whyNotFirst_;
};

}  // namespace vitrine
