#pragma once

#include "render/gl/context.h"
#include "ui/viewport/gallery.h"

namespace vitrine::ui {

/// The museum as it is. The museum must outlive it.
class MuseumGallery final : public Gallery {
public:
    explicit MuseumGallery(const Museum& museum) : museum_(museum) {}

    [[nodiscard]] Subjects subjects() const override;
    [[nodiscard]] Look initialLook() const override;
    [[nodiscard]] render::Camera bestView(std::size_t exhibit, const ParameterValues&) const override;
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3& from, const glm::dvec3& to) const override;
    [[nodiscard]] std::optional<LookedAt> lookedAt(const Look&) const override;
    [[nodiscard]] std::optional<Pointed> pick(const Look&, const FrameRequest&, glm::dvec2 ndc) const override;
    [[nodiscard]] std::vector<int> emptyPlaces() const override;
    [[nodiscard]] double nextChange(const Look&, const FrameRequest&) const override;
    [[nodiscard]] std::optional<PictureRegion> movingRegion(const Look&, const FrameRequest&) const override;

    [[nodiscard]] std::vector<std::string> unreadableFiles(const Look&) const override;
    [[nodiscard]] TabledLook readTables(const Look&) const override;

    void open() override;
    void close() override;
    render::FrameReport draw(const Look&, const FrameRequest&, const Unwanted&) override;
    [[nodiscard]] QImage screenImage(const QSize& screen) override;
    [[nodiscard]] QImage drawRegion(const Look&, const FrameRequest&, const PictureRegion&, int samples,
                                    const Unwanted&) override;
    [[nodiscard]] render::Image shownPicture() override;
    void timeSteps(bool on) override;
    bool reloadChangedShaders() override;
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override;
    [[nodiscard]] PictureJob makePicture(const Look&, const PictureRequest&) override;
    void nextPicture(PictureJob&, const Look&, const PictureRequest&) override;
    [[nodiscard]] StudyJob makeStudy(const StudyRequest&) override;

    /// What the viewport's renderer keeps, by owner; nothing before it is open. On the render thread.
    [[nodiscard]] std::vector<render::gl::Stored> stored() const;

private:
    const Museum& museum_;
    std::unique_ptr<render::gl::HeadlessContext> context_;
    std::unique_ptr<render::gl::DebugLog> debugLog_;  ///< In debug builds.
    std::unique_ptr<render::gl::Renderer> renderer_;
    std::unique_ptr<render::gl::Renderer> regions_;  ///< Draws what moves in a picture that stands still.
    bool timeSteps_ = false;
};

}  // namespace vitrine::ui
