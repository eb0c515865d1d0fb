#pragma once

#include <QString>

#include <array>
#include <limits>
#include <optional>

namespace vitrine::ui {

/// What the viewport draws next.
struct DrawOrder {
    double scale = 1;       ///< Of the viewport's resolution.
    int sample = 0;         ///< Supersample ...
    int samples = 1;        ///< ... of so many.
    bool inMotion = false;  ///< Averaged with the frames of the same motion before it.
    /// No more than so many exhibits: what opens shows something soon.
    int mostExhibits = std::numeric_limits<int>::max();

    bool operator==(const DrawOrder&) const = default;
};

/// Decides when to draw and how finely: on demand only, coarser while something moves so that it stays
/// fluid, finer and finer once all is still, and then not at all. Knows no widget and no GL. Times are
/// seconds of one steady clock.
class DrawSchedule {
public:
    static constexpr std::array<double, 5> scales{1, 0.75, 0.5, 0.35, 0.25};
    static constexpr double targetTime = 0.055;  ///< Seconds per frame while moving: about 18 frames a second.
    static constexpr double openingScale = 0.5;  ///< Of the very first pictures, so that there is one soon.
    static constexpr double quickOpening = 0.5;  ///< Seconds: whoever adds an exhibit as fast can add all of them.
    static constexpr double settleTime = 0.2;    ///< Seconds without a change after which the picture is still.

    /// Supersamples of a picture at rest; at least 1.
    void setSamples(int samples);
    [[nodiscard]] int samples() const { return samples_; }

    /// What the visitor can wait for: no more supersamples than that, whatever is asked for, and while something moves
    /// never coarser than this part of full resolution, which may make it slower.
    void setLimits(int mostSamples, double leastScale);
    /// Fewer supersamples are drawn than are asked for.
    [[nodiscard]] bool limited() const { return samples_ < wantedSamples_; }
    [[nodiscard]] int mostSamples() const { return mostSamples_; }

    /// How many there are. The first picture shows none, the next ones one more each, until that is quick.
    void setExhibits(int count) { exhibits_ = count; }

    /// Frames that a picture in motion is averaged over; 1: every one stands alone.
    void setHistory(int frames) { history_ = frames; }

    /// Something visible changed: what was drawn is out of date.
    void changed(double now);
    /// The camera alone did.
    void cameraMoved(double now);
    /// While on, there is always a next frame, and it is never refined.
    void setMoving(bool on, double now);

    [[nodiscard]] std::optional<DrawOrder> next(double now) const;
    /// Seconds after which `next` may have an order: 0, a wait, or infinity when nothing is to be drawn.
    [[nodiscard]] double wait(double now) const;
    /// The order is being carried out: what changes from now on is not in its picture.
    void begun(const DrawOrder&);
    /// It was carried out and took so many seconds of real time.
    void drawn(const DrawOrder&, double seconds);
    /// Whether its picture, drawn, is better than that on the screen: one sample is not, after a picture in motion at
    /// full resolution.
    [[nodiscard]] bool improves(const DrawOrder&) const;
    /// It was given up, because something changed.
    void givenUp();
    /// An order is being carried out whose picture is out of date already, and a coarse one can be had sooner.
    [[nodiscard]] bool betterGivenUp() const;

    [[nodiscard]] double scaleWhileMoving() const { return scales[level_]; }
    /// No picture shows all exhibits yet.
    [[nodiscard]] bool opening() const { return opening_; }
    /// The last picture shows things as they are, however finely.
    [[nodiscard]] bool current() const { return !moving_ && !dirty_; }
    [[nodiscard]] bool still() const { return !moving_ && !dirty_ && refined_ >= samples_; }
    /// For the status line: what the last picture was drawn as, and why.
    [[nodiscard]] QString reason() const;
    /// For the same line: that the preferences allow fewer supersamples than are asked for; empty when they do not.
    [[nodiscard]] QString limit() const;

private:
    void open(double seconds);
    [[nodiscard]] bool canBeCoarser() const;
    void adapt(const DrawOrder&, double seconds);

    bool dirty_ = true;
    bool opening_ = true;
    int exhibits_ = 0;
    int opened_ = 0;  // Exhibits that the next picture shows, while opening.
    std::optional<DrawOrder> underway_;
    bool outdated_ = false;  // Something changed since it was begun.
    bool moving_ = false;
    int samples_ = 16, wantedSamples_ = 16;
    int mostSamples_ = std::numeric_limits<int>::max();
    double leastScale_ = 0;
    int history_ = 1;
    bool cameraOnly_ = false;  // Nothing else changed since the last picture that shows things as they are.
    int leastToShow_ = 0;      // Supersamples that are better than what is on the screen.
    int refined_ = 0;          // Supersamples of the full picture that are drawn.
    double lastChange_ = -1e9;
    std::size_t level_ = 0;  // Index into `scales`.
    double drawnScale_ = 1;  // Of the last picture.
    int fastFrames_ = 0;     // In a row that would have allowed a finer level.
};

}  // namespace vitrine::ui
