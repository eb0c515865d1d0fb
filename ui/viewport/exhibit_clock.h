#pragma once

#include <QObject>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vitrine::ui {

/// Clock of the exhibits, in seconds, and the presses of their buttons on it. It passes while something shown moves,
/// and stands still otherwise.
class ExhibitClock final : public QObject {
    Q_OBJECT

public:
    static constexpr double latest = 86400;        ///< Largest time.
    static constexpr double firstTick = 1.0 / 60;  ///< Seconds that pass in the first tick after a standstill.

    explicit ExhibitClock(std::size_t subjects);

    [[nodiscard]] double time() const { return time_; }
    /// Sets the time, clamped to 0 ... `latest`. Buttons pressed after this time count as not pressed.
    void set(double seconds);
    void setPaused(bool);
    [[nodiscard]] bool paused() const { return paused_; }
    /// Returns whether nothing shown will change by itself, so that the clock stands still. False while paused.
    [[nodiscard]] bool waits() const { return !paused_ && !std::isfinite(changeAt_); }

    /// Begins a tick at this time of a steady clock. Returns the seconds since the last one, or `firstTick` after a
    /// standstill.
    [[nodiscard]] double tick(double now);
    /// Lets this many seconds pass.
    void pass(double seconds);
    /// Sets whether the time until the next tick counts: something moves or will move.
    void setRunning(bool runs) { runs_ = runs; }
    /// Sets in how many seconds the picture next changes by itself; infinity: never.
    void expectChange(double seconds) { changeAt_ = time_ + seconds; }
    /// Returns the seconds until then, at least 0.
    [[nodiscard]] double untilChange() const { return std::max(changeAt_ - time_, 0.0); }

    /// Notes that this subject's button is pressed now.
    void press(std::size_t subject);
    /// Returns for each subject the seconds from the last press of its button to `time`; very many if there was none.
    [[nodiscard]] std::vector<double> sincePressed(double time) const;

signals:
    /// Emitted when `time()` changed.
    void passed();
    /// Emitted when another moment was set: earlier frames show other values. `changed` follows.
    void wasSet();
    /// Emitted when the time was set, the clock was paused or continued, or a button was pressed.
    void changed();

private:
    static constexpr double never = -1e9;

    double time_ = 0;
    double changeAt_ = 0;  // Time at which the picture next changes by itself, as of the last tick.
    double lastTick_ = 0;  // On the steady clock.
    bool runs_ = false;
    bool paused_ = false;
    std::vector<double> pressedAt_;  // Time of the last press of each subject's button; `never` if none.
};

}  // namespace vitrine::ui
