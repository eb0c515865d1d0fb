#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/museum/picture.h"
#include "exhibits/study/study.h"
#include "render/files/strict_json.h"
#include "render/gl/renderer.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace vitrine::ui {

/// Picture job on a renderer of its own, so that the viewport's renderer keeps its state.
struct PictureJob {
    std::unique_ptr<render::gl::Renderer> renderer;
    std::unique_ptr<PictureMaker> maker;
};

/// Study job on a renderer of its own.
struct StudyJob {
    std::unique_ptr<render::RenderBackend> backend;
    std::unique_ptr<study::Study> study;
    /// Description of the measuring machine, as written to the files of studies.
    render::Json machine = render::Json::object();
};

/// Picture of the settings B, as the screen shows it.
struct OtherDrawn {
    QImage image;
    render::FrameReport report;
};

/// Renderers of the render thread, which calls all functions between `open` and `close`. Tests replace them by others
/// that need no graphics.
class Renderers {
public:
    virtual ~Renderers() = default;

    /// Makes an OpenGL context for the calling thread, and a renderer on it.
    virtual void open() = 0;
    virtual void close() = 0;
    /// Polled between passes. Returns whether the picture is no longer wanted.
    using IsCanceled = std::function<bool()>;
    /// Draws one sample. Throws render::gl::Abandoned if `IsCanceled` returned true.
    virtual render::FrameReport draw(const SceneState&, const FrameRequest&, const IsCanceled&) = 0;
    /// Returns the last picture, scaled to this many device pixels.
    [[nodiscard]] virtual QImage screenImage(const QSize& screen) = 0;
    /// Draws all `samples` supersamples of a region of a picture whose other pixels stay the same. Leaves the last
    /// picture of `draw` alone.
    [[nodiscard]] virtual QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion&, int samples,
                                            const IsCanceled&) = 0;
    /// Returns a description of what draws, as written to the files of studies and comparisons.
    [[nodiscard]] virtual render::Json machine() const { return render::Json::object(); }
    /// Draws the same sample of the settings B on a renderer of its own, which is kept until `forgetOther`. Leaves the
    /// last picture of `draw` alone.
    [[nodiscard]] virtual OtherDrawn drawOther(const SceneState&, const FrameRequest&, const QSize& /*screen*/)
    {
        return {};
    }
    virtual void forgetOther() {}
    /// Returns the last picture of `draw`, in the format of `PictureMaker::picture`; empty if there is none.
    [[nodiscard]] virtual render::Image shownPicture() = 0;
    /// Begins to build specialized programs in the background, which draw such pictures faster.
    virtual void buildBetter(const SceneState&, const FrameRequest&) {}
    virtual void timeSteps(bool on) = 0;
    /// Reloads shader files that changed. Returns whether any picture may have changed.
    virtual bool reloadChangedShaders() = 0;
    [[nodiscard]] virtual std::vector<render::gl::ShaderProblem> problems() const = 0;
    /// Makes a job that draws a finished picture step by step.
    [[nodiscard]] virtual PictureJob makePicture(const SceneState&, const PictureRequest&) = 0;
    /// Begins another picture on the job's renderer, which keeps its programs and textures.
    virtual void nextPicture(PictureJob&, const SceneState&, const PictureRequest&) = 0;
    /// Makes a study to run step by step. Throws Failure if there is nothing to measure.
    [[nodiscard]] virtual StudyJob makeStudy(const study::StudyRequest&) = 0;
    /// Makes a renderer for other work, which times every pass if `timesSteps`. Destroy it on this thread. Null if
    /// there are no graphics.
    [[nodiscard]] virtual std::unique_ptr<render::RenderBackend> makeBackend(bool /*timesSteps*/) { return nullptr; }
    /// Draws the given sample of a small picture of any scene state, scaled to this many device pixels. Uses a renderer
    /// of its own, which is kept until `forgetSmall`.
    [[nodiscard]] virtual QImage drawSmall(const SceneState&, const FrameRequest&, const QSize& /*screen*/)
    {
        return {};
    }
    virtual void forgetSmall() {}
    /// Frees what the last picture does not need, and what would be made again when it is needed. For times when
    /// nothing is drawn.
    virtual void releaseUnused() {}
};

}  // namespace vitrine::ui
