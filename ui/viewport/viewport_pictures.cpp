#include "ui/viewport/viewport_pictures.h"

#include "exhibits/museum/picture_settings.h"
#include "ui/viewport/exhibit_clock.h"
#include "ui/viewport/present_scene.h"
#include "ui/viewport/viewport_input.h"
#include "ui/viewport/visitor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {

ViewportPictures::ViewportPictures(PresentScene& scene, ExhibitClock& clock, Visitor& visitor,
                                   const ViewportInput& input, RenderThread& thread)
    : scene_(scene), clock_(clock), visitor_(visitor), input_(input), orders_(scene, thread)
{
    schedule_.setExhibits(static_cast<int>(scene.museum().subjects().size()) - 1);  // All but the hall.
    takeQuality();
    steady_.start();
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &ViewportPictures::tick);
    connect(&input, &ViewportInput::walking, this, &ViewportPictures::tickSoon);
    connect(&clock, &ExhibitClock::wasSet, this, [this] { orders_.restartMotion(); });
    connect(&scene, &PresentScene::valuesChanged, this, [this] { orders_.restartMotion(); });
    connect(&scene, &PresentScene::changed, this, &ViewportPictures::sceneChanged);
    connect(&scene, &PresentScene::cameraChanged, this, &ViewportPictures::cameraChanged);
    connect(&thread, &RenderThread::drawn, this, &ViewportPictures::take);
}

bool ViewportPictures::finished() const
{
    const bool whole = pictureQuality(scene_.state().hall()).resolutionScale == 1;
    return whole && !shown_.image().isNull() && !shown_.hasRegion() && schedule_.still() && failure_.isEmpty();
}

QString ViewportPictures::reason() const
{
    if (!region_.part() || !schedule_.still()) return schedule_.reason();
    return tr("Done (%1 samples); redrawing only the moving part (%2 × %3 px)")
               .arg(schedule_.samples())
               .arg(region_.part()->size.x)
               .arg(region_.part()->size.y) +
           schedule_.limit();
}

void ViewportPictures::setLimits(int mostSamples, double leastScale)
{
    const int samples = schedule_.samples();
    schedule_.setLimits(mostSamples, leastScale);
    if (schedule_.samples() != samples) scene_.change();
}

void ViewportPictures::setWhole(bool on)
{
    whole_ = on;
    if (on && shown_.hasRegion()) scene_.change();  // The region is newer than the rest of the picture.
    tickSoon();
}

void ViewportPictures::takeQuality()
{
    const PictureQuality quality = pictureQuality(scene_.state().hall());
    schedule_.setSamples(quality.supersamples);
    schedule_.setHistory(quality.historyFrames);
}

void ViewportPictures::sceneChanged()
{
    takeQuality();
    schedule_.changed(now());
    tickSoon();
}

void ViewportPictures::cameraChanged(bool cut)
{
    if (cut) orders_.cut();
    takeQuality();
    if (orders_.hasCut())
        schedule_.changed(now());
    else
        schedule_.cameraMoved(now());
    tickSoon();
}

void ViewportPictures::resume()
{
    if (!orders_.isUnderway() && (!timer_.isActive() || timer_.interval() == hiddenWait)) timer_.start(0);
}

void ViewportPictures::tickSoon()
{
    // The timer may wait for a change that is much later.
    if (!timer_.isActive() || timer_.interval() > 0) timer_.start(0);
}

void ViewportPictures::tick()
{
    scene_.lookAgain();
    advance(now());
    orderPicture();
    scheduleNext();
}

void ViewportPictures::advance(double at)
{
    const double since = clock_.tick(at);
    const double seconds = since > longestTick ? ExhibitClock::firstTick : since;
    visitor_.advance(seconds, input_.keys());

    double change = clock_.paused() ? INFINITY : scene_.museum().nextChange(scene_.prepared(), scene_.request());
    // Pending assets arrive with the next picture, which is ordered once.
    const std::vector<render::PendingAsset>& pending = scene_.prepared().pending;
    if (!pending.empty() && pending != awaited_) change = std::min(change, ExhibitClock::firstTick);
    awaited_ = pending;
    const bool animated = change <= 0;
    clock_.expectChange(change);
    const bool visitorMoves = input_.keys().moves() || visitor_.control().moving();
    clock_.setRunning(std::isfinite(change) || visitorMoves);
    region_.set(std::isfinite(change) ? smallRegion() : std::nullopt);
    if (region_.part()) {
        // The picture around the region is static and is refined; the region is drawn by itself. After a longer pause
        // (of a suspended machine) animations go on from where they were.
        clock_.pass(since > longestRegionTick ? ExhibitClock::firstTick : since);
        region_.passTick(animated, change <= since);
        schedule_.setMoving(false, at);
        return;
    }
    if (animated) {
        clock_.pass(seconds);
    } else if (std::isfinite(change)) {
        clock_.pass(since);
        if (change <= since) schedule_.changed(at);
    }
    schedule_.setMoving(animated || visitorMoves, at);
}

std::optional<PictureRegion> ViewportPictures::smallRegion() const
{
    if (input_.keys().moves() || visitor_.control().moving() || scene_.runsEverything() || whole_ ||
        pictureQuality(scene_.state().hall()).resolutionScale != 1)
        return std::nullopt;
    const FrameRequest wanted = scene_.request();
    const std::optional<PictureRegion> region = scene_.museum().movingRegion(scene_.prepared(), wanted);
    const auto area = [](const glm::ivec2& size) { return static_cast<double>(size.x) * size.y; };
    if (!region || area(region->size) == 0 || area(region->size) > largestRegion * area(wanted.raster.size))
        return std::nullopt;
    return region;
}

void ViewportPictures::orderPicture()
{
    if (!scene_.canBeSeen()) return;
    if (orders_.isUnderway()) {
        if (schedule_.betterGivenUp() || orders_.drawsOldRegion()) orders_.abandon();
        return;
    }
    const std::optional<DrawOrder> order = schedule_.next(now());
    if (order && order->sample == 0) {
        orderWhole(*order);
    } else if (region_.isDue(now()) && schedule_.current() && shown_.image().size() == scene_.devicePixels()) {
        region_.begun();
        orders_.orderRegion(*region_.part(), schedule_.samples());
    } else if (order) {
        orderWhole(*order);
    }
}

void ViewportPictures::orderWhole(const DrawOrder& order)
{
    schedule_.begun(order);
    orders_.orderWhole(order);
}

void ViewportPictures::scheduleNext()
{
    if (orders_.isUnderway()) return;  // Scheduling continues when the picture arrives.
    const double wait = schedule_.wait(now());
    if (wait <= 0 || input_.moves() || visitor_.control().moving()) {
        timer_.start(scene_.canBeSeen() ? 0 : hiddenWait);
        return;
    }
    double change = clock_.untilChange();
    if (region_.isWaiting(change <= 0)) change = region_.wait(now());
    const double soonest = std::min(wait, change);
    if (std::isfinite(soonest)) timer_.start(static_cast<int>(std::ceil(std::clamp(soonest, 0.0, 3600.0) * 1000)));
}

void ViewportPictures::take(const DrawnPicture& picture)
{
    orders_.noteArrival(picture);
    if (picture.order.region) {
        takeRegion(picture);
    } else if (picture.abandoned) {
        schedule_.givenUp();
    } else if (!picture.failure.isEmpty()) {
        // The last good picture stays. Nothing is drawn again until something changes.
        schedule_.drawn({1, schedule_.samples() - 1, schedule_.samples()}, 0);
        fail(picture.failure);
    } else {
        takeWhole(picture);
    }
    emit arrived(picture);
    tick();
}

void ViewportPictures::takeWhole(const DrawnPicture& picture)
{
    if (schedule_.improves(picture.order.order)) shown_.show(picture);
    failure_.clear();
    schedule_.drawn(picture.order.order, picture.seconds);
    // Work is left over, or a program is still being built.
    if (picture.report.unfinished) schedule_.changed(now());
    const glm::ivec2 size = picture.order.request.raster.size;
    emit drawn(picture.report, QSize(size.x, size.y));
    emit updated(picture.order.order.sample == 0);
}

void ViewportPictures::takeRegion(const DrawnPicture& picture)
{
    region_.drawn(now(), picture.seconds);
    if (!picture.failure.isEmpty()) fail(picture.failure);
    // Ignores a region of another scene state or size.
    const bool fits = orders_.sceneStateNumber() == scene_.number() && picture.order.screen == shown_.image().size();
    if (picture.image.isNull() || !fits) return;
    shown_.showRegion(picture);
    emit updated(true);
}

void ViewportPictures::fail(const QString& why)
{
    if (std::exchange(failure_, why) != why) emit failed(why);
}

}  // namespace vitrine::ui

#include "moc_viewport_pictures.cpp"
