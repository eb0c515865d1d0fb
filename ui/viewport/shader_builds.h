#pragma once

#include "ui/viewport/render_thread.h"

#include <QObject>
#include <QTimer>

#include <vector>

namespace vitrine::ui {

/// Builds of the viewport's shaders on the render thread: of files that changed, and of specialized programs. Debug
/// builds of the program look for changed files by themselves.
class ShaderBuilds final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    ShaderBuilds(Renderers&, RenderThread&);

    /// Reloads the shader files that changed.
    void reload();
    /// Begins to build specialized programs, which draw such pictures faster.
    void specialize(const SceneState&, const FrameRequest&);

signals:
    /// Emitted after `reload`. `changed`: any picture may have changed.
    void reloaded(bool changed, const std::vector<vitrine::render::gl::ShaderProblem>& problems);

private:
    Renderers& renderers_;
    RenderThread& thread_;
    QTimer poll_;
};

}  // namespace vitrine::ui
