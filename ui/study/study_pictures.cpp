#include "ui/study/study_pictures.h"

#include "render/image/srgb.h"
#include "render/measure/metrics.h"
#include "ui/kit/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

QImage screenImage(const render::Image& picture)
{
    if (picture.empty()) return {};
    QImage image(picture.width, picture.height, QImage::Format_RGB888);
    for (int y = 0; y < picture.height; ++y) {
        uchar* line = image.scanLine(y);
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                *line++ = render::srgb8FromLinear(picture.at(x, y, picture.channels < 3 ? 0 : c));
    }
    return image;
}

QString noPixelDiffers()
{
    return StudyPictures::tr("No pixel differs.");
}

namespace {

constexpr double wipeStep = 0.05;
constexpr double scaleHeight = 20;  ///< Pixels below the heat map for its color scale, from 0 to the largest error.

/// Returns the heat map's colors from 0 to full, left to right.
const QImage& heatRamp()
{
    static const QImage ramp = [] {
        render::Image errors(128, 1, 1);
        for (int x = 0; x < errors.width; ++x) errors.at(x, 0, 0) = static_cast<float>(x) / 127;
        return screenImage(render::heatMap(errors, 1));
    }();
    return ramp;
}

}  // namespace

StudyPictures::StudyPictures(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Picture and reference"));
    setAccessibleDescription(tr("Left of the line the setting, right of it the reference; arrows move the line."));
    setToolTip(tr("Left of the line: the setting. Right of it: the reference. Beside it: where they differ.\nA double "
                  "click, or Enter, opens them large, to zoom into."));
}

void StudyPictures::show(const QImage& picture, const QImage& reference, const QImage& heat, const QString& full)
{
    picture_ = picture;
    reference_ = reference;
    heat_ = heat;
    full_ = full;
    update();
}

void StudyPictures::setWipe(double share)
{
    wipe_ = std::clamp(share, 0.0, 1.0);
    update();
    notifyNumber(*this);
}

QString StudyPictures::accessibleText() const
{
    return picture_.isNull() ? tr("Nothing is measured yet.") : QString();
}

std::optional<AccessibleNumber> StudyPictures::accessibleNumber() const
{
    return AccessibleNumber{wipe_ * 100, 0, 100, wipeStep * 100, tr("%1 % the setting").arg(std::lround(wipe_ * 100))};
}

QRectF StudyPictures::placeOf(int index) const
{
    constexpr double gap = 8;
    const QSizeF picture = picture_.isNull() ? QSizeF(16, 9) : QSizeF(picture_.size());
    // Side by side or one above the other, whichever is larger.
    const QSizeF beside = picture.scaled(QSizeF((width() - gap) / 2, height() - scaleHeight), Qt::KeepAspectRatio);
    const QSizeF above = picture.scaled(QSizeF(width(), (height() - gap - scaleHeight) / 2), Qt::KeepAspectRatio);
    if (beside.width() >= above.width()) return {QPointF(index * (beside.width() + gap), 0), beside};
    return {QPointF(0, index * (above.height() + gap)), above};
}

void StudyPictures::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRectF at = placeOf(0);
    paintPictures(painter, at);
    if (!hasFocus()) return;
    painter.setPen(QPen(theme().accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(at.adjusted(0, 0, -1, -1));
}

void StudyPictures::paintPictures(QPainter& painter, const QRectF& at)
{
    if (picture_.isNull()) return;
    painter.drawImage(at, picture_);
    const double edge = at.left() + wipe_ * at.width();
    if (!reference_.isNull()) {
        painter.save();
        painter.setClipRect(QRectF(edge, at.top(), at.right() - edge, at.height()));
        painter.drawImage(at, reference_);
        painter.restore();
        painter.setPen(QPen(theme().accent, 1));
        painter.drawLine(QPointF(edge, at.top()), QPointF(edge, at.bottom()));
    }
    if (heat_.isNull()) {
        painter.setPen(theme().dim);
        painter.drawText(placeOf(1), Qt::AlignCenter | Qt::TextWordWrap, noPixelDiffers());
    } else {
        const QRectF map = placeOf(1);
        painter.drawImage(map, heat_);
        const QRectF below(map.left(), map.bottom() + 3, map.width(), scaleHeight - 4);
        const double zero = painter.fontMetrics().horizontalAdvance(QStringLiteral("0")) + 6;
        const double most =
            std::min<double>(painter.fontMetrics().horizontalAdvance(full_) + 6, below.width() - zero - 16);
        painter.drawImage(below.adjusted(zero, 3, -most, -3), heatRamp());
        painter.setPen(theme().dim);
        painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("0"));
        painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(full_, Qt::ElideRight, static_cast<int>(most)));
    }
}

void StudyPictures::mouseMoveEvent(QMouseEvent* event)
{
    const QRectF at = placeOf(0);
    if (at.contains(event->position())) setWipe((event->position().x() - at.left()) / at.width());
}

void StudyPictures::mouseDoubleClickEvent(QMouseEvent*)
{
    emit enlargeAsked();
}

void StudyPictures::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Left)
        setWipe(wipe_ - wipeStep);
    else if (event->key() == Qt::Key_Right)
        setWipe(wipe_ + wipeStep);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        emit enlargeAsked();
    else
        QWidget::keyPressEvent(event);
}

}  // namespace vitrine::ui

#include "moc_study_pictures.cpp"
