#include "ui/study/picture_panes.h"

#include "render/files/number_text.h"
#include "render/measure/metrics.h"
#include "ui/kit/theme.h"
#include "ui/study/study_pictures.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double gap = 8;  // Pixels between panes.
constexpr double largestScale = 64;
constexpr double zoomStep = 1.25;  // Zoom factor of one step of the wheel or one press of a key.
constexpr double lineWidth = 6;    // Pixels around the wipe line that grab it.

QString valuesText(const render::Image& picture, QPoint at)
{
    QStringList values;
    for (int c = 0; c < std::min(picture.channels, 3); ++c)
        values << QString::fromStdString(render::shortNumber(picture.at(at.x(), at.y(), c)));
    return values.join(QLatin1Char(' '));
}

}  // namespace

PicturePanes::PicturePanes(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Setting, reference and difference"));
    setAccessibleDescription(tr("Plus and minus zoom, 0 fits, 1 shows pixel for pixel, arrows move, Ctrl with an arrow "
                                "moves the line of the wipe."));
}

void PicturePanes::setPictures(PictureTriple triple)
{
    const QSizeF before = pictureSize();
    triple_ = std::move(triple);
    picture_ = screenImage(triple_.picture);
    reference_ = screenImage(triple_.reference);
    heat_ = triple_.errors.empty() ? QImage() : screenImage(render::heatMap(triple_.errors, triple_.full));
    if (pictureSize() != before || fits_) fit();
    update();
    emit pixelChanged();
}

void PicturePanes::setWiped(bool wiped)
{
    wiped_ = wiped;
    if (fits_) fit();
    update();
}

void PicturePanes::setWipe(double share)
{
    wipe_ = std::clamp(share, 0.0, 1.0);
    update();
}

QSizeF PicturePanes::pictureSize() const
{
    return picture_.isNull() ? QSizeF(16, 9) : QSizeF(picture_.size());
}

std::vector<QRectF> PicturePanes::panes() const
{
    const int count = wiped_ ? 2 : 3;
    // Number of columns that shows a picture of this shape largest.
    int best = 1;
    double largest = 0;
    const auto paneSize = [&](int columns) {
        const int rows = (count + columns - 1) / columns;
        return QSizeF((width() - gap * (columns - 1)) / columns, (height() - gap * (rows - 1)) / rows);
    };
    for (int columns = 1; columns <= count; ++columns)
        if (const double shown = pictureSize().scaled(paneSize(columns), Qt::KeepAspectRatio).width();
            shown > largest) {
            largest = shown;
            best = columns;
        }
    std::vector<QRectF> places;
    const QSizeF size = paneSize(best);
    for (int i = 0; i < count; ++i)
        places.emplace_back(QPointF((i % best) * (size.width() + gap), (i / best) * (size.height() + gap)), size);
    return places;
}

double PicturePanes::fittingScale() const
{
    return std::max(pictureSize().scaled(panes().front().size(), Qt::KeepAspectRatio).width() / pictureSize().width(),
                    0.01);
}

void PicturePanes::fit()
{
    fits_ = true;
    scale_ = fittingScale();
    middle_ = {pictureSize().width() / 2, pictureSize().height() / 2};
    update();
    emit viewChanged();
    emit pixelChanged();
}

void PicturePanes::setActualSize()
{
    zoomBy(1 / scale_);
}

void PicturePanes::zoomBy(double factor)
{
    const QRectF pane = panes().front();
    zoomAt(pane.center(), pane, factor);
}

QRectF PicturePanes::paneAt(const QPointF& at) const
{
    for (const QRectF& pane : panes())
        if (pane.contains(at)) return pane;
    return {};
}

QRectF PicturePanes::placeIn(const QRectF& pane) const
{
    return {pane.center() - middle_ * scale_, pictureSize() * scale_};
}

QPointF PicturePanes::pixelAt(const QPointF& at, const QRectF& pane) const
{
    return (at - pane.center()) / scale_ + middle_;
}

void PicturePanes::zoomAt(const QPointF& at, const QRectF& pane, double factor)
{
    const QPointF kept = pixelAt(at, pane);
    const double least = std::min(fittingScale(), 1.0) / 2;
    scale_ = std::clamp(scale_ * factor, least, largestScale);
    middle_ = kept - (at - pane.center()) / scale_;
    settle();
}

void PicturePanes::moveBy(const QPointF& pixels)
{
    middle_ += pixels;
    settle();
}

void PicturePanes::settle()
{
    fits_ = false;
    // Part of the picture stays visible.
    middle_ = {std::clamp(middle_.x(), 0.0, pictureSize().width()),
               std::clamp(middle_.y(), 0.0, pictureSize().height())};
    update();
    emit viewChanged();
    emit pixelChanged();
}

std::optional<QPoint> PicturePanes::pixel() const
{
    if (picture_.isNull()) return std::nullopt;
    QPointF at = middle_;
    if (pointer_) {
        const QRectF pane = paneAt(*pointer_);
        if (pane.isNull()) return std::nullopt;
        at = pixelAt(*pointer_, pane);
    }
    const QPoint found(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
    return picture_.rect().contains(found) ? std::optional(found) : std::nullopt;
}

QString PicturePanes::reading() const
{
    const std::optional<QPoint> at = pixel();
    if (!at || triple_.reference.empty()) return {};
    const float error = triple_.errors.empty() ? 0 : triple_.errors.at(at->x(), at->y(), 0);
    return tr("Pixel %1, %2: setting %3; reference %4; error %5")
        .arg(at->x())
        .arg(at->y())
        .arg(valuesText(triple_.picture, *at), valuesText(triple_.reference, *at),
             QString::fromStdString(render::shortNumber(error)));
}

void PicturePanes::paintPane(QPainter& painter, const QRectF& pane, const QImage& image, const QString& title) const
{
    painter.save();
    painter.setClipRect(pane, Qt::IntersectClip);
    painter.fillRect(pane, theme().base);
    // Beyond 100 % pixels are not interpolated.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale_ * devicePixelRatioF() < 1);
    if (!image.isNull()) {
        painter.drawImage(placeIn(pane), image);
    } else if (!picture_.isNull()) {
        painter.setPen(theme().dim);
        painter.drawText(pane, Qt::AlignCenter | Qt::TextWordWrap, noPixelDiffers());
    }
    if (!title.isEmpty()) {
        const QRectF words = painter.fontMetrics().boundingRect(title).adjusted(-6, -3, 6, 3);
        QColor ground = theme().base;
        ground.setAlphaF(0.8F);
        const QRectF label(pane.topLeft() + QPointF(4, 4), words.size());
        painter.fillRect(label, ground);
        painter.setPen(theme().text);
        painter.drawText(label, Qt::AlignCenter, title);
    }
    painter.restore();
}

double PicturePanes::edgeOf(const QRectF& pane) const
{
    const QRectF place = placeIn(pane);
    return place.left() + wipe_ * place.width();
}

void PicturePanes::paintWipe(QPainter& painter, const QRectF& pane) const
{
    paintPane(painter, pane, picture_, tr("Setting | reference"));
    const double edge = std::clamp(edgeOf(pane), pane.left(), pane.right());
    painter.save();
    painter.setClipRect(QRectF(edge, pane.top(), pane.right() - edge, pane.height()));
    paintPane(painter, pane, reference_, tr("Setting | reference"));
    painter.restore();
    painter.setPen(QPen(theme().accent, 1));
    painter.drawLine(QPointF(edge, pane.top()), QPointF(edge, pane.bottom()));
}

void PicturePanes::paintMark(QPainter& painter, const QRectF& pane) const
{
    const std::optional<QPoint> at = pixel();
    if (!at) return;
    QRectF square(placeIn(pane).topLeft() + QPointF(*at) * scale_, QSizeF(scale_, scale_));
    if (scale_ < 5) square.adjust(-3, -3, 3, 3);
    painter.save();
    painter.setClipRect(pane);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawRect(square);
    painter.setPen(QPen(Qt::white, 1));
    painter.drawRect(square);
    painter.restore();
}

void PicturePanes::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const std::vector<QRectF> all = panes();
    if (wiped_) {
        paintWipe(painter, all[0]);
        paintPane(painter, all[1], heat_, tr("Difference"));
    } else {
        paintPane(painter, all[0], picture_, tr("Setting"));
        paintPane(painter, all[1], reference_, tr("Reference"));
        paintPane(painter, all[2], heat_, tr("Difference"));
    }
    for (const QRectF& pane : all) paintMark(painter, pane);
    if (!hasFocus()) return;
    painter.setPen(QPen(theme().accent, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void PicturePanes::wheelEvent(QWheelEvent* event)
{
    const QRectF pane = paneAt(event->position());
    if (pane.isNull()) return;
    pointer_ = event->position();
    zoomAt(event->position(), pane, std::pow(zoomStep, event->angleDelta().y() / 120.0));
    event->accept();
}

bool PicturePanes::isOnWipe(const QPointF& at) const
{
    if (!wiped_) return false;
    const QRectF pane = panes().front();
    return pane.contains(at) && std::abs(at.x() - edgeOf(pane)) <= lineWidth;
}

void PicturePanes::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    dragsWipe_ = isOnWipe(event->position());
    dragged_ = event->position();
    if (!dragsWipe_) setCursor(Qt::ClosedHandCursor);
}

void PicturePanes::mouseMoveEvent(QMouseEvent* event)
{
    pointer_ = event->position();
    if (dragged_ && dragsWipe_) {
        const QRectF place = placeIn(panes().front());
        setWipe((event->position().x() - place.left()) / place.width());
    } else if (dragged_) {
        moveBy((*dragged_ - event->position()) / scale_);
        dragged_ = event->position();
    } else {
        setCursor(isOnWipe(event->position()) ? Qt::SplitHCursor : Qt::CrossCursor);
    }
    update();
    emit pixelChanged();
}

void PicturePanes::mouseReleaseEvent(QMouseEvent*)
{
    dragged_.reset();
    setCursor(Qt::CrossCursor);
}

void PicturePanes::mouseDoubleClickEvent(QMouseEvent*)
{
    fits_ ? setActualSize() : fit();
}

void PicturePanes::keyPressEvent(QKeyEvent* event)
{
    const double far = std::max(1.0, panes().front().width() / scale_ / 8);
    const bool line = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoomBy(zoomStep);
    case Qt::Key_Minus: return zoomBy(1 / zoomStep);
    case Qt::Key_0: return fit();
    case Qt::Key_1: return setActualSize();
    case Qt::Key_Left: return line ? setWipe(wipe_ - 0.05) : moveBy({-far, 0});
    case Qt::Key_Right: return line ? setWipe(wipe_ + 0.05) : moveBy({far, 0});
    case Qt::Key_Up: return moveBy({0, -far});
    case Qt::Key_Down: return moveBy({0, far});
    default: QWidget::keyPressEvent(event);
    }
}

void PicturePanes::resizeEvent(QResizeEvent*)
{
    if (fits_) fit();
}

void PicturePanes::leaveEvent(QEvent*)
{
    pointer_.reset();
    update();
    emit pixelChanged();
}

}  // namespace vitrine::ui

#include "moc_picture_panes.cpp"
