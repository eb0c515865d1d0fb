#pragma once

#include "ui/viewport/adaptive_scale.h"
#include "ui/viewport/opening.h"

#include <QString>

#include <algorithm>
#include <limits>
#include <optional>

namespace vitrine::ui {

/// Next picture to draw: its resolution and its sample.
struct DrawOrder {
    double scale = 1;       ///< Part of the viewport's resolution, above 0 to 1.
    int sample = 0;         ///< Index of the supersample, from 0.
    int samples = 1;        ///< Number of supersamples of the picture.
    bool inMotion = false;  ///< The picture is averaged with earlier frames of the same motion.
    /// Largest number of exhibits in the picture. Limited while opening, so that a first picture comes soon.
    int mostExhibits = std::numeric_limits<int>::max();

    bool operator==(const DrawOrder&) const = default;
};

/// Schedule of pictures: decides when to draw and how finely. Draws on demand only: at lower resolution while something
/// moves, with more and more samples once nothing does, and then not at all. Depends on no widget and no GL. Times are
/// seconds of one steady clock.
class DrawSchedule {
public:
    static constexpr double settleTime = 0.2;  ///< Seconds without a change after which refinement begins.

    /// Sets the number of supersamples of a static picture; at least 1.
    void setSamples(int samples) { wantedSamples_ = samples; }
    [[nodiscard]] int samples() const { return std::min(wantedSamples_, mostSamples_); }

    /// Sets the limits from the preferences. `mostSamples` caps the number of supersamples. `leastScale` is the lowest
    /// resolution while moving, as a part of full resolution; a higher one may be slower.
    void setLimits(int mostSamples, double leastScale);
    /// Returns whether `setLimits` caps the wanted number of supersamples.
    [[nodiscard]] bool limited() const { return samples() < wantedSamples_; }
    [[nodiscard]] int mostSamples() const { return mostSamples_; }

    /// Sets the number of exhibits, see `Opening`.
    void setExhibits(int count) { opening_.setExhibits(count); }

    /// Sets the number of frames that a picture in motion is averaged over. 1: no averaging.
    void setHistory(int frames) { history_ = frames; }

    /// Something visible changed: the last picture is out of date.
    void changed(double now);
    /// The camera changed, and nothing else.
    void cameraMoved(double now);
    /// While on, there is always a next frame, and no refinement.
    void setMoving(bool on, double now);

    [[nodiscard]] std::optional<DrawOrder> next(double now) const;
    /// Seconds until `next` may have an order: 0, a wait, or infinity if nothing is to be drawn.
    [[nodiscard]] double wait(double now) const;
    /// Drawing of the order has begun. Later changes are not in its picture.
    void begun(const DrawOrder&);
    /// The order was drawn and took this many seconds of wall-clock time.
    void drawn(const DrawOrder&, double seconds);
    /// Returns whether the order's picture is better than the one on the screen. A single sample is not, after an
    /// averaged picture in motion at full resolution.
    [[nodiscard]] bool improves(const DrawOrder&) const;
    /// Drawing was abandoned because something changed.
    void givenUp();
    /// Returns whether the picture that is being drawn should be abandoned: it is out of date, and a coarser one is
    /// sooner done.
    [[nodiscard]] bool betterGivenUp() const;

    [[nodiscard]] double scaleWhileMoving() const { return scale_.scale(); }
    /// Returns whether exhibits are still missing from the picture.
    [[nodiscard]] bool opening() const { return opening_.isUnderway(); }
    /// Returns whether the last picture shows the present state, at any resolution.
    [[nodiscard]] bool current() const { return !moving_ && !dirty_; }
    [[nodiscard]] bool still() const { return !moving_ && !dirty_ && refined_ >= samples(); }
    /// Text for the status line: how the last picture was drawn, and why.
    [[nodiscard]] QString reason() const;
    /// Text for the same line if the preferences cap the number of supersamples; empty otherwise.
    [[nodiscard]] QString limit() const;

private:
    bool dirty_ = true;
    Opening opening_;
    std::optional<DrawOrder> underway_;
    bool outdated_ = false;  // Something changed since `underway_` began.
    bool moving_ = false;
    int wantedSamples_ = 16;
    int mostSamples_ = std::numeric_limits<int>::max();
    int history_ = 1;
    bool cameraOnly_ = false;  // Only the camera changed since the last picture that was up to date.
    int leastToShow_ = 0;      // Number of supersamples from which a picture is better than the one on the screen.
    int refined_ = 0;          // Number of supersamples drawn at full resolution.
    double lastChange_ = -1e9;
    AdaptiveScale scale_;
    double drawnScale_ = 1;  // Scale of the last picture.
};

}  // namespace vitrine::ui
