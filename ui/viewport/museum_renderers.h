#pragma once

#include "render/gl/context.h"
#include "ui/viewport/renderers.h"

#include <glm/glm.hpp>

#include <memory>

namespace vitrine::ui {

/// Renderers of the museum with OpenGL. The museum must outlive them.
class MuseumRenderers final : public Renderers {
public:
    explicit MuseumRenderers(const Museum& museum) : museum_(museum) {}

    void open() override;
    void close() override;
    render::FrameReport draw(const SceneState&, const FrameRequest&, const IsCanceled&) override;
    [[nodiscard]] QImage screenImage(const QSize& screen) override;
    [[nodiscard]] QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion&, int samples,
                                    const IsCanceled&) override;
    [[nodiscard]] OtherDrawn drawOther(const SceneState&, const FrameRequest&, const QSize& screen) override;
    void forgetOther() override { other_.reset(); }
    [[nodiscard]] QImage drawSmall(const SceneState&, const FrameRequest&, const QSize& screen) override;
    void forgetSmall() override { small_.reset(); }
    void releaseUnused() override;
    [[nodiscard]] render::Image shownPicture() override;
    void buildBetter(const SceneState&, const FrameRequest&) override;
    void timeSteps(bool on) override;
    bool reloadChangedShaders() override;
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override;
    [[nodiscard]] PictureJob makePicture(const SceneState&, const PictureRequest&) override;
    void nextPicture(PictureJob&, const SceneState&, const PictureRequest&) override;
    [[nodiscard]] StudyJob makeStudy(const study::StudyRequest&) override;
    [[nodiscard]] render::Json machine() const override;
    [[nodiscard]] std::unique_ptr<render::RenderBackend> makeBackend(bool timesSteps) override;

    /// Memory of the viewport's renderer, by owner. Empty before `open`. Call on the render thread.
    [[nodiscard]] std::vector<render::gl::Stored> stored() const;

private:
    /// Plans a frame of the initial scene state. What planning computes once, such as the light of the clear sky, is
    /// then ready for the first picture, which is not ordered before the window is laid out.
    void computeAhead() const;

    const Museum& museum_;
    std::unique_ptr<render::gl::HeadlessContext> context_;
    std::unique_ptr<render::gl::DebugLog> debugLog_;  ///< Log of OpenGL messages; in debug builds only.
    std::unique_ptr<render::gl::Renderer> renderer_;
    /// Draws the region in which something moves while the rest is static.
    std::unique_ptr<render::gl::Renderer> regions_;
    std::unique_ptr<render::gl::Renderer> other_;  ///< Draws the settings B.
    std::unique_ptr<render::gl::Renderer> small_;  ///< Draws small pictures, such as thumbnails.
    bool timeSteps_ = false;
    bool hasHalos_ = false;               ///< Whether the last picture of `draw` has halos.
    glm::ivec2 halosPicture_{0};          ///< Size of that picture, in pixels.
    std::shared_ptr<const Halos> halos_;  ///< Its halos, read back when a region first needs them.
};

}  // namespace vitrine::ui
