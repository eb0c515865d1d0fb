#include "ui/viewport/viewport.h"

#include "exhibits/museum/named_files.h"
#include "render/failure.h"
#include "ui/viewport/overlay.h"
#include "ui/kit/message_of.h"

#include <QOpenGLContext>
#include <QOpenGLDebugLogger>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double buttonTime = 0.25;  // Seconds in which a pressed button is still moving, with some to spare.
constexpr double longestTick = 0.5;
constexpr int lookAtFilesEvery = 1000;  // Milliseconds.
constexpr double firstTick = 1.0 / 60;  // After a rest no time has passed for those who walk.
constexpr int hoverDelay = 30;          // Milliseconds after which a resting pointer is told what is under it.
constexpr std::size_t mostFormer = 100;

}  // namespace

QSurfaceFormat viewportFormat()
{
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapInterval(1);
#ifndef NDEBUG
    format.setOption(QSurfaceFormat::DebugContext);
#endif
    return format;
}

Viewport::Viewport(Gallery& gallery, History& history, QWidget* parent)
    : QOpenGLWidget(parent), gallery_(gallery), history_(history), hint_(new Overlay(Overlay::Place::bottom, this)),
      label_(new Overlay(Overlay::Place::center, this)), problems_(new Overlay(Overlay::Place::topLeft, this)),
      name_(new Overlay(Overlay::Place::pointer, this))
{
    setFormat(viewportFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 90);
    setAccessibleName(tr("Museum"));
    setAccessibleDescription(tr("The picture. W A S D walk, dragging looks around, a click visits an exhibit."));
    steady_.start();
    pressedAt_.assign(gallery.exhibits().size(), -1e9);
    control_.setWalkable([this](const glm::dvec3& from, const glm::dvec3& to) { return gallery_.walk(from, to); });
    control_.jumpTo(history.look().camera);
    schedule_.setSamples(pictureQuality(history.look().values.front()).supersamples);
    watchFiles();
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Viewport::tick);
    hoverTimer_.setSingleShot(true);
    hoverTimer_.setInterval(hoverDelay);
    connect(&hoverTimer_, &QTimer::timeout, this, &Viewport::hover);
    fileWatch_.setInterval(lookAtFilesEvery);
    connect(&fileWatch_, &QTimer::timeout, this, [this] {
        if (stateOfFiles(history_.look()) != filesDrawn_) lookChanged();
    });
    connect(&history, &History::changed, this, &Viewport::valuesChanged);
    connect(&history, &History::replaced, this, &Viewport::valuesChanged);
    connect(&history, &History::cameraMoved, this, [this] { jumpTo(history_.look().camera); });
#ifndef NDEBUG
    connect(&shaderPoll_, &QTimer::timeout, this, &Viewport::reloadShaders);
    shaderPoll_.start(500);
#endif
}

Viewport::~Viewport()
{
    closeGl();
}

void Viewport::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::closeGl, Qt::UniqueConnection);
#ifndef NDEBUG
    auto* logger = new QOpenGLDebugLogger(context());
    if (logger->initialize()) {
        connect(logger, &QOpenGLDebugLogger::messageLogged, this, [](const QOpenGLDebugMessage& message) {
            if (message.severity() == QOpenGLDebugMessage::HighSeverity) qWarning("OpenGL: %s", qPrintable(message.message()));
        });
        logger->startLogging(QOpenGLDebugLogger::SynchronousLogging);
    }
#endif
    try {
        gallery_.open();
        opened_ = true;
    } catch (const std::exception& thrown) {
        emit failed(messageOf(thrown));
    }
    drewOnce_ = false;
    schedule_.changed(now());
}

void Viewport::closeGl()
{
    if (!opened_) return;
    opened_ = false;
    makeCurrent();
    emit contextClosing();
    gallery_.close();
    doneCurrent();
}

bool Viewport::withContext(const std::function<void()>& work)
{
    if (!opened_) return false;
    makeCurrent();
    work();
    doneCurrent();
    return true;
}

FrameRequest Viewport::request() const
{
    FrameRequest wanted;
    wanted.camera = widened(control_.camera(), static_cast<double>(width()) / std::max(height(), 1));
    wanted.raster.size = {std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF()))),
                          std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())))};
    wanted.time = time_;
    wanted.runEverything = runEverything_;
    for (const double pressedAt : pressedAt_) wanted.sincePressed.push_back(time_ - pressedAt);
    return wanted;
}

void Viewport::paintGL()
{
    if (!opened_ || width() <= 0 || height() <= 0) return;
    // Qt is in the middle of painting the window: nothing may be thrown through it.
    try {
        if (const std::optional<DrawOrder> order = schedule_.next(now())) draw(*order);
        if (drewOnce_) {
            const double ratio = devicePixelRatioF();
            gallery_.present(static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio)));
        }
        scheduleNext();
    } catch (const std::exception& thrown) {
        fail(thrown);
    }
}

void Viewport::draw(const DrawOrder& order)
{
    FrameRequest wanted = request();
    const double scale = order.scale * pictureQuality(history_.look().values.front()).resolutionScale;
    wanted.raster.size = glm::max(glm::ivec2(glm::round(glm::dvec2(wanted.raster.size) * scale)), glm::ivec2(1));
    wanted.sample = order.sample;
    wanted.samples = order.samples;
    const double start = now();
    try {
        const render::FrameReport report = gallery_.draw(history_.look(), wanted);
        drewOnce_ = true;
        ++picturesDrawn_;
        lastFailure_.clear();
        schedule_.drawn(order, now() - start);
        emit drawn(report, QSize(wanted.raster.size.x, wanted.raster.size.y));
    } catch (const std::exception& thrown) {
        // The last good picture stays; nothing is tried again until something changes.
        schedule_.drawn({1, schedule_.samples() - 1, schedule_.samples()}, 0);
        fail(thrown);
    }
    showProblems();
}

void Viewport::fail(const std::exception& thrown)
{
    const QString message = messageOf(thrown);
    if (message != lastFailure_) emit failed(message);
    lastFailure_ = message;
}

void Viewport::watchFiles()
{
    const bool named = namesFiles(history_.look());
    filesDrawn_ = named ? stateOfFiles(history_.look()) : 0;
    if (named && !fileWatch_.isActive()) fileWatch_.start();
    if (!named) fileWatch_.stop();
}

void Viewport::resizeGL(int, int)
{
    schedule_.changed(now());
    for (Overlay* overlay : {hint_, label_, problems_}) overlay->place();
}

void Viewport::scheduleNext()
{
    const double wait = schedule_.wait(now());
    const bool walking = keys_.any() && hasFocus();
    if (wait <= 0 || walking || control_.moving()) {
        timer_.start(0);
        return;
    }
    const double change = paused_ ? INFINITY : gallery_.nextChange(history_.look(), request());
    const double soonest = std::min(wait, change);
    if (std::isfinite(soonest)) timer_.start(static_cast<int>(std::ceil(std::clamp(soonest, 0.0, 3600.0) * 1000)));
}

void Viewport::tick()
{
    const double at = now();
    const double since = clockRuns_ ? at - lastTick_ : firstTick;
    const double seconds = since > longestTick ? firstTick : since;
    lastTick_ = at;

    const CameraControl::Mode modeBefore = control_.mode();
    if (control_.advance(seconds, keys_)) cameraChanged();
    if (modeBefore == CameraControl::Mode::orbit && control_.mode() != modeBefore) emit walkedOn();

    const bool buttons = !paused_ && std::any_of(pressedAt_.begin(), pressedAt_.end(), [&](double t) { return time_ - t < buttonTime; });
    const double change = paused_ ? INFINITY : gallery_.nextChange(history_.look(), request());
    const bool animated = change <= 0 || buttons;
    clockRuns_ = std::isfinite(change) || buttons || keys_.any() || control_.moving();
    if (animated) {
        time_ += seconds;
    } else if (std::isfinite(change)) {
        time_ += since;
        if (change <= since) schedule_.changed(at);
    }
    schedule_.setMoving(animated || keys_.any() || control_.moving(), at);
    if (schedule_.next(at)) update();
    else scheduleNext();
}

void Viewport::valuesChanged()
{
    // What differs in rows alone that do not act is the same picture: it goes on being refined.
    std::vector<ParameterValues> acting;
    for (const ParameterValues& values : history_.look().values) acting.push_back(actingValues(values));
    if (acting == acting_) return;
    acting_ = std::move(acting);
    lookChanged();
}

void Viewport::lookChanged()
{
    schedule_.setSamples(pictureQuality(history_.look().values.front()).supersamples);
    schedule_.changed(now());
    watchFiles();
    if (!timer_.isActive()) timer_.start(0);
}

void Viewport::cameraChanged()
{
    history_.setCamera(control_.camera());
    hint_->say({});
    Look look = history_.look();
    lookedAt_ = control_.mode() == CameraControl::Mode::walk ? gallery_.lookedAt(look) : std::nullopt;
    label_->say(lookedAt_ ? QString::fromStdString(lookedAt_->text) : QString());
    if (hoverPoint_) hoverTimer_.start();
    lookChanged();
}

void Viewport::visit(std::size_t exhibit)
{
    remember();
    subject_ = exhibit;
    control_.glideTo({gallery_.bestView(exhibit, history_.look().values[exhibit]), exhibit == 0 ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
    cameraChanged();
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
    subject_ = former.subject;
    control_.glideTo(former.standpoint);
    cameraChanged();
    emit visited(former.subject);
}

void Viewport::jumpTo(const render::Camera& camera)
{
    control_.jumpTo(camera);
    cameraChanged();
}

void Viewport::walkOn()
{
    if (control_.standpoint().mode == CameraControl::Mode::walk) return;
    remember();
    control_.walkOn();
    cameraChanged();
    emit walkedOn();
}

void Viewport::press()
{
    if (control_.mode() == CameraControl::Mode::orbit && !gallery_.exhibits()[subject_]->buttonText().empty()) pressButton(subject_);
    else if (lookedAt_) pressButton(lookedAt_->exhibit);
}

void Viewport::pressButton(std::size_t exhibit)
{
    pressedAt_[exhibit] = time_;
    lookChanged();
    emit pressed(exhibit);
}

std::optional<render::Image> Viewport::finishedPicture()
{
    const bool whole = pictureQuality(history_.look().values.front()).resolutionScale == 1;
    if (!opened_ || !drewOnce_ || !whole || !schedule_.still() || !lastFailure_.isEmpty()) return std::nullopt;
    render::Image picture;
    withContext([&] { picture = gallery_.shownPicture(); });
    if (picture.width == 0) return std::nullopt;
    return picture;
}

void Viewport::setPaused(bool paused)
{
    paused_ = paused;
    lookChanged();
}

void Viewport::setRunEverything(bool on)
{
    runEverything_ = on;
    lookChanged();
}

void Viewport::setStepsTimed(bool on)
{
    gallery_.timeSteps(on);
}

void Viewport::reloadShaders()
{
    withContext([this] {
        if (gallery_.reloadChangedShaders()) lookChanged();
    });
    showProblems();
}

void Viewport::showProblems()
{
    QStringList lines;
    for (const render::gl::ShaderProblem& problem : gallery_.problems())
        lines << QStringLiteral("%1:%2  %3")
                     .arg(QString::fromStdString(problem.file))
                     .arg(problem.line)
                     .arg(QString::fromStdString(problem.message).trimmed());
    if (!lines.isEmpty()) lines.prepend(tr("A shader did not build; the last good picture stays. Saving the file tries again."));
    problems_->say(lines.join(QLatin1Char('\n')));
}

void Viewport::showHint(const QString& text)
{
    hint_->say(text);
}

}  // namespace vitrine::ui

#include "moc_viewport.cpp"
