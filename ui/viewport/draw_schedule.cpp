#include "ui/viewport/draw_schedule.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace vitrine::ui {
namespace {

// Number of supersamples that is as smooth as a picture in motion averaged over its frames.
constexpr int asSmoothAsMotion = 4;

}  // namespace

void DrawSchedule::setLimits(int mostSamples, double leastScale)
{
    mostSamples_ = std::max(mostSamples, 1);
    scale_.setLeast(leastScale);
}

void DrawSchedule::changed(double now)
{
    cameraOnly_ = false;
    leastToShow_ = 0;
    dirty_ = true;
    refined_ = 0;
    lastChange_ = now;
    outdated_ = underway_.has_value();
}

void DrawSchedule::cameraMoved(double now)
{
    const bool only = cameraOnly_ || !dirty_;
    const int least = leastToShow_;
    changed(now);
    cameraOnly_ = only;
    leastToShow_ = least;
}

void DrawSchedule::setMoving(bool on, double now)
{
    if (on || moving_) cameraMoved(now);
    moving_ = on;
}

std::optional<DrawOrder> DrawSchedule::next(double now) const
{
    const bool averaged = history_ > 1;
    if (opening() && dirty_) return DrawOrder{Opening::scale, 0, 1, false, opening_.shown()};
    if (moving_) return DrawOrder{scale_.scale(), 0, 1, averaged};
    const bool settled = now - lastChange_ >= settleTime;
    if (dirty_ && cameraOnly_ && averaged && !settled) return DrawOrder{scale_.scale(), 0, 1, true};
    if (dirty_ && scale_.isReduced() && !settled) return DrawOrder{scale_.scale(), 0, 1};
    // At full resolution the first picture and the first supersample are the same.
    if (dirty_) return DrawOrder{1, 0, samples()};
    if (refined_ < samples() && settled) return DrawOrder{1, refined_, samples()};
    return std::nullopt;
}

double DrawSchedule::wait(double now) const
{
    if (next(now)) return 0;
    if (refined_ < samples()) return lastChange_ + settleTime - now;
    return std::numeric_limits<double>::infinity();
}

void DrawSchedule::begun(const DrawOrder& order)
{
    underway_ = order;
    outdated_ = false;
}

bool DrawSchedule::improves(const DrawOrder& order) const
{
    return order.inMotion || order.sample + 1 >= leastToShow_;
}

bool DrawSchedule::betterGivenUp() const
{
    // The quickest kind of picture is never abandoned: otherwise the screen would not change during a long motion.
    return underway_ && outdated_ && underway_->scale == 1 && !underway_->inMotion &&
           (scale_.isReduced() || underway_->sample > 0);
}

void DrawSchedule::givenUp()
{
    underway_.reset();
    dirty_ = true;
    refined_ = 0;
}

void DrawSchedule::drawn(const DrawOrder& order, double seconds)
{
    underway_.reset();
    drawnScale_ = order.scale;
    if (!outdated_) {
        dirty_ = false;
        // A quick picture is not part of a refined one, even if both have one sample.
        if (order.samples == samples() && order.scale == 1 && !order.inMotion) refined_ = order.sample + 1;
    }
    if (improves(order)) leastToShow_ = order.inMotion && order.scale == 1 ? std::min(asSmoothAsMotion, samples()) : 0;
    outdated_ = false;
    if (order.sample != 0) return;
    // While files are read and programs are compiled, frame times do not predict the next ones.
    if (!opening_.isUnderway()) {
        scale_.drawn(order.scale, seconds);
        return;
    }
    opening_.drawn(seconds);
    dirty_ = true;
    refined_ = 0;
}

QString DrawSchedule::limit() const
{
    if (!limited()) return {};
    return QCoreApplication::translate("DrawSchedule", "; the hall requests %1 samples, the preferences allow %2")
        .arg(wantedSamples_)
        .arg(samples());
}

QString DrawSchedule::reason() const
{
    const auto tr = [](const char* words) { return QCoreApplication::translate("DrawSchedule", words); };
    if (moving_ || dirty_ || refined_ == 0)
        return tr("Rendering at %1 %").arg(static_cast<int>(drawnScale_ * 100 + 0.5));
    if (refined_ < samples()) return tr("Refining (%1 of %2 samples)").arg(refined_).arg(samples()) + limit();
    return (refined_ == 1 ? tr("Done (1 sample)") : tr("Done (%1 samples)").arg(refined_)) + limit();
}

}  // namespace vitrine::ui
