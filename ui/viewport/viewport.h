#pragma once

#include "ui/kit/spoken.h"
#include "ui/model/history.h"
#include "ui/viewport/camera_control.h"
#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/prepared_look.h"
#include "ui/viewport/render_thread.h"
#include "ui/viewport/renderers.h"

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

/// The picture, and the visitor in it. It shows the last picture that the render thread finished and draws none itself;
/// pictures are asked for on demand only, one at a time.
class Viewport final : public QOpenGLWidget, public Spoken {
    Q_OBJECT

public:
    /// All must outlive it.
    Viewport(const Museum&, Renderers&, History&, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Glides to the exhibit's best view and orbits it; to the hall's, and walks.
    void visit(std::size_t exhibit);
    /// True while an exhibit without a place in the hall is visited: it is shown alone, in its own space.
    [[nodiscard]] bool isInDepot() const;
    /// Glides back to where the visitor was before the last visit or step away from one; emits `visited` for what was
    /// on show there. Nothing while there is no such place.
    void goBack();
    [[nodiscard]] bool canGoBack() const { return !former_.empty(); }
    /// Whether `press` finds a button.
    [[nodiscard]] bool canPress() const;
    /// Whose parameters are on show: what E presses while it is orbited.
    void setSubject(std::size_t exhibit) { subject_ = exhibit; }
    void jumpTo(const render::Camera&);
    /// The visitor's own objects that stand in the hall, as far as they are read.
    [[nodiscard]] std::vector<OwnObjectShown> ownObjects() const { return museum_.ownObjects(prepared()); }
    /// Glides to one of them.
    void visit(const OwnObjectShown&);
    /// Glides there, and walks on from where a visitor can stand, at his height; otherwise orbits what is looked at.
    void goTo(const render::Camera&);
    /// What one sees from where the visitor is, in device pixels.
    [[nodiscard]] render::View view() const;
    /// Leaves the exhibit.
    void walkOn();
    [[nodiscard]] CameraControl::Mode mode() const { return control_.mode(); }
    /// What a gamepad's sticks say until they say something else.
    void setSticks(const WalkKeys&);
    [[nodiscard]] const WalkKeys& sticks() const;
    /// Presses the button that the visitor looks at, or visits what is in the middle of the picture.
    void act();
    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Graphic; }
    [[nodiscard]] QString spokenText() const override;

    void setHandling(const Handling&);
    /// See `DrawSchedule::setLimits`.
    void setLimits(int mostSamples, double leastScale);
    /// While on, the camera cuts to where it would glide otherwise.
    void setReducedMotion(bool on) { control_.setCutting(on); }
    void setPaused(bool);
    [[nodiscard]] bool paused() const { return paused_; }
    /// Nothing that is shown will change by itself: the exhibits' clock waits for something that does.
    [[nodiscard]] bool clockWaits() const { return !paused_ && !std::isfinite(changeAt_); }
    static constexpr double latestTime = 86400;  ///< Seconds.
    /// The exhibits' clock goes on from there, within 0 and `latestTime`; what was pressed later is not pressed yet.
    void setTime(double seconds);
    /// Times every step: slower, while the ledger is open.
    void setStepsTimed(bool);
    /// Every pass runs, called for or not: the picture must stay the same.
    void setRunEverything(bool);
    void reloadShaders();
    /// Exhibits are still to come.
    [[nodiscard]] bool opening() const { return schedule_.opening(); }
    /// The line for the first start; gone at the first step or click.
    void showHint(const QString&);

    [[nodiscard]] const DrawSchedule& schedule() const { return schedule_; }
    /// For the status line: what was drawn last, and why.
    [[nodiscard]] QString reason() const;
    [[nodiscard]] double time() const { return time_; }
    /// What is on the screen is finished, and a screenshot of it is a picture of its own.
    [[nodiscard]] bool pictureFinished() const;
    /// What is on the screen, in device pixels; null before the first picture.
    [[nodiscard]] const QImage& shown() const { return shown_; }
    /// What the last whole picture on the screen was asked for as.
    [[nodiscard]] const FrameRequest& shownRequest() const { return shownRequest_; }
    [[nodiscard]] const DrawOrder& shownOrder() const { return shownOrder_; }
    /// Number of the scene state on show: grows with every change of values, camera or size.
    [[nodiscard]] long long sceneStateNumber() const { return sceneStateNumber_; }
    /// The same of the picture that `drawn` told of last, which may be an older one.
    [[nodiscard]] long long drawnSceneState() const { return drawnState_; }
    /// What the present picture is asked for as.
    [[nodiscard]] FrameRequest presentRequest() const { return request(time_); }
    /// While on, what moves in a picture that stands still is not drawn by itself, but with all of it: for those who
    /// show another whole picture beside it.
    void setWholePictures(bool);
    /// While on, something else lies over the picture: what belongs on it, as names and handles, is not shown.
    void setCovered(bool);
    [[nodiscard]] bool covered() const { return covered_; }
    /// Number of pictures shown since the start: tests count that an idle window draws none.
    [[nodiscard]] long long picturesDrawn() const { return picturesDrawn_; }
    /// The same for parts of the picture in which something moves while the rest stands still.
    [[nodiscard]] long long regionsDrawn() const { return regionsDrawn_; }
    /// How often what is asked of the museum was prepared since the start: tests count that one moment of one look
    /// takes one.
    [[nodiscard]] long long preparations() const { return prepared_.preparations(); }
    /// Until it looks whether a picture is due, milliseconds; -1: it waits for a change, or for a picture that is
    /// drawn.
    [[nodiscard]] int nextTick() const { return timer_.remainingTime(); }
    [[nodiscard]] RenderThread& renderThread() { return *thread_; }

public slots:
    /// Something visible changed.
    void sceneStateChanged();
    /// Presses the button that the look rests on; while an exhibit is orbited, its own.
    void press();

signals:
    /// The key of that number, 1 to 9, was pressed in the picture.
    void bookmarkAsked(int number);
    void visited(std::size_t exhibit);
    void walkedOn();
    /// The visitor pressed this exhibit's button.
    void pressed(std::size_t exhibit);
    void drawn(const vitrine::render::FrameReport& report, const QSize& pixels);
    /// `time` is another one.
    void timePassed();
    /// The camera, the moment or the size of the picture is another one, or it is covered, or no more.
    void looked();
    /// The visitor clicked an exhibit with a tree that he orbits, here.
    void shapeClicked(std::size_t exhibit, const QPointF& at);
    /// A file that the look names, or one beside it, is another one now.
    void filesChanged();
    /// Drawing failed; the last good picture stays.
    void failed(const QString& message);

protected:
    void paintGL() override;
    void resizeGL(int, int) override;

private:
    [[nodiscard]] bool orbitsButton() const;
    [[nodiscard]] double now() const { return static_cast<double>(steady_.nsecsElapsed()) * 1e-9; }
    /// Of the whole viewport at full resolution, at a moment of the exhibits' clock.
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
    /// Hands the render thread the next picture, unless one is being drawn.
    void orderPicture();
    void orderWhole(const DrawOrder&);
    void orderRegion();
    void take(const DrawnPicture&);
    void showDrawn(const DrawnPicture&);
    /// What of the hall's values the schedule goes by.
    void takeQuality();
    void takeRegion(const DrawnPicture&);
    void layRegionOver();
    /// What is to be seen at this moment, for questions to the museum: prepared once, however many are asked.
    [[nodiscard]] const Prepared& prepared() const;
    /// What moves by itself moves in this part of a picture that can stand still around it.
    [[nodiscard]] std::optional<PictureRegion> smallRegion();
    void cameraChanged();
    /// The same after a glide began, or a cut was made in its place.
    void leftFor();
    /// Glides there and makes `subject` the visited one. Into and out of the depot the picture changes at once.
    void glideTo(std::size_t subject, const CameraControl::Standpoint&);
    /// Takes back where the visitor is going, once he is there.
    void noteArrival();
    void showProblems(const std::vector<render::gl::ShaderProblem>&);
    void watchFiles();
    /// What rests is drawn faster from now on, once that can be.
    void buildBetter();
    void fail(const QString& why);
    void click(const QPointF&);
    void pressButton(std::size_t exhibit);
    void remember();
    /// What lies under a point of the widget.
    [[nodiscard]] std::optional<Pointed> pointedAt(const QPointF&) const;

    const Museum& museum_;
    Renderers& renderers_;
    History& history_;
    CameraControl control_;
    DrawSchedule schedule_;
    QElapsedTimer steady_;
    QTimer timer_;
    QTimer shaderPoll_;
    QTimer fileWatch_;
    QTimer rest_;                   ///< Runs while values have changed lately.
    std::uint64_t filesDrawn_ = 0;  // Their state, as far as the picture knows.
    double lastTick_ = 0;
    double time_ = 0;         // The exhibits' clock, seconds.
    bool cut_ = true;         // The camera jumped since the last whole picture, or there was none.
    int motionFrames_ = 0;    // Of the motion that is on the screen; 0: the picture rests.
    double changeAt_ = 0;     // On that clock: when the picture next changes by itself, as far as the last tick knows.
    bool clockRuns_ = false;  // Time passed since the last tick, for someone.
    bool paused_ = false;
    bool runEverything_ = false;
    QImage shown_;  // The last picture, with what moved in it since.
    FrameRequest shownRequest_;
    DrawOrder shownOrder_;
    bool wholePictures_ = false;
    bool covered_ = false;
    double pictureTime_ = 0;  // The moment that the whole picture shows, on the exhibits' clock.
    bool drawingRegion_ = false;
    bool drawing_ = false;            // A picture is asked for and not here yet.
    long long sceneStateNumber_ = 0;  // Grows with every change of what is to be seen.
    long long drawnState_ = 0;        // Of the picture that is being drawn.
    long long picturesDrawn_ = 0;

    mutable PreparedLook prepared_;  // What was asked last is kept.

    // What moves while the rest of the picture stands still.
    std::optional<PictureRegion> region_;
    QImage regionImage_;         // Newer than the picture; null: nothing moved since.
    PictureRegion regionShown_;  // Where it lies.
    bool regionDue_ = false;
    bool regionMoved_ = false;  // At the last tick.
    double regionRest_ = 0;     // Not to be drawn again before, seconds of the steady clock.
    long long regionsDrawn_ = 0;

    QString lastFailure_;
    std::vector<ParameterValues> acting_;  // Of the look that was drawn last: what of it acts.
    std::vector<double> pressedAt_;        // Per exhibit, on the exhibits' clock; very negative: never.
    std::optional<LookedAt> lookedAt_;

    struct Former {
        CameraControl::Standpoint standpoint;
        std::size_t subject = hallIndex;
    };
    std::vector<Former> former_;  // The last one last.
    std::size_t subject_ = hallIndex;

    Overlay* hint_;
    Overlay* going_;  ///< Names where the visitor is going, until its picture is there.
    Overlay* label_;
    Overlay* problems_;
    std::vector<render::PendingAsset> awaited_;  // At the last tick.
    std::unique_ptr<ReadingNotice> reading_;
    std::unique_ptr<ViewportInput> input_;
    std::unique_ptr<RenderThread> thread_;  // Ends first.
};

}  // namespace vitrine::ui
