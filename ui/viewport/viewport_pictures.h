#pragma once

#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/moving_region.h"
#include "ui/viewport/picture_orders.h"
#include "ui/viewport/shown_picture.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <vector>

namespace vitrine::ui {

class ExhibitClock;
class PresentScene;
class ViewportInput;
class Visitor;

/// Pictures of the viewport over time. Each tick advances the clock and the visitor, and then orders the next picture
/// if one is due. The picture on the screen follows from the pictures that arrive.
class ViewportPictures final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. Ticks begin with `resume`.
    ViewportPictures(PresentScene&, ExhibitClock&, Visitor&, const ViewportInput&, RenderThread&);

    [[nodiscard]] const DrawSchedule& schedule() const { return schedule_; }
    /// Picture on the screen.
    [[nodiscard]] const ShownPicture& shown() const { return shown_; }
    /// Returns whether the picture on the screen is a finished whole picture at full resolution. A screenshot then
    /// saves it as shown.
    [[nodiscard]] bool finished() const;
    /// Text for the status line: what was drawn last, and why.
    [[nodiscard]] QString reason() const;
    /// Sentence why the last picture could not be drawn; empty: it was drawn.
    [[nodiscard]] const QString& failure() const { return failure_; }
    /// Scene state number (`PresentScene::number`) of the picture that `drawn` reported last, which may be older.
    [[nodiscard]] long long drawnSceneState() const { return orders_.sceneStateNumber(); }
    /// Milliseconds until the next tick. -1: none is scheduled until a change or the end of a drawing.
    [[nodiscard]] int nextTick() const { return timer_.remainingTime(); }

    /// Sets limits, see `DrawSchedule::setLimits`.
    void setLimits(int mostSamples, double leastScale);
    /// While on, moving regions are not drawn by themselves; the whole picture is drawn instead. Used while another
    /// whole picture is shown beside it.
    void setWhole(bool);
    /// Goes on after a time in which the viewport could not be seen. Call when it is painted.
    void resume();

signals:
    void drawn(const vitrine::render::FrameReport& report, const QSize& pixels);
    /// Emitted when the picture on the screen changed. `time`: it shows another time, not only more samples.
    void updated(bool time);
    /// Emitted when drawing failed. The last good picture stays.
    void failed(const QString& message);
    /// Emitted when an ordered picture has arrived, after the signals above.
    void arrived(const vitrine::ui::DrawnPicture& picture);

private:
    static constexpr int hiddenWait = 250;          // Milliseconds between checks whether a viewport is visible again.
    static constexpr double longestTick = 0.5;      // Seconds.
    static constexpr double longestRegionTick = 5;  // The same while only a region moves.
    static constexpr double largestRegion = 0.25;   // Part of the picture's area; a larger region is drawn with it.

    [[nodiscard]] double now() const { return static_cast<double>(steady_.nsecsElapsed()) * 1e-9; }
    void tick();
    void tickSoon();
    void advance(double now);
    void scheduleNext();
    /// Orders the next picture. If one is being drawn, abandons an outdated one only.
    void orderPicture();
    void orderWhole(const DrawOrder&);
    void sceneChanged();
    void cameraChanged(bool cut);
    void take(const DrawnPicture&);
    void takeWhole(const DrawnPicture&);
    void takeRegion(const DrawnPicture&);
    void fail(const QString& why);
    /// Passes the hall's quality values to the schedule.
    void takeQuality();
    /// Returns the region in which everything moves, if it is small enough to be drawn alone over a static picture.
    [[nodiscard]] std::optional<PictureRegion> smallRegion() const;

    PresentScene& scene_;
    ExhibitClock& clock_;
    Visitor& visitor_;
    const ViewportInput& input_;
    DrawSchedule schedule_;
    ShownPicture shown_;
    PictureOrders orders_;
    MovingRegion region_;
    QElapsedTimer steady_;
    QTimer timer_;
    bool whole_ = false;
    QString failure_;
    std::vector<render::PendingAsset> awaited_;  // Pending assets at the last tick.
};

}  // namespace vitrine::ui
