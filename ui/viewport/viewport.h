#pragma once

#include "ui/viewport/camera_control.h"
#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/gallery.h"
#include "ui/model/history.h"

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include <functional>

namespace vitrine::ui {

class Overlay;

/// The picture, and the visitor in it. Draws on demand only.
class Viewport final : public QOpenGLWidget {
    Q_OBJECT

public:
    /// Both must outlive it.
    Viewport(Gallery&, History&, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Glides to the exhibit's best view and orbits it; to the hall's, and walks.
    void visit(std::size_t exhibit);
    /// Glides back to where the visitor was before the last visit or step away from one; emits `visited` for what was
    /// on show there. Nothing while there is no such place.
    void goBack();
    [[nodiscard]] bool canGoBack() const { return !former_.empty(); }
    /// Whose parameters are on show: what E presses while it is orbited.
    void setSubject(std::size_t exhibit) { subject_ = exhibit; }
    void jumpTo(const render::Camera&);
    /// Leaves the exhibit.
    void walkOn();
    [[nodiscard]] CameraControl::Mode mode() const { return control_.mode(); }

    void setPaused(bool);
    [[nodiscard]] bool paused() const { return paused_; }
    /// Times every step: slower, while the ledger is open.
    void setStepsTimed(bool);
    /// Every pass runs, called for or not: the picture must stay the same.
    void setRunEverything(bool);
    void reloadShaders();
    /// The line for the first start; gone at the first step or click.
    void showHint(const QString&);

    [[nodiscard]] const DrawSchedule& schedule() const { return schedule_; }
    [[nodiscard]] double time() const { return time_; }
    /// The finished picture on the screen, in device pixels; nothing while it is still being made.
    [[nodiscard]] std::optional<render::Image> finishedPicture();
    /// Number of pictures drawn since the start: tests count that an idle window draws none.
    [[nodiscard]] long long picturesDrawn() const { return picturesDrawn_; }
    /// Calls `work` with the context current; does nothing before there is one.
    bool withContext(const std::function<void()>& work);

public slots:
    /// Something visible changed.
    void lookChanged();
    /// Presses the button that the look rests on; while an exhibit is orbited, its own.
    void press();

signals:
    void visited(std::size_t exhibit);
    void walkedOn();
    /// The visitor pressed this exhibit's button.
    void pressed(std::size_t exhibit);
    void drawn(const vitrine::render::FrameReport& report, const QSize& pixels);
    /// The context goes, and is current now: what was made on it has to be let go.
    void contextClosing();
    /// Drawing failed; the last good picture stays.
    void failed(const QString& message);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int, int) override;
    bool event(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void leaveEvent(QEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;

private:
    [[nodiscard]] double now() const { return static_cast<double>(steady_.nsecsElapsed()) * 1e-9; }
    [[nodiscard]] FrameRequest request() const;
    void tick();
    void valuesChanged();
    void scheduleNext();
    void draw(const DrawOrder&);
    void closeGl();
    void cameraChanged();
    void showProblems();
    void watchFiles();
    void fail(const std::exception&);
    [[nodiscard]] bool setKey(int key, bool down);
    void click(const QPointF&);
    void pressButton(std::size_t exhibit);
    void remember();
    /// What lies under a point of the widget.
    [[nodiscard]] std::optional<Pointed> pointedAt(const QPointF&) const;
    void hover();
    void forgetHover();
    void releasePointer();

    Gallery& gallery_;
    History& history_;
    CameraControl control_;
    DrawSchedule schedule_;
    WalkKeys keys_;
    QElapsedTimer steady_;
    QTimer timer_;
    QTimer shaderPoll_;
    QTimer fileWatch_;
    std::uint64_t filesDrawn_ = 0;  // Their state, as far as the picture knows.
    double lastTick_ = 0;
    double time_ = 0;         // The exhibits' clock, seconds.
    bool clockRuns_ = false;  // Time passed since the last tick, for someone.
    bool paused_ = false;
    bool runEverything_ = false;
    bool opened_ = false;
    bool drewOnce_ = false;
    long long picturesDrawn_ = 0;
    QString lastFailure_;
    std::vector<ParameterValues> acting_;  // Of the look that was drawn last: what of it acts.
    std::vector<double> pressedAt_;  // Per exhibit, on the exhibits' clock; very negative: never.
    std::optional<LookedAt> lookedAt_;

    struct Former {
        CameraControl::Standpoint standpoint;
        std::size_t subject = 0;
    };
    std::vector<Former> former_;  // The last one last.
    std::size_t subject_ = 0;

    QTimer hoverTimer_;
    std::optional<QPointF> hoverPoint_;  // Where the pointer is while it is over the picture and no button is down.
    QPointF pressPoint_, lastPoint_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool dragged_ = false;

    Overlay* hint_;
    Overlay* label_;
    Overlay* problems_;
    Overlay* name_;
};

/// The format every context of the window asks for: OpenGL 4.5 core, with a debug context in debug builds.
[[nodiscard]] QSurfaceFormat viewportFormat();

}  // namespace vitrine::ui
