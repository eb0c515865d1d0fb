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

/// A picture being made on a renderer of its own, so that the viewport's stays as it is.
struct PictureJob {
    std::unique_ptr<render::gl::Renderer> renderer;
    std::unique_ptr<PictureMaker> maker;
};

/// A study on a renderer of its own.
struct StudyJob {
    std::unique_ptr<render::RenderBackend> backend;
    std::unique_ptr<Study> study;
    render::Json machine = render::Json::object();  ///< What measures, as files of studies have it.
};

/// A picture of a second look, as a screen shows it.
struct OtherDrawn {
    QImage image;
    render::FrameReport report;
};

/// The renderers of the render thread, which calls everything here between `open` and `close`. Tests put others in
/// their place, which need no graphics.
class Renderers {
public:
    virtual ~Renderers() = default;

    /// Makes a context of its own for this thread, and a renderer on it.
    virtual void open() = 0;
    virtual void close() = 0;
    /// Asked between passes: whether the picture that is being drawn is not wanted any more.
    using Unwanted = std::function<bool()>;
    /// Throws render::gl::Abandoned when it was not wanted any more.
    virtual render::FrameReport draw(const SceneState&, const FrameRequest&, const Unwanted&) = 0;
    /// The last picture as a screen of this many device pixels shows it.
    [[nodiscard]] virtual QImage screenImage(const QSize& screen) = 0;
    /// All `samples` supersamples of a part of a picture whose other pixels stay as they are. The picture that `draw`
    /// made last is left alone.
    [[nodiscard]] virtual QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion&, int samples,
                                            const Unwanted&) = 0;
    /// The same sample of a second look, on a renderer of its own, which is kept until `forgetOther`. What `draw` made
    /// last is left alone.
    [[nodiscard]] virtual OtherDrawn drawOther(const SceneState&, const FrameRequest&, const QSize& /*screen*/)
    {
        return {};
    }
    virtual void forgetOther() {}
    /// The last picture of `draw` as `PictureMaker::picture` gives it; empty where there is none.
    [[nodiscard]] virtual render::Image shownPicture() = 0;
    /// Begins to build, in the background, what draws such pictures faster than what draws them now.
    virtual void buildBetter(const SceneState&, const FrameRequest&) {}
    virtual void timeSteps(bool on) = 0;
    /// Returns whether any picture may have changed.
    virtual bool reloadChangedShaders() = 0;
    [[nodiscard]] virtual std::vector<render::gl::ShaderProblem> problems() const = 0;
    /// A finished picture to make step by step.
    [[nodiscard]] virtual PictureJob makePicture(const SceneState&, const PictureRequest&) = 0;
    /// Another one on the same renderer, which keeps its programs and textures.
    virtual void nextPicture(PictureJob&, const SceneState&, const PictureRequest&) = 0;
    /// A study to make step by step. Throws Failure when there is nothing to measure.
    [[nodiscard]] virtual StudyJob makeStudy(const StudyRequest&) = 0;
    /// A renderer for work of another kind, which may time every step; it ends on this thread, too. Null where there
    /// are no graphics.
    [[nodiscard]] virtual std::unique_ptr<render::RenderBackend> makeBackend(bool /*timesSteps*/) { return nullptr; }
    /// The same sample of a small picture of any look, on a renderer of its own, which is kept until `forgetSmall`, as
    /// a screen of this many pixels shows it.
    [[nodiscard]] virtual QImage drawSmall(const SceneState&, const FrameRequest&, const QSize& /*screen*/)
    {
        return {};
    }
    virtual void forgetSmall() {}
};

}  // namespace vitrine::ui
