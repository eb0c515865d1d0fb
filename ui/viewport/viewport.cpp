#include "ui/viewport/viewport.h"

#include "exhibits/framework/scene/tree.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/numbers.h"
#include "ui/kit/text.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/picture_place.h"
#include "ui/viewport/reading_notice.h"
#include "ui/viewport/shader_problems_text.h"
#include "ui/viewport/viewport_format.h"
#include "ui/viewport/viewport_input.h"

#include <QPainter>
#include <QWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr QColor emptyRoom(0x26, 0x23, 0x20);  // Color without a picture.
constexpr double longestTick = 0.5;
constexpr int restsAfter = 2000;        // Milliseconds without a changed value.
constexpr double firstTick = 1.0 / 60;  // Seconds that pass in the first tick after a pause.
constexpr int hiddenWait = 250;         // Milliseconds between checks whether a hidden viewport is visible again.
constexpr double largestRegion = 0.25;  // Part of the picture's area; a larger region is drawn with the whole picture.
constexpr double restOfRegions = 5;     // Pause after drawing a region, as a multiple of the drawing time ...
constexpr double shortestRest = 0.03;   // ... and at least, in seconds.
constexpr double never = -1e9;          // On the exhibits' clock, in seconds.
// Seconds. After a longer pause (of a suspended machine) animations go on from where they were.
constexpr double longestRegionTick = 5;

}  // namespace

Viewport::Viewport(const Museum& museum, Renderers& renderers, History& history, QWidget* parent)
    : QOpenGLWidget(parent), museum_(museum), renderers_(renderers), history_(history), files_(museum, history),
      prepared_(museum), hint_(new Overlay(Overlay::Place::bottom, this)),
      going_(new Overlay(Overlay::Place::top, this)), label_(new Overlay(Overlay::Place::center, this)),
      problems_(new Overlay(Overlay::Place::topLeft, this)),
      reading_(std::make_unique<ReadingNotice>(this,
                                               [this] {
                                                   prepared_.lookAgain();
                                                   return shown().isNull() ? std::vector<render::PendingAsset>()
                                                                           : prepared().pending;
                                               })),
      input_(std::make_unique<ViewportInput>(*this, control_, [this](const QPointF& at) { return pointedAt(at); }))
{
    setFormat(viewportFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 90);
    setAccessibleName(tr("Museum"));
    setAccessibleDescription(tr("The picture. W A S D walk, Ctrl and the arrows look around, Enter visits."));
    steady_.start();
    pressedAt_.assign(museum.subjects().size(), never);
    schedule_.setExhibits(static_cast<int>(museum.subjects().size()) - 1);  // All but the hall.
    control_.setWalkable(
        [this](const glm::dvec3& from, const glm::dvec3& to) { return museum_.walk(prepared(), from, to); });
    control_.jumpTo(history.sceneState().camera);
    takeQuality();
    files_.renew();
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Viewport::tick);
    connect(input_.get(), &ViewportInput::walking, this, &Viewport::tickSoon);
    connect(input_.get(), &ViewportInput::turned, this, &Viewport::cameraChanged);
    connect(input_.get(), &ViewportInput::clicked, this, &Viewport::click);
    connect(input_.get(), &ViewportInput::walkOnAsked, this, &Viewport::walkOn);
    connect(input_.get(), &ViewportInput::goBackAsked, this, &Viewport::goBack);
    connect(input_.get(), &ViewportInput::pressAsked, this, &Viewport::press);
    connect(input_.get(), &ViewportInput::actAsked, this, &Viewport::act);
    connect(input_.get(), &ViewportInput::bookmarkAsked, this, &Viewport::bookmarkAsked);
    connect(&files_, &FileWatch::changed, this, [this] {
        sceneStateChanged();
        emit filesChanged();
    });
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, &Viewport::buildBetter);
    rest_.start(restsAfter);
    connect(&history, &History::changed, this, &Viewport::valuesChanged);
    connect(&history, &History::replaced, this, &Viewport::valuesChanged);
    connect(&history, &History::cameraMoved, this, [this] { jumpTo(history_.sceneState().camera); });
    thread_ = std::make_unique<RenderThread>(renderers_);
    connect(thread_.get(), &RenderThread::drawn, this, &Viewport::take);
#ifndef NDEBUG
    connect(&shaderPoll_, &QTimer::timeout, this, &Viewport::reloadShaders);
    shaderPoll_.start(500);
#endif
}

Viewport::~Viewport() = default;

FrameRequest Viewport::request(double time) const
{
    FrameRequest wanted;
    wanted.camera = widened(control_.camera(), static_cast<double>(width()) / std::max(height(), 1));
    const QSize pixels = devicePixels();
    wanted.raster.size = {pixels.width(), pixels.height()};
    wanted.time = time;
    wanted.runEverything = runEverything_;
    if (isInDepot()) wanted.alone = subject_;
    wanted.idle = !rest_.isActive();
    for (const double pressedAt : pressedAt_)
        wanted.sincePressed.push_back(time - (pressedAt <= time ? pressedAt : never));
    return wanted;
}

QSize Viewport::devicePixels() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void Viewport::paintGL()
{
    QPainter painter(this);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    // Until a picture of the new size arrives, the old one is shown at the scale of the next one.
    const bool old = shown().size() != devicePixels();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, old);
    if (old) painter.fillRect(rect(), emptyRoom);
    if (shown().isNull())
        paintOpening(painter);
    else
        painter.drawImage(old ? pictureIn(shown().size(), QRectF(rect())) : QRectF(rect()), shown());
    if (!drawing_ && !timer_.isActive()) timer_.start(0);  // A viewport that was hidden may have to draw.
}

void Viewport::paintOpening(QPainter& painter)
{
    // Files are read and shaders are compiled. On a slow machine this takes up to half a minute the first time.
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.setPen(QColor(0xc9, 0xc2, 0xb8));
    painter.drawText(rect(), Qt::AlignCenter, tr("Opening the hall …"));
}

bool Viewport::canBeSeen() const
{
    const QWindow* handle = window()->windowHandle();
    return width() > 0 && height() > 0 && isVisible() && handle && handle->isExposed();
}

void Viewport::orderPicture()
{
    if (!canBeSeen()) return;
    if (drawing_) {
        if (schedule_.betterGivenUp() || (drawingRegion_ && drawnState_ != sceneStateNumber_)) thread_->abandon();
        return;
    }
    const std::optional<DrawOrder> order = schedule_.next(now());
    if (order && order->sample == 0)
        orderWhole(*order);
    else if (regionDue_ && now() >= regionRest_ && region_ && schedule_.current() && shown().size() == devicePixels())
        orderRegion();
    else if (order)
        orderWhole(*order);
}

void Viewport::orderWhole(const DrawOrder& order)
{
    if (order.sample == 0) pictureTime_ = time_;
    PictureOrder wanted{history_.sceneState(), request(pictureTime_), order, devicePixels(), std::nullopt};
    const double scale = order.scale * pictureQuality(wanted.sceneState.hall()).resolutionScale;
    wanted.request.raster.size =
        glm::max(glm::ivec2(glm::round(glm::dvec2(wanted.request.raster.size) * scale)), glm::ivec2(1));
    wanted.request.mostExhibits = order.mostExhibits;
    wanted.request.resetHistory = std::exchange(cut_, false);
    wanted.request.sample = order.sample;
    wanted.request.samples = order.samples;
    if (!order.inMotion || wanted.request.resetHistory) motionFrames_ = 0;
    if (order.inMotion) ++motionFrames_;
    wanted.request.movingFrame = motionFrames_;
    schedule_.begun(order);
    drawing_ = true;
    drawnState_ = sceneStateNumber_;
    thread_->draw(std::move(wanted));
}

void Viewport::orderRegion()
{
    regionDue_ = false;
    drawing_ = drawingRegion_ = true;
    drawnState_ = sceneStateNumber_;
    thread_->draw({history_.sceneState(), request(time_), {1, 0, schedule_.samples()}, devicePixels(), region_});
}

void Viewport::take(const DrawnPicture& picture)
{
    drawing_ = drawingRegion_ = false;
    if (picture.abandoned || !picture.failure.isEmpty()) cut_ = cut_ || picture.order.request.resetHistory;
    if (picture.order.region) {
        takeRegion(picture);
    } else if (picture.abandoned) {
        schedule_.givenUp();
    } else if (!picture.failure.isEmpty()) {
        // The last good picture stays. Nothing is drawn again until something changes.
        schedule_.drawn({1, schedule_.samples() - 1, schedule_.samples()}, 0);
        going_->say({});
        fail(picture.failure);
    } else {
        showDrawn(picture);
        lastFailure_.clear();
        schedule_.drawn(picture.order.order, picture.seconds);
        // Work is left over, or a program is still being built.
        if (picture.report.unfinished) schedule_.changed(now());
        const glm::ivec2 size = picture.order.request.raster.size;
        noteArrival();
        emit drawn(picture.report, QSize(size.x, size.y));
        if (picture.order.order.sample == 0) emit looked();
        update();
    }
    showProblems(picture.problems);
    tick();
}

void Viewport::showDrawn(const DrawnPicture& picture)
{
    if (!schedule_.improves(picture.order.order)) return;
    picture_.show(picture);
}

void Viewport::takeRegion(const DrawnPicture& picture)
{
    regionRest_ = now() + std::max(restOfRegions * picture.seconds, shortestRest);
    if (!picture.failure.isEmpty()) fail(picture.failure);
    // Ignores a region of another scene state or size.
    if (picture.image.isNull() || drawnState_ != sceneStateNumber_ || picture.order.screen != shown().size()) return;
    picture_.showRegion(picture);
    emit looked();
    update();
}

void Viewport::fail(const QString& why)
{
    if (std::exchange(lastFailure_, why) != why) emit failed(why);
}

void Viewport::resizeGL(int, int)
{
    ++sceneStateNumber_;
    schedule_.changed(now());
    for (Overlay* overlay : {hint_, going_, label_, problems_}) overlay->place();
    reading_->place();
    emit looked();
}

void Viewport::scheduleNext()
{
    if (drawing_) return;  // Scheduling continues when the picture arrives.
    const double wait = schedule_.wait(now());
    const bool walking = input_->sticks().moves() || (input_->keys().moves() && hasFocus());
    if (wait <= 0 || walking || control_.moving()) {
        timer_.start(canBeSeen() ? 0 : hiddenWait);
        return;
    }
    double change = std::max(changeAt_ - time_, 0.0);
    if (region_ && (regionDue_ || change <= 0)) change = std::max(regionRest_ - now(), shortestRest);
    const double soonest = std::min(wait, change);
    if (std::isfinite(soonest)) timer_.start(static_cast<int>(std::ceil(std::clamp(soonest, 0.0, 3600.0) * 1000)));
}

const Prepared& Viewport::prepared() const
{
    const Prepared& now = prepared_.of(history_.sceneState(), sceneStateNumber_, request(time_));
    if (!now.pending.empty()) reading_->start();
    return now;
}

std::optional<PictureRegion> Viewport::smallRegion()
{
    if (input_->keys().moves() || control_.moving() || runEverything_ || wholePictures_ ||
        pictureQuality(history_.sceneState().hall()).resolutionScale != 1)
        return std::nullopt;
    const FrameRequest wanted = request(time_);
    const std::optional<PictureRegion> region = museum_.movingRegion(prepared(), wanted);
    const auto area = [](const glm::ivec2& size) { return static_cast<double>(size.x) * size.y; };
    if (!region || area(region->size) == 0 || area(region->size) > largestRegion * area(wanted.raster.size))
        return std::nullopt;
    return region;
}

void Viewport::advanceClock(double at)
{
    const double since = clockRuns_ ? at - lastTick_ : firstTick;
    const double seconds = since > longestTick ? firstTick : since;
    lastTick_ = at;
    if (isInDepot() && input_->keys().moves()) walkOn();
    const CameraControl::Mode modeBefore = control_.mode();
    if (control_.advance(seconds, input_->keys())) cameraChanged();
    if (modeBefore == CameraControl::Mode::orbit && control_.mode() != modeBefore) {
        cut_ = cut_ || control_.cuts();
        emit walkedOn();
    }

    double change = paused_ ? INFINITY : museum_.nextChange(prepared(), request(time_));
    // Pending assets arrive with the next picture, which is ordered once.
    const std::vector<render::PendingAsset>& pending = prepared().pending;
    if (!pending.empty() && pending != awaited_) change = std::min(change, firstTick);
    awaited_ = pending;
    const bool animated = change <= 0;
    changeAt_ = time_ + change;
    clockRuns_ = std::isfinite(change) || input_->keys().moves() || control_.moving();
    region_ = std::isfinite(change) ? smallRegion() : std::nullopt;
    if (region_) {
        // The picture around the region is static and is refined; the region is drawn by itself.
        passTime(since > longestRegionTick ? firstTick : since);
        // One more region after the motion has ended shows its final state.
        regionDue_ = regionDue_ || animated || regionMoved_ || change <= since;
        regionMoved_ = animated;
        schedule_.setMoving(false, at);
        return;
    }
    regionDue_ = regionMoved_ = false;
    if (animated) {
        passTime(seconds);
    } else if (std::isfinite(change)) {
        passTime(since);
        if (change <= since) schedule_.changed(at);
    }
    schedule_.setMoving(animated || input_->keys().moves() || control_.moving(), at);
}

void Viewport::tickSoon()
{
    // The timer may wait for a change that is much later.
    if (!timer_.isActive() || timer_.interval() > 0) timer_.start(0);
}

void Viewport::tick()
{
    prepared_.lookAgain();
    advanceClock(now());
    orderPicture();
    scheduleNext();
}

void Viewport::valuesChanged()
{
    // Values that differ only in parameters without effect give the same picture, whose refinement goes on.
    std::vector<ParameterValues> acting;
    for (const ParameterValues& values : history_.sceneState().values) acting.push_back(actingValues(values));
    if (acting == acting_) return;
    acting_ = std::move(acting);
    files_.renew();
    rest_.start(restsAfter);
    motionFrames_ = 0;  // Earlier frames show other values and must not be averaged in.
    sceneStateChanged();
}

void Viewport::buildBetter()
{
    // A hidden viewport skips this.
    if (!canBeSeen() || shown().isNull()) return;
    thread_->post([this, sceneState = history_.sceneState(), wanted = request(time_)] {
        renderers_.buildBetter(sceneState, wanted);
        return std::function<void()>();
    });
}

void Viewport::sceneStateChanged()
{
    ++sceneStateNumber_;
    takeQuality();
    schedule_.changed(now());
    tickSoon();
}

void Viewport::cameraChanged()
{
    history_.setCamera(control_.camera());
    hint_->say({});
    ++sceneStateNumber_;
    takeQuality();
    if (cut_)
        schedule_.changed(now());
    else
        schedule_.cameraMoved(now());
    tickSoon();
    lookedAt_ = control_.mode() == CameraControl::Mode::walk ? museum_.lookedAt(prepared()) : std::nullopt;
    label_->say(lookedAt_ ? translatedText(lookedAt_->text) : QString());
    input_->lookAgain();
    emit looked();
}

QString Viewport::reason() const
{
    if (region_ && schedule_.still())
        return tr("Done (%1 samples); redrawing only the moving part (%2 × %3 px)")
                   .arg(schedule_.samples())
                   .arg(region_->size.x)
                   .arg(region_->size.y) +
               schedule_.limit();
    return schedule_.reason();
}

bool Viewport::pictureFinished() const
{
    const bool whole = pictureQuality(history_.sceneState().hall()).resolutionScale == 1;
    return whole && !shown().isNull() && !picture_.hasRegion() && schedule_.still() && lastFailure_.isEmpty();
}

void Viewport::setPaused(bool paused)
{
    paused_ = paused;
    sceneStateChanged();
}

void Viewport::setTime(double seconds)
{
    changeAt_ = time_ = std::clamp(seconds, 0.0, latestTime);
    emit timePassed();
    motionFrames_ = 0;
    sceneStateChanged();
}

void Viewport::passTime(double seconds)
{
    if (seconds == 0) return;
    time_ += seconds;
    emit timePassed();
}

void Viewport::setRunEverything(bool on)
{
    runEverything_ = on;
    sceneStateChanged();
}

void Viewport::setWholePictures(bool on)
{
    wholePictures_ = on;
    if (on && picture_.hasRegion()) sceneStateChanged();  // The region is newer than the rest of the picture.
    tickSoon();
}

void Viewport::setCovered(bool covered)
{
    if (std::exchange(covered_, covered) == covered) return;
    input_->setNaming(!covered);
    emit looked();
}

void Viewport::setStepsTimed(bool on)
{
    thread_->post([this, on] {
        renderers_.timeSteps(on);
        return std::function<void()>();
    });
}

void Viewport::reloadShaders()
{
    thread_->post([this] {
        const bool changed = renderers_.reloadChangedShaders();
        return [this, changed, problems = renderers_.problems()] {
            if (changed) sceneStateChanged();
            showProblems(problems);
        };
    });
}

void Viewport::showProblems(const std::vector<render::gl::ShaderProblem>& problems)
{
    problems_->say(shaderProblemsText(problems));
}

namespace {

constexpr std::size_t mostFormer = 100;

}  // namespace

void Viewport::visit(std::size_t exhibit)
{
    remember();
    glideTo(exhibit, {museum_.bestView(exhibit, history_.sceneState().values[exhibit]),
                      exhibit == hallIndex ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
    going_->say(tr("Going to %1 …").arg(translatedText(museum_.subject(exhibit).title())));
}

bool Viewport::isInDepot() const
{
    return subject_ != hallIndex && !museum_.isInHall(subject_) && control_.mode() == CameraControl::Mode::orbit;
}

void Viewport::glideTo(std::size_t subject, const CameraControl::Standpoint& there)
{
    const bool cuts = control_.cuts();
    control_.setCutting(cuts || isInDepot() || (subject != hallIndex && !museum_.isInHall(subject)));
    subject_ = subject;
    control_.glideTo(there);
    leftFor();
    control_.setCutting(cuts);
}

void Viewport::visit(const OwnObjectShown& object)
{
    remember();
    glideTo(hallIndex, {object.view, CameraControl::Mode::orbit});
    emit visited(hallIndex);
}

void Viewport::leftFor()
{
    cut_ = cut_ || control_.cuts();
    cameraChanged();
    notifyText(*this);
}

void Viewport::noteArrival()
{
    if (!control_.moving() && drawnState_ == sceneStateNumber_) going_->say({});
}

void Viewport::remember()
{
    if (former_.size() == mostFormer) former_.erase(former_.begin());
    former_.push_back({control_.standpoint(), subject_});
}

void Viewport::goBack()
{
    if (former_.empty()) return;
    const Former former = former_.back();
    former_.pop_back();
    glideTo(former.subject, former.standpoint);
    emit visited(former.subject);
}

void Viewport::jumpTo(const render::Camera& camera)
{
    cut_ = true;
    control_.jumpTo(camera);
    cameraChanged();
}

void Viewport::goTo(const render::Camera& camera)
{
    remember();
    constexpr double visitorsEye = 1.65;
    const bool stands =
        std::abs(camera.eye.y - visitorsEye) < 1e-6 && museum_.obstacles(prepared()).walks(camera.eye, camera.eye);
    glideTo(isInDepot() ? hallIndex : subject_,
            {camera, stands ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
}

void Viewport::walkOn()
{
    if (control_.standpoint().mode == CameraControl::Mode::walk) return;
    if (isInDepot()) {
        visit(hallIndex);
        emit walkedOn();
        return;
    }
    remember();
    control_.walkOn();
    leftFor();
    emit walkedOn();
}

void Viewport::click(const QPointF& at)
{
    if (isInDepot()) {
        if (capability<HasTree>(museum_.subject(subject_))) emit shapeClicked(subject_, at);
        return;
    }
    const std::optional<Pointed> found = pointedAt(at);
    if (!found) return;
    const bool orbited = control_.mode() == CameraControl::Mode::orbit && found->exhibit == subject_;
    if (found->button && (found->inReach || orbited)) return pressButton(found->exhibit);
    if (orbited && capability<HasTree>(museum_.subject(subject_))) {
        emit shapeClicked(subject_, at);
        return;
    }
    remember();
    subject_ = found->exhibit;
    control_.visit(found->view);
    leftFor();
    emit visited(found->exhibit);
}

std::optional<Pointed> Viewport::pointedAt(const QPointF& at) const
{
    if (width() <= 0 || height() <= 0 || isInDepot()) return std::nullopt;
    return museum_.pick(prepared(), request(time_), {2 * at.x() / width() - 1, 1 - 2 * at.y() / height()});
}

bool Viewport::orbitsButton() const
{
    return control_.mode() == CameraControl::Mode::orbit && capability<HasButton>(museum_.subject(subject_));
}

bool Viewport::canPress() const
{
    return orbitsButton() || lookedAt_;
}

void Viewport::press()
{
    if (orbitsButton())
        pressButton(subject_);
    else if (lookedAt_)
        pressButton(lookedAt_->exhibit);
}

void Viewport::showHint(const QString& text)
{
    hint_->say(text);
}

void Viewport::setSticks(const WalkKeys& sticks)
{
    input_->setSticks(sticks);
}

const WalkKeys& Viewport::sticks() const
{
    return input_->sticks();
}

void Viewport::act()
{
    const bool orbits = control_.mode() == CameraControl::Mode::orbit;
    if (orbits ? !capability<HasTree>(museum_.subject(subject_)) : lookedAt_.has_value())
        press();
    else if (orbits || pointedAt(QPointF(rect().center())))
        click(QPointF(rect().center()));
    else
        showHint(tr("There is no exhibit in the middle of the picture."));
}

render::View Viewport::view() const
{
    const FrameRequest now = request(time_);
    return render::makeView(now.camera, now.raster);
}

QString Viewport::accessibleText() const
{
    const CameraControl::Standpoint there = control_.standpoint();
    if (there.mode == CameraControl::Mode::orbit)
        return tr("You look at %1, from %2 m away.")
            .arg(text(museum_.subject(subject_).title()))
            .arg(numberLocale().toString(glm::distance(there.camera.eye, there.camera.target), 'f', 1));
    if (lookedAt_) return tr("You walk through the hall. Before you: %1.").arg(QString::fromStdString(lookedAt_->text));
    const std::optional<Pointed> ahead = shown().isNull() ? std::nullopt : pointedAt(QPointF(rect().center()));
    return ahead ? tr("You walk through the hall and look at %1.").arg(QString::fromStdString(ahead->name))
                 : tr("You walk through the hall.");
}

void Viewport::pressButton(std::size_t exhibit)
{
    pressedAt_[exhibit] = time_;
    sceneStateChanged();
    emit pressed(exhibit);
}

void Viewport::takeQuality()
{
    const PictureQuality quality = pictureQuality(history_.sceneState().hall());
    schedule_.setSamples(quality.supersamples);
    schedule_.setHistory(quality.historyFrames);
}

void Viewport::setHandling(const Handling& handling)
{
    input_->setHandling(handling);
}

void Viewport::setLimits(int mostSamples, double leastScale)
{
    const int samples = schedule_.samples();
    schedule_.setLimits(mostSamples, leastScale);
    if (schedule_.samples() != samples) sceneStateChanged();
}

}  // namespace vitrine::ui

#include "moc_viewport.cpp"
