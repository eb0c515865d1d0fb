#pragma once

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/shows_pictures.h"
#include "exhibits/framework/scene/takes_input.h"
#include "exhibits/framework/scene/text_document.h"
#include "exhibits/your_shader/your_shader_table.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::guest {

struct LoadedPicture;

/// A shader that a visitor brings, on a screen in a frame. Start reading with guest_shader.h (what a shader is),
/// guest_work.h (what is drawn of it) and guest_passes.h (steps and buffers).
class YourShader final : public Exhibit,
                         public HasSurroundings,
                         public TableFromFiles,
                         public ContinuesState,
                         public ShowsPictures,
                         public HasText,
                         public TakesInput {
public:
    using Table = YourShaderTable;

    YourShader();

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
    [[nodiscard]] DocumentPlace document(const ParameterValues&) const override;
    [[nodiscard]] std::string documentText(const ParameterValues&) const override;
    [[nodiscard]] bool isDocument(const std::string& text) const override;
    [[nodiscard]] EditedText withText(const ParameterValues&, const std::string& text,
                                      render::AssetStore&) const override;
    [[nodiscard]] std::vector<TextTemplate> templates() const override;

private:
    void offerPictures(std::vector<PictureSource>) override;
    [[nodiscard]] std::vector<std::string> shownPictures(const ParameterValues&) const override;
    [[nodiscard]] glm::ivec2 pictureSize(const ParameterValues&, std::optional<glm::ivec2> alone) const override;
    void planShowing(const PlanContext&, const render::PersistentState& kept, const PlanPicture&,
                     render::FramePlan&) const override;
    void wasDrawn(const render::FrameReport&) const override;
    [[nodiscard]] std::optional<std::size_t> gripUnder(const ExhibitState&, const render::Ray&,
                                                       double reach) const override;
    [[nodiscard]] ParameterChanges pointed(const ExhibitState&, std::size_t grip, PointerEvent,
                                           const render::Ray&) const override;
    [[nodiscard]] bool takesKeys(const ExhibitState&) const override;
    [[nodiscard]] ParameterChanges keyed(const ExhibitState&, int code, bool isDown) const override;
    [[nodiscard]] std::optional<ParameterChanges> pushed(const ExhibitState&, std::size_t parameter) const override;
    /// Plans the shader with the pictures of its inputs, and the screen that shows it.
    void planScreen(const PlanContext&, const render::PersistentState& kept, const std::vector<LoadedPicture>& ofInputs,
                    render::FramePlan&) const;
    /// Returns the size of the shader's picture. `alone`: as for `pictureSize`.
    [[nodiscard]] glm::ivec2 screenSize(const ParameterValues&, std::optional<glm::ivec2> alone) const;
    /// Returns the time that the shader shows, in seconds.
    [[nodiscard]] double shaderTime(const ExhibitState&) const;
    /// Returns the path of the shader that the values name, or of the first one.
    [[nodiscard]] std::filesystem::path pathOf(const ParameterValues&) const;

    Table table_;
    std::vector<PictureSource> sources_;  ///< Pictures that inputs may show.
    std::shared_ptr<const Table> first_;  ///< With the inputs of the first shader; null if it cannot be read.
};

}  // namespace vitrine::guest
