#include "ui/print/eyes_preview.h"

#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"
#include "ui/print/strip_preview.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::ui {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double eyesApart = 65;   // Millimeters between the eyes, the usual mean.
constexpr double armLength = 400;  // Millimeters; from where a print is looked at that is made for no distance.
constexpr double steepest = 70 * degree;
constexpr double perPixel = 0.15 * degree;  // Rotation per pixel of a drag: 200 pixels are about a viewing zone.
constexpr int caption = 24;
constexpr int coarseSide = 200;
constexpr int quietTime = 120;  // Milliseconds after a drag until fine pictures are made.

}  // namespace

EyesPreview::EyesPreview(QWidget* parent) : QWidget(parent), job_(this)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("The card as both eyes see it"));
    setToolTip(tr("Drag to the side to look from there, up and down to tilt; the arrows move by a degree, Shift by a "
                  "tenth.\nHome or a double click looks straight on."));
    setMinimumHeight(120);
    setCursor(Qt::SizeAllCursor);
    settle_.setSingleShot(true);
    settle_.setInterval(quietTime);
    connect(&settle_, &QTimer::timeout, this, [this] { fetch(false); });
    connect(&job_, &NewestJob::failed, this, [this] {
        images_ = {};
        update();
    });
}

void EyesPreview::setPreview(std::shared_ptr<const printing::PrintPreview> preview, double distance)
{
    preview_ = std::move(preview);
    // At infinity both eyes would look through every lens at the same angle, and see the same view.
    distance_ = std::isfinite(distance) ? distance : armLength;
    job_.forget();
    if (!preview_) images_ = {};
    fetch(true);
    settle_.start();
}

void EyesPreview::look(double angle, double angleAlong)
{
    angle_ = std::clamp(angle, -steepest, steepest);
    angleAlong_ = std::clamp(angleAlong, -steepest, steepest);
    notifyNumber(*this);
    fetch(true);
    settle_.start();
}

QRectF EyesPreview::half(int eye) const
{
    const double wide = (width() - 8) / 2.0;
    return {eye * (wide + 8), 0.0, wide, static_cast<double>(height() - caption)};
}

void EyesPreview::fetch(bool coarse)
{
    update();
    if (!preview_ || width() < 32 || height() <= caption) return;
    const double shape = static_cast<double>(preview_->width()) / static_cast<double>(preview_->height());
    const QSizeF room = half(0).size();
    const double wide = std::min(room.width(), room.height() * shape);
    const int fine = static_cast<int>(std::lround(std::max(wide, wide / shape) * devicePixelRatioF()));
    const int side = std::max(1, coarse ? std::min(coarseSide, fine) : fine);
    std::array<printing::Eye, 2> eyes;
    for (std::size_t i = 0; i < 2; ++i) {
        const double aside = (i == 0 ? -0.5 : 0.5) * eyesApart / distance_;
        eyes[i] = preview_->eyeAt(std::atan(std::tan(angle_) + aside), angleAlong_, distance_);
    }
    job_.ask([this, preview = preview_, eyes, side, angle = angle_]() -> NewestJob::Outcome {
        std::array<QImage, 2> images;
        for (std::size_t i = 0; i < 2; ++i)
            if (printing::CodedPicture seen = preview->seen(eyes[i], side); seen.width > 0) images[i] = imageOf(seen);
        return [this, images, angle] {
            images_ = images;
            shownAngle_ = angle;
            update();
        };
    });
}

QString EyesPreview::standpoint() const
{
    const auto side = [](double angle, const QString& positive, const QString& negative) {
        const QString size = numberLocale().toString(std::abs(angle / degree), 'f', 1) + QChar(0xb0);
        return std::abs(angle) < 0.05 * degree ? size : size + QLatin1Char(' ') + (angle > 0 ? positive : negative);
    };
    const QString from = tr("%1 cm").arg(numberLocale().toString(distance_ / 10, 'g', 4));
    return tr("%1, %2, from %3")
        .arg(side(angle_, tr("right"), tr("left")), side(angleAlong_, tr("above"), tr("below")), from);
}

QString EyesPreview::accessibleText() const
{
    return preview_ ? QString() : tr("Nothing to look at yet");
}

std::optional<AccessibleNumber> EyesPreview::accessibleNumber() const
{
    return AccessibleNumber{angle_ / degree, -steepest / degree, steepest / degree, 1, standpoint()};
}

void EyesPreview::setAccessibleNumber(double degrees)
{
    look(degrees * degree, angleAlong_);
}

void EyesPreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (int eye = 0; eye < 2; ++eye) {
        const QRectF room = half(eye);
        painter.fillRect(room, theme().base);
        const QImage& image = images_[static_cast<std::size_t>(eye)];
        if (image.isNull()) continue;
        const QSizeF size = QSizeF(image.size()).scaled(room.size(), Qt::KeepAspectRatio);
        painter.drawImage(
            QRectF(QPointF(room.center().x() - size.width() / 2, room.center().y() - size.height() / 2), size), image);
    }
    const QRect below(0, height() - caption, width(), caption);
    painter.setPen(theme().dim);
    if (images_[0].isNull()) {
        for (int eye = 0; eye < 2; ++eye)
            painter.drawText(half(eye).adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                             preview_ ? tr("Looking") : tr("Nothing to look at yet"));
    } else {
        painter.drawText(below.adjusted(0, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, tr("Left eye"));
        painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, tr("Right eye"));
        painter.setPen(theme().text);
        painter.drawText(below, Qt::AlignCenter, standpoint());
    }
    if (hasFocus()) {
        painter.setPen(theme().accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1 - caption));
    }
}

void EyesPreview::resizeEvent(QResizeEvent*)
{
    fetch(false);
}

void EyesPreview::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    grabbed_ = event->position();
}

void EyesPreview::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragging_) return;
    const QPointF way = event->position() - grabbed_;
    grabbed_ = event->position();
    look(angle_ + way.x() * perPixel, angleAlong_ - way.y() * perPixel);
}

void EyesPreview::mouseReleaseEvent(QMouseEvent*)
{
    dragging_ = false;
}

void EyesPreview::mouseDoubleClickEvent(QMouseEvent*)
{
    look(0, 0);
}

void EyesPreview::keyPressEvent(QKeyEvent* event)
{
    const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 * degree : degree;
    switch (event->key()) {
    case Qt::Key_Left: look(angle_ - step, angleAlong_); break;
    case Qt::Key_Right: look(angle_ + step, angleAlong_); break;
    case Qt::Key_Up: look(angle_, angleAlong_ + step); break;
    case Qt::Key_Down: look(angle_, angleAlong_ - step); break;
    case Qt::Key_Home: look(0, 0); break;
    default: QWidget::keyPressEvent(event);
    }
}

}  // namespace vitrine::ui

#include "moc_eyes_preview.cpp"
