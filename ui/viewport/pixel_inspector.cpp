#include "ui/viewport/pixel_inspector.h"

#include "exhibits/museum/picture.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/renderers.h"
#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int side = 15;  // Pixels of the picture that is drawn around the one inspected.

glm::dvec2 ndcAt(const QPointF& at, const QWidget& widget)
{
    return {2 * at.x() / widget.width() - 1, 1 - 2 * at.y() / widget.height()};
}

/// Returns the request for a small picture whose middle pixel is the one in this direction.
PictureRequest requestOf(FrameRequest frame, const glm::dvec3& direction)
{
    frame.camera.target = frame.camera.eye + direction;
    frame.camera.lensShift = {0, 0};
    const double part = static_cast<double>(side) / std::max(frame.raster.size.y, side);
    frame.camera.fovY = std::max(2 * std::atan(std::tan(0.5 * frame.camera.fovY) * part), glm::radians(1.02));
    frame.raster = {{side, side}};
    frame.averageIn = AverageIn::radiance;
    frame.channels = {true, true};
    return {.frame = std::move(frame), .depth = true};
}

InspectedPixel middleOf(const render::Image& picture, const render::Camera& camera)
{
    const auto at = [&](int channel) {
        return static_cast<double>(picture.at(picture.width / 2, picture.height / 2, channel));
    };
    InspectedPixel pixel{.radiance = {at(0), at(1), at(2)}};
    const double depth = at(4);
    if (!std::isfinite(depth)) return pixel;
    pixel.distance = depth;
    pixel.position = camera.eye + glm::normalize(camera.target - camera.eye) * depth;
    pixel.normal = {at(5), at(6), at(7)};
    pixel.evaluations = at(8);
    return pixel;
}

QString numbers(const glm::dvec3& v)
{
    const QLocale locale(languageCode());
    const auto number = [&](double x) { return locale.toString(x, 'f', 3); };
    return QStringLiteral("%1  %2  %3").arg(number(v.x), number(v.y), number(v.z));
}

}  // namespace

PixelInspector::PixelInspector(const Museum& museum, const History& history, Renderers& renderers, Viewport& viewport,
                               QObject* parent)
    : QObject(parent), museum_(museum), history_(history), renderers_(renderers), viewport_(viewport),
      label_(new Overlay(Overlay::Place::pointer, &viewport))
{
    soon_.setSingleShot(true);
    soon_.setInterval(30);
    connect(&soon_, &QTimer::timeout, this, &PixelInspector::ask);
    released_.setSingleShot(true);
    released_.setInterval(150);
    connect(&released_, &QTimer::timeout, this, &PixelInspector::end);
    viewport_.installEventFilter(this);
}

QString PixelInspector::text() const
{
    return label_->isVisible() ? label_->text() : QString();
}

bool PixelInspector::eventFilter(QObject* watched, QEvent* event)
{
    const auto isKey = [event] {
        const auto& key = *static_cast<QKeyEvent*>(event);
        return key.key() == Qt::Key_I && key.modifiers() == Qt::NoModifier && !key.isAutoRepeat();
    };
    switch (event->type()) {
    case QEvent::KeyPress:
        if (isKey()) begin();
        break;
    case QEvent::KeyRelease:
        if (isKey()) released_.start();
        break;
    case QEvent::MouseMove:
        pointer_ = static_cast<QMouseEvent*>(event)->position();
        if (held_ && !soon_.isActive()) soon_.start();
        break;
    // A window that is closed is hidden first. Afterwards there is no render thread.
    case QEvent::FocusOut:
    case QEvent::Hide: end(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

void PixelInspector::begin()
{
    released_.stop();
    if (held_) return;
    held_ = true;
    job_ = std::make_shared<PictureJob>();
    if (!viewport_.rect().contains(pointer_.toPoint()) || pointer_.isNull()) pointer_ = viewport_.rect().center();
    ask();
}

void PixelInspector::end()
{
    if (!held_) return;
    held_ = false;
    soon_.stop();
    released_.stop();
    task_.cancel();
    label_->say({});
    viewport_.renderThread().post([job = std::exchange(job_, {})]() -> std::function<void()> {
        *job = {};  // Its renderer is destroyed on the thread of its context.
        return [] {};
    });
}

void PixelInspector::ask()
{
    const FrameRequest frame = viewport_.scene().request();
    const glm::dvec2 ndc = ndcAt(pointer_, viewport_);
    auto step = [this, job = job_, ndc, at = pointer_, frame, sceneState = history_.sceneState(),
                 request =
                     requestOf(frame, viewport_.scene().view().direction(ndc))](const RenderThread::Notify& notify) {
        if (!job->maker)
            *job = renderers_.makePicture(sceneState, request);
        else
            renderers_.nextPicture(*job, sceneState, request);
        if (!job->maker) return false;
        while (job->maker->step())
            ;
        InspectedPixel pixel = middleOf(job->maker->picture(), request.frame.camera);
        if (!frame.alone) {
            if (const auto found = museum_.surroundings().pick(museum_.prepare(sceneState, frame), frame, ndc))
                pixel.object = found->name;
        } else {
            pixel.object = std::string(museum_.subject(*frame.alone).title());
        }
        notify([this, at, pixel] { show(at, pixel); });
        return false;
    };
    task_ = viewport_.renderThread().start(std::move(step), [](const QString& failure) {
        if (!failure.isEmpty()) qWarning("%s", qPrintable(failure));
    });
}

void PixelInspector::show(const QPointF& at, const InspectedPixel& pixel)
{
    if (!held_) return;
    QStringList lines;
    const QImage& shown = viewport_.pictures().shown().image();
    const QPoint place(static_cast<int>(at.x() / viewport_.width() * shown.width()),
                       static_cast<int>(at.y() / viewport_.height() * shown.height()));
    if (shown.valid(place)) {
        const QColor color = shown.pixelColor(place);
        lines << tr("Color  %1 %2 %3  %4").arg(color.red()).arg(color.green()).arg(color.blue()).arg(color.name());
    }
    lines << tr("Light  %1").arg(numbers(pixel.radiance));
    if (pixel.position) {
        lines << tr("Position  %1 m").arg(numbers(*pixel.position));
        if (pixel.normal != glm::dvec3(0)) lines << tr("Normal  %1").arg(numbers(pixel.normal));
        lines << tr("Distance  %1 m").arg(QLocale(languageCode()).toString(pixel.distance, 'f', 3));
        lines << (pixel.object.empty() ? tr("The building") : translatedText(pixel.object));
    } else {
        lines << tr("Nothing but the sky");
    }
    if (pixel.evaluations > 0)
        lines << tr("Cost  %1 evaluations").arg(QLocale(languageCode()).toString(std::lround(pixel.evaluations)));
    label_->say(lines.join(QLatin1Char('\n')));
    label_->placeAt(at.toPoint());
}

}  // namespace vitrine::ui

#include "moc_pixel_inspector.cpp"
