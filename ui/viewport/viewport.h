#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/model/history.h"
#include "ui/viewport/camera_control.h"
#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/file_watch.h"
#include "ui/viewport/prepared_state.h"
#include "ui/viewport/render_thread.h"
#include "ui/viewport/renderers.h"
#include "ui/viewport/shown_picture.h"

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include <cmath>
#include <functional>

class QPainter;

namespace vitrine::ui {

class Overlay;
class ReadingNotice;
struct Handling;
class ViewportInput;

/// Widget that shows the museum's picture, and the visitor in it. It shows the last picture of the render thread and
/// draws none itself. Pictures are ordered on demand, one at a time.
class Viewport final : public QOpenGLWidget, public AccessibleContent {
    Q_OBJECT

public:
    /// All must outlive the viewport.
    Viewport(const Museum&, Renderers&, History&, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Visits an exhibit: glides to its best view and orbits it. Visiting the hall glides to its best view and walks.
    void visit(std::size_t exhibit);
    /// True while an exhibit without a place in the hall is visited: it is shown alone, in its own space.
    [[nodiscard]] bool isInDepot() const;
    /// Glides back to where the visitor was before the last visit or walk away, and emits `visited` for the subject
    /// there. Does nothing without such a place.
    void goBack();
    [[nodiscard]] bool canGoBack() const { return !former_.empty(); }
    /// Returns whether `press` has a button to press.
    [[nodiscard]] bool canPress() const;
    /// Sets the subject whose parameters are shown. `press` presses its button while it is orbited.
    void setSubject(std::size_t exhibit) { subject_ = exhibit; }
    void jumpTo(const render::Camera&);
    /// Returns the visitor's own objects in the hall, as far as their files are read.
    [[nodiscard]] std::vector<OwnObjectShown> ownObjects() const { return museum_.ownObjects(prepared()); }
    /// Glides to one of the visitor's own objects.
    void visit(const OwnObjectShown&);
    /// Glides to a camera. The visitor then walks if the eye is at a visitor's height on free floor, and orbits the
    /// camera's target otherwise.
    void goTo(const render::Camera&);
    /// Returns the present view; raster in device pixels.
    [[nodiscard]] render::View view() const;
    /// Leaves the exhibit and walks on.
    void walkOn();
    [[nodiscard]] CameraControl::Mode mode() const { return control_.mode(); }
    /// Sets the state of a gamepad's sticks, which holds until the next call.
    void setSticks(const WalkKeys&);
    [[nodiscard]] const WalkKeys& sticks() const;
    /// Presses the button that the visitor looks at, or visits the object in the middle of the picture.
    void act();
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Graphic; }
    [[nodiscard]] QString accessibleText() const override;

    void setHandling(const Handling&);
    /// Sets limits, see `DrawSchedule::setLimits`.
    void setLimits(int mostSamples, double leastScale);
    /// While on, the camera cuts instead of gliding.
    void setReducedMotion(bool on) { control_.setCutting(on); }
    void setPaused(bool);
    [[nodiscard]] bool paused() const { return paused_; }
    /// Returns whether nothing shown will change by itself, so that the exhibits' clock stands still. False while
    /// paused.
    [[nodiscard]] bool clockWaits() const { return !paused_ && !std::isfinite(changeAt_); }
    static constexpr double latestTime = 86400;  ///< Largest time of the exhibits' clock, in seconds.
    /// Sets the exhibits' clock, clamped to 0 ... `latestTime`. Buttons pressed after this time count as not pressed.
    void setTime(double seconds);
    /// Measures the time of every pass, which is slower. On while the frame report is open.
    void setStepsTimed(bool);
    /// Runs every pass, even if it is not needed. The picture must stay the same.
    void setRunEverything(bool);
    void reloadShaders();
    /// Returns whether exhibits are still missing from the picture.
    [[nodiscard]] bool opening() const { return schedule_.opening(); }
    /// Shows the hint of the first start, until the first step or click.
    void showHint(const QString&);

    [[nodiscard]] const DrawSchedule& schedule() const { return schedule_; }
    /// Text for the status line: what was drawn last, and why.
    [[nodiscard]] QString reason() const;
    [[nodiscard]] double time() const { return time_; }
    /// Returns whether the picture on the screen is a finished whole picture at full resolution. A screenshot then
    /// saves it as shown.
    [[nodiscard]] bool pictureFinished() const;
    /// Picture on the screen, in device pixels; null before the first one.
    [[nodiscard]] const QImage& shown() const { return picture_.image(); }
    /// Request of the last whole picture on the screen.
    [[nodiscard]] const FrameRequest& shownRequest() const { return picture_.request(); }
    [[nodiscard]] const DrawOrder& shownOrder() const { return picture_.order(); }
    /// Number of the present scene state: grows with every change of values, camera or size.
    [[nodiscard]] long long sceneStateNumber() const { return sceneStateNumber_; }
    /// Scene state number of the picture that `drawn` reported last, which may be older.
    [[nodiscard]] long long drawnSceneState() const { return drawnState_; }
    /// Request for a picture of the present state and time.
    [[nodiscard]] FrameRequest presentRequest() const { return request(time_); }
    /// While on, moving regions are not drawn by themselves; the whole picture is drawn instead. Used while another
    /// whole picture is shown beside it.
    void setWholePictures(bool);
    /// While on, another picture lies over this one, and names and handles are hidden.
    void setCovered(bool);
    [[nodiscard]] bool covered() const { return covered_; }
    /// Number of pictures shown since the start. Tests use it to check that an idle window draws none.
    [[nodiscard]] long long picturesDrawn() const { return picture_.pictures(); }
    /// Number of moving regions shown since the start.
    [[nodiscard]] long long regionsDrawn() const { return picture_.regions(); }
    /// Number of preparations for queries since the start. Tests use it to check that one scene state and time takes
    /// one.
    [[nodiscard]] long long preparations() const { return prepared_.preparations(); }
    /// Milliseconds until the next check whether a picture is due. -1: none is scheduled until a change or the end of a
    /// drawing.
    [[nodiscard]] int nextTick() const { return timer_.remainingTime(); }
    [[nodiscard]] RenderThread& renderThread() { return *thread_; }

public slots:
    /// Call when something visible changed.
    void sceneStateChanged();
    /// Presses the button that the visitor looks at, or that of the orbited exhibit.
    void press();

signals:
    /// Emitted when a number key, 1 to 9, was pressed in the picture.
    void bookmarkAsked(int number);
    void visited(std::size_t exhibit);
    void walkedOn();
    /// Emitted when the visitor pressed this exhibit's button.
    void pressed(std::size_t exhibit);
    void drawn(const vitrine::render::FrameReport& report, const QSize& pixels);
    /// Emitted when `time()` changed.
    void timePassed();
    /// Emitted when the camera, time or size of the picture changed, or whether it is covered.
    void looked();
    /// Emitted when the visitor clicked at this point on the orbited exhibit, which has a tree.
    void shapeClicked(std::size_t exhibit, const QPointF& at);
    /// Emitted when a file that the scene state names, or one beside it, changed on disk.
    void filesChanged();
    /// Emitted when drawing failed. The last good picture stays.
    void failed(const QString& message);

protected:
    void paintGL() override;
    void resizeGL(int, int) override;

private:
    [[nodiscard]] bool orbitsButton() const;
    [[nodiscard]] double now() const { return static_cast<double>(steady_.nsecsElapsed()) * 1e-9; }
    /// Returns the request for the whole viewport at full resolution, at a time of the exhibits' clock.
    [[nodiscard]] FrameRequest request(double time) const;
    [[nodiscard]] QSize devicePixels() const;
    void tick();
    void tickSoon();
    void advanceClock(double now);
    void passTime(double seconds);
    void valuesChanged();
    void scheduleNext();
    void paintOpening(QPainter&);
    [[nodiscard]] bool canBeSeen() const;
    /// Gives the render thread the next order. If it is drawing, abandons an outdated picture only.
    void orderPicture();
    void orderWhole(const DrawOrder&);
    void orderRegion();
    void take(const DrawnPicture&);
    void showDrawn(const DrawnPicture&);
    /// Passes the hall's quality values to the schedule.
    void takeQuality();
    void takeRegion(const DrawnPicture&);
    /// Returns the prepared scene of the present state and time, cached for queries to the museum.
    [[nodiscard]] const Prepared& prepared() const;
    /// Returns the region in which everything moves, if it is small enough to be drawn alone over a static picture.
    [[nodiscard]] std::optional<PictureRegion> smallRegion();
    void cameraChanged();
    /// Called after a glide or a cut of the camera began. Records a cut, and orders a new picture.
    void leftFor();
    /// Glides to a standpoint and makes `subject` the visited one. Into and out of the depot the camera cuts.
    void glideTo(std::size_t subject, const CameraControl::Standpoint&);
    /// Hides the notice of the destination once the visitor is there.
    void noteArrival();
    void showProblems(const std::vector<render::gl::ShaderProblem>&);
    /// Begins to build specialized programs for the idle scene state.
    void buildBetter();
    void fail(const QString& why);
    void click(const QPointF&);
    void pressButton(std::size_t exhibit);
    void remember();
    /// Returns the object under a point of the widget.
    [[nodiscard]] std::optional<Pointed> pointedAt(const QPointF&) const;

    const Museum& museum_;
    Renderers& renderers_;
    History& history_;
    CameraControl control_;
    DrawSchedule schedule_;
    QElapsedTimer steady_;
    QTimer timer_;
    QTimer shaderPoll_;
    FileWatch files_;
    QTimer rest_;  ///< Runs while values have changed lately.
    double lastTick_ = 0;
    double time_ = 0;         // The exhibits' clock, in seconds.
    bool cut_ = true;         // The camera jumped since the last whole picture, or there was none.
    int motionFrames_ = 0;    // Number of frames of the present motion; 0: static picture.
    double changeAt_ = 0;     // Time of that clock at which the picture next changes by itself, as of the last tick.
    bool clockRuns_ = false;  // The time since the last tick counts: something is animated or walks.
    bool paused_ = false;
    bool runEverything_ = false;
    ShownPicture picture_;
    bool wholePictures_ = false;
    bool covered_ = false;
    double pictureTime_ = 0;  // Time that the whole picture shows, on the exhibits' clock.
    bool drawingRegion_ = false;
    bool drawing_ = false;            // A picture is ordered and has not arrived yet.
    long long sceneStateNumber_ = 0;  // Grows with every visible change.
    long long drawnState_ = 0;        // Scene state number of the last ordered picture.

    mutable PreparedState prepared_;  // Cache of the last preparation.

    // Region that moves while the rest of the picture is static.
    std::optional<PictureRegion> region_;
    bool regionDue_ = false;
    bool regionMoved_ = false;  // Something moved at the last tick.
    double regionRest_ = 0;     // Earliest time of the next region, in seconds of the steady clock.

    QString lastFailure_;
    std::vector<ParameterValues> acting_;  // Effective values of the last drawn scene state.
    // Time of the last press of each exhibit's button, on the exhibits' clock; `never` if none.
    std::vector<double> pressedAt_;
    std::optional<LookedAt> lookedAt_;

    struct Former {
        CameraControl::Standpoint standpoint;
        std::size_t subject = hallIndex;
    };
    std::vector<Former> former_;  // Earlier standpoints, the latest at the end.
    std::size_t subject_ = hallIndex;

    Overlay* hint_;
    Overlay* going_;  ///< Names the destination until its picture is shown.
    Overlay* label_;
    Overlay* problems_;
    std::vector<render::PendingAsset> awaited_;  // Pending assets at the last tick.
    std::unique_ptr<ReadingNotice> reading_;
    std::unique_ptr<ViewportInput> input_;
    std::unique_ptr<RenderThread> thread_;  // Declared last, so that it is destroyed first.
};

}  // namespace vitrine::ui
