#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/viewport/exhibit_clock.h"
#include "ui/viewport/interaction.h"
#include "ui/viewport/present_scene.h"
#include "ui/viewport/render_thread.h"
#include "ui/viewport/shader_builds.h"
#include "ui/viewport/viewport_input.h"
#include "ui/viewport/viewport_notices.h"
#include "ui/viewport/viewport_pictures.h"
#include "ui/viewport/visitor.h"

#include <QOpenGLWidget>

#include <memory>

class QPainter;

namespace vitrine::ui {

/// Widget that shows the museum's picture, with the visitor in it. It shows the last picture of the render thread and
/// draws none itself. It joins its parts, which callers use directly.
class Viewport final : public QOpenGLWidget, public AccessibleContent {
    Q_OBJECT

public:
    /// All must outlive the viewport.
    Viewport(const Museum&, Renderers&, History&, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] ExhibitClock& clock() { return clock_; }
    [[nodiscard]] Visitor& visitor() { return visitor_; }
    [[nodiscard]] PresentScene& scene() { return scene_; }
    [[nodiscard]] Interaction& interaction() { return interaction_; }
    [[nodiscard]] ViewportInput& input() { return input_; }
    [[nodiscard]] ViewportNotices& notices() { return notices_; }
    [[nodiscard]] ViewportPictures& pictures() { return pictures_; }
    [[nodiscard]] ShaderBuilds& shaders() { return shaders_; }
    [[nodiscard]] RenderThread& renderThread() { return *thread_; }

    /// While on, another picture lies over this one, and names and handles are hidden.
    void setCovered(bool);
    [[nodiscard]] bool covered() const { return covered_; }
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Graphic; }
    [[nodiscard]] QString accessibleText() const override;

signals:
    /// Emitted when the camera, time or size of the picture changed, or whether it is covered.
    void looked();

protected:
    void paintGL() override;
    void resizeGL(int, int) override;

private:
    void connectParts();
    void connectInput();
    void paintOpening(QPainter&);
    void cameraChanged(bool cut);
    /// Hides the notice of the destination once the visitor is there, or if no picture of it comes.
    void noteArrival(const DrawnPicture&);
    void showProblems(const std::vector<render::gl::ShaderProblem>&);

    History& history_;
    ExhibitClock clock_;
    Visitor visitor_;
    PresentScene scene_;
    Interaction interaction_;
    ViewportInput input_;
    ViewportNotices notices_;
    std::unique_ptr<RenderThread> thread_;
    ViewportPictures pictures_;
    ShaderBuilds shaders_;
    bool covered_ = false;
};

}  // namespace vitrine::ui
