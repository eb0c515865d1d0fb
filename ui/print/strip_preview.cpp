#include "ui/print/strip_preview.h"

#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vitrine::ui {
namespace {

constexpr double leastZoom = 0.25, mostZoom = 48;
constexpr double leastLensOnScreen = 6;  // Pixels per lens; lines that are closer would merge to gray.

}  // namespace

QImage imageOf(const printing::CodedPicture& picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB888);
    const std::size_t row = static_cast<std::size_t>(picture.width) * 3;
    for (int y = 0; y < picture.height; ++y)
        std::memcpy(image.scanLine(y), picture.rgb.data() + static_cast<std::size_t>(y) * row, row);
    return image;
}

StripPreview::StripPreview(QWidget* parent) : QWidget(parent), job_(this)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Printed raster"));
    setToolTip(tr("The dots as they will be printed; lines are the edges between lenses.\nThe wheel, + and - zoom; "
                  "dragging and the arrows move; Home goes to the middle."));
    setMinimumHeight(120);
    setCursor(Qt::OpenHandCursor);
    connect(&job_, &NewestJob::failed, this, [this] {
        image_ = {};
        update();
    });
}

void StripPreview::setPreview(std::shared_ptr<const printing::PrintPreview> preview)
{
    const bool moved =
        !preview || !preview_ || preview->width() != preview_->width() || preview->height() != preview_->height();
    preview_ = std::move(preview);
    job_.forget();
    if (!preview_)
        image_ = {};
    else if (moved)
        middle_ = {static_cast<double>(preview_->width()) / 2, static_cast<double>(preview_->height()) / 2};
    fetch();
}

void StripPreview::setZoom(double zoom)
{
    zoom_ = std::clamp(zoom, leastZoom, mostZoom);
    fetch();
    notifyNumber(*this);
}

QString StripPreview::scaleText() const
{
    return zoom_ >= 1 ? tr("1 dot : %1 px").arg(numberLocale().toString(zoom_, 'g', 3))
                      : tr("%1 dots : 1 px").arg(numberLocale().toString(1 / zoom_, 'g', 3));
}

QString StripPreview::accessibleText() const
{
    if (!preview_) return tr("Nothing to print yet");
    return tr("%1 × %2 dots, seen around the one at %3, %4.")
        .arg(preview_->width())
        .arg(preview_->height())
        .arg(std::llround(middle_.x()))
        .arg(std::llround(middle_.y()));
}

std::optional<AccessibleNumber> StripPreview::accessibleNumber() const
{
    return AccessibleNumber{zoom_, leastZoom, mostZoom, 0.25 * zoom_, scaleText()};
}

QPointF StripPreview::toScreen(double x, double y) const
{
    return {(x - middle_.x()) * zoom_ + width() / 2.0, (y - middle_.y()) * zoom_ + height() / 2.0};
}

void StripPreview::clampView()
{
    const auto within = [](double at, double half, double size) {
        return size <= 2 * half ? size / 2 : std::clamp(at, half, size - half);
    };
    middle_ = {within(middle_.x(), width() / 2.0 / zoom_, static_cast<double>(preview_->width())),
               within(middle_.y(), height() / 2.0 / zoom_, static_cast<double>(preview_->height()))};
}

void StripPreview::fetch()
{
    update();
    if (!preview_ || width() < 1 || height() < 1) return;
    clampView();
    const auto edge = [](double at, std::int64_t size) { return std::clamp<std::int64_t>(std::llround(at), 0, size); };
    const std::int64_t x0 = edge(std::floor(middle_.x() - width() / 2.0 / zoom_), preview_->width() - 1);
    const std::int64_t y0 = edge(std::floor(middle_.y() - height() / 2.0 / zoom_), preview_->height() - 1);
    const std::int64_t x1 = std::max(x0 + 1, edge(std::ceil(middle_.x() + width() / 2.0 / zoom_), preview_->width()));
    const std::int64_t y1 = std::max(y0 + 1, edge(std::ceil(middle_.y() + height() / 2.0 / zoom_), preview_->height()));
    job_.ask([this, preview = preview_, x0, y0, x1, y1]() -> NewestJob::Outcome {
        const QImage image = imageOf(preview->raster({x0, y0, x1, y1}));
        return [this, image, x0, y0, x1, y1] {
            image_ = image;
            imageRegion_ = QRectF(static_cast<double>(x0), static_cast<double>(y0), static_cast<double>(x1 - x0),
                                  static_cast<double>(y1 - y0));
            update();
        };
    });
}

void StripPreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().base);
    if (!preview_ || image_.isNull()) {
        painter.setPen(theme().dim);
        painter.drawText(rect(), Qt::AlignCenter, preview_ ? tr("Interlacing") : tr("Nothing to print yet"));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < 1);
        painter.drawImage(QRectF(toScreen(imageRegion_.left(), imageRegion_.top()), imageRegion_.size() * zoom_),
                          image_);
        paintLenses(painter);
        const QString scale = scaleText();
        const QRect box = painter.fontMetrics().boundingRect(scale).adjusted(-8, -4, 8, 4);
        QColor veil = theme().window;
        veil.setAlphaF(0.8F);
        const QRect place(width() - box.width() - 8, height() - box.height() - 8, box.width(), box.height());
        painter.fillRect(place, veil);
        painter.setPen(theme().text);
        painter.drawText(place, Qt::AlignCenter, scale);
    }
    if (hasFocus()) {
        painter.setPen(theme().accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void StripPreview::paintLenses(QPainter& painter) const
{
    const printing::LensGrid grid = preview_->lenses();
    const double perPixel = std::hypot(grid.perX, grid.perY);
    if (!(perPixel > 0) || zoom_ / perPixel < leastLensOnScreen) return;
    const QRectF paper = QRectF(toScreen(0, 0), toScreen(static_cast<double>(preview_->width()),
                                                         static_cast<double>(preview_->height()))) &
                         QRectF(rect());
    // A dark line beside a light one is visible on any picture.
    const QColor dark(0, 0, 0, 150);
    const QColor light(255, 255, 255, 150);
    const auto draw = [&](const QPointF& from, const QPointF& to, const QPointF& aside) {
        painter.setPen(QPen(dark, 1));
        painter.drawLine(from, to);
        painter.setPen(QPen(light, 1));
        painter.drawLine(from + aside, to + aside);
    };
    painter.save();
    painter.setClipRect(paper);
    painter.setRenderHint(QPainter::Antialiasing, grid.perX != 0 && grid.perY != 0);
    const auto lensAt = [&](const QPointF& screen) {
        return grid.at0 + grid.perX * ((screen.x() - width() / 2.0) / zoom_ + middle_.x()) +
               grid.perY * ((screen.y() - height() / 2.0) / zoom_ + middle_.y());
    };
    double least = lensAt(paper.topLeft());
    double most = least;
    for (const QPointF& corner : {paper.topRight(), paper.bottomLeft(), paper.bottomRight()}) {
        least = std::min(least, lensAt(corner));
        most = std::max(most, lensAt(corner));
    }
    for (double cusp = std::ceil(least); cusp <= most; ++cusp) {
        // Intersections with the two edges between which the lenses run.
        if (std::abs(grid.perX) >= std::abs(grid.perY)) {
            const auto at = [&](double y) {
                return (cusp - grid.at0 - grid.perY * ((y - height() / 2.0) / zoom_ + middle_.y())) / grid.perX;
            };
            const double x0 = toScreen(at(paper.top()), 0).x();
            const double x1 = toScreen(at(paper.bottom()), 0).x();
            draw(QPointF(x0, paper.top()), QPointF(x1, paper.bottom()), {1, 0});
        } else {
            const auto at = [&](double x) {
                return (cusp - grid.at0 - grid.perX * ((x - width() / 2.0) / zoom_ + middle_.x())) / grid.perY;
            };
            draw(QPointF(paper.left(), toScreen(0, at(paper.left())).y()),
                 QPointF(paper.right(), toScreen(0, at(paper.right())).y()), {0, 1});
        }
    }
    painter.restore();
}

void StripPreview::resizeEvent(QResizeEvent*)
{
    fetch();
}

void StripPreview::zoomAbout(const QPointF& place, double factor)
{
    const double zoom = std::clamp(zoom_ * factor, leastZoom, mostZoom);
    const QPointF off(place.x() - width() / 2.0, place.y() - height() / 2.0);
    middle_ += off / zoom_ - off / zoom;  // The point under the pointer stays in place.
    setZoom(zoom);
}

void StripPreview::moveBy(const QPointF& screen)
{
    middle_ -= screen / zoom_;
    fetch();
}

void StripPreview::wheelEvent(QWheelEvent* event)
{
    zoomAbout(event->position(), std::pow(1.25, event->angleDelta().y() / 120.0));
    event->accept();
}

void StripPreview::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    grabbed_ = event->position();
    setCursor(Qt::ClosedHandCursor);
}

void StripPreview::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragging_) return;
    moveBy(event->position() - grabbed_);
    grabbed_ = event->position();
}

void StripPreview::mouseReleaseEvent(QMouseEvent*)
{
    dragging_ = false;
    setCursor(Qt::OpenHandCursor);
}

void StripPreview::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomAbout(middle, 1.25); break;
    case Qt::Key_Minus: zoomAbout(middle, 0.8); break;
    case Qt::Key_Left: moveBy({40, 0}); break;
    case Qt::Key_Right: moveBy({-40, 0}); break;
    case Qt::Key_Up: moveBy({0, 40}); break;
    case Qt::Key_Down: moveBy({0, -40}); break;
    case Qt::Key_Home:
        if (preview_)
            middle_ = {static_cast<double>(preview_->width()) / 2, static_cast<double>(preview_->height()) / 2};
        fetch();
        break;
    default: QWidget::keyPressEvent(event);
    }
}

}  // namespace vitrine::ui

#include "moc_strip_preview.cpp"
