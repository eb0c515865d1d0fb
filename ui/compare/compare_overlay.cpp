#include "ui/compare/compare_overlay.h"

#include "ui/compare/difference_image.h"
#include "ui/compare/picture_b.h"
#include "ui/kit/progress_job.h"
#include "ui/kit/theme.h"
#include "ui/model/settings_b.h"
#include "ui/viewport/picture_place.h"
#include "ui/viewport/viewport.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr double grabWipeWithin = 7;  ///< Pixels.
constexpr double wipeStep = 0.02;     ///< Part of the width for one press of a key.
constexpr int gap = 4;                ///< Pixels between two pictures side by side.
const QColor veil(0x20, 0x1e, 0x1c);  ///< Background around the pictures, as in the viewport without a picture.

}  // namespace

CompareOverlay::CompareOverlay(Viewport& viewport, const SettingsB& other, PictureB& picture)
    : QWidget(&viewport), viewport_(viewport), other_(other), picture_(picture), job_(new ProgressJob(this))
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Comparison of A and B"));
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    connect(&viewport.pictures(), &ViewportPictures::drawn, this, &CompareOverlay::renew);
    connect(&viewport, &Viewport::looked, this, &CompareOverlay::renew);
    connect(&picture, &PictureB::drawn, this, &CompareOverlay::renew);
    connect(&picture, &PictureB::gone, this, [this] {
        difference_ = {};
        differenceKey_ = {};
        renew();
    });
    connect(&other, &SettingsB::changed, this, [this] {
        if (!other_.isSet()) held_ = false;  // The key may still be down, but its release will not be seen.
        renew();
    });
    lower();
    hide();
}

void CompareOverlay::setMode(CompareMode mode)
{
    if (mode == mode_) return;
    mode_ = mode;
    difference_ = {};
    differenceKey_ = {};
    emit needsChanged();
    renew();
}

void CompareOverlay::setGain(int gain)
{
    gain_ = gain;
    renew();
}

void CompareOverlay::setOtherAlone(bool alone)
{
    alone_ = alone;
    emit needsChanged();
    renew();
}

void CompareOverlay::setWipe(double share)
{
    wipe_ = std::clamp(share, 0.0, 1.0);
    update();
    notifyNumber(*this);
}

bool CompareOverlay::showsWipe() const
{
    return isVisible() && mode_ == CompareMode::wipe && !otherAlone();
}

QAccessible::Role CompareOverlay::accessibleRole() const
{
    return showsWipe() ? QAccessible::Slider : QAccessible::Graphic;
}

std::optional<AccessibleNumber> CompareOverlay::accessibleNumber() const
{
    if (!showsWipe()) return std::nullopt;
    return AccessibleNumber{100 * wipe_, 0, 100, 100 * wipeStep, tr("A up to %1 %").arg(std::lround(100 * wipe_))};
}

QString CompareOverlay::accessibleText() const
{
    if (otherAlone()) return otherText();
    switch (mode_) {
    case CompareMode::wipe:
        return tr("A left of the line, at %1 %; right of it %2.").arg(std::lround(100 * wipe_)).arg(otherText());
    case CompareMode::sideBySide: return tr("A on the left; on the right %1.").arg(otherText());
    case CompareMode::flicker: return tr("A; hold the key B to see B");
    case CompareMode::flip: return tr("FLIP of A and B × %1").arg(gain());
    case CompareMode::signedDifference: return tr("(B − A) × %1").arg(gain());
    case CompareMode::off: break;
    }
    return {};
}

void CompareOverlay::renew()
{
    const bool shown = other_.isSet() && (mode_ != CompareMode::off || otherAlone()) && !picture_.image().isNull();
    setVisible(shown);
    viewport_.setCovered(shown && (otherAlone() || mode_ == CompareMode::sideBySide || isDifference(mode_)));
    if (!shown) return;
    // The difference is computed only if both pictures have the same time and camera.
    if (isDifference(mode_) && picture_.present()) computeDifference();
    update();
}

void CompareOverlay::computeDifference()
{
    const DifferenceKey key{viewport_.pictures().shown().image().cacheKey(), picture_.image().cacheKey(), mode_,
                            gain()};
    if (key == differenceKey_) return;
    // One difference at a time. Otherwise pictures that come faster than differences would cancel each one.
    differenceDue_ = job_->running();
    if (differenceDue_) return;
    differenceKey_ = key;
    job_->start([this, a = viewport_.pictures().shown().image(), b = picture_.image(), mode = mode_,
                 gain = gain()](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        QImage made = differenceImage(a, b, mode, gain);
        return [this, mode, made = std::move(made)] {
            if (mode == mode_) difference_ = made;
            update();
            if (std::exchange(differenceDue_, false))
                QMetaObject::invokeMethod(this, &CompareOverlay::renew, Qt::QueuedConnection);
        };
    });
}

QRect CompareOverlay::pictureOf(bool other) const
{
    const QSize half((width() - gap) / 2, height());
    const QSize size = QSize(std::max(width(), 1), std::max(height(), 1)).scaled(half, Qt::KeepAspectRatio);
    const int left = other ? width() - half.width() : 0;
    return {QPoint(left + (half.width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QString CompareOverlay::otherText() const
{
    return (picture_.upToDate() ? tr("B: %1") : tr("B: %1, being drawn")).arg(other_.name());
}

void CompareOverlay::label(QPainter& painter, const QRect& in, Qt::Alignment where, const QString& words) const
{
    const QString shown = fontMetrics().elidedText(words, Qt::ElideRight, std::max(in.width() - 32, 16));
    QRect box(QPoint(0, 0), fontMetrics().size(Qt::TextSingleLine, shown) + QSize(12, 6));
    const QRect room = in.adjusted(8, 8, -8, -8);
    box.moveTop(room.top());
    box.moveLeft(where & Qt::AlignRight ? room.right() - box.width() : room.left());
    if (!in.contains(box)) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(QColor(0xf0, 0xec, 0xe4));
    painter.drawText(box, Qt::AlignCenter, shown);
}

void CompareOverlay::paintWipe(QPainter& painter)
{
    const int line = static_cast<int>(std::lround(wipe_ * width()));
    const QRect right(line, 0, width() - line, height()), left(0, 0, line, height());
    painter.save();
    painter.setClipRect(right);
    painter.drawImage(pictureIn(picture_.image().size(), QRectF(rect())), picture_.image());
    painter.restore();
    painter.fillRect(QRect(line - 2, 0, 4, height()), QColor(0, 0, 0, 110));
    painter.fillRect(QRect(line - 1, 0, 2, height()), theme().accent);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 110), 1));
    painter.setBrush(theme().accent);
    painter.drawEllipse(QPointF(line, height() / 2.0), 6, 6);
    label(painter, left, Qt::AlignRight, tr("A"));
    label(painter, right, Qt::AlignLeft, otherText());
}

void CompareOverlay::paintSideBySide(QPainter& painter)
{
    painter.fillRect(rect(), veil);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (const bool other : {false, true}) {
        const QImage& image = other ? picture_.image() : viewport_.pictures().shown().image();
        painter.save();
        painter.setClipRect(pictureOf(other));
        painter.drawImage(pictureIn(image.size(), QRectF(pictureOf(other))), image);
        painter.restore();
        label(painter, pictureOf(other), Qt::AlignLeft, other ? otherText() : tr("A"));
    }
}

void CompareOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (otherAlone()) {
        painter.drawImage(pictureIn(picture_.image().size(), QRectF(rect())), picture_.image());
        label(painter, rect(), Qt::AlignLeft, otherText());
        return;
    }
    switch (mode_) {
    case CompareMode::off: return;
    case CompareMode::wipe: paintWipe(painter); return;
    case CompareMode::sideBySide: paintSideBySide(painter); return;
    case CompareMode::flicker: label(painter, rect(), Qt::AlignLeft, tr("A; hold the key B to see B")); return;
    case CompareMode::flip:
    case CompareMode::signedDifference: break;
    }
    if (difference_.isNull()) return;
    painter.drawImage(pictureIn(difference_.size(), QRectF(rect())), difference_);
    label(painter, rect(), Qt::AlignLeft,
          mode_ == CompareMode::flip ? tr("FLIP of A and B × %1").arg(gain()) : tr("(B − A) × %1").arg(gain()));
}

bool CompareOverlay::dragWipe(const QMouseEvent& event)
{
    const bool shown = showsWipe();
    if (!shown) dragging_ = false;
    const bool near = shown && std::abs(event.position().x() - wipe_ * width()) <= grabWipeWithin;
    switch (event.type()) {
    case QEvent::MouseButtonPress: dragging_ = near && event.button() == Qt::LeftButton; return dragging_;
    case QEvent::MouseButtonRelease: return std::exchange(dragging_, false);
    case QEvent::MouseMove:
        if (dragging_) {
            setWipe(event.position().x() / std::max(width(), 1));
            return true;
        }
        if (event.buttons() != Qt::NoButton) return false;
        if (near)
            viewport_.setCursor(Qt::SplitHCursor);
        else if (near_)
            viewport_.unsetCursor();
        near_ = near;
        return near;
    default: return false;
    }
}

bool CompareOverlay::passOn(const QMouseEvent& event)
{
    // While the right button turns the head, the pointer is locked.
    const bool right = event.button() == Qt::RightButton || (event.buttons() & Qt::RightButton);
    if (!isVisible() || mode_ != CompareMode::sideBySide || otherAlone() || right) return false;
    // A drag stays in the picture in which it began.
    const bool other = pressedOther_.value_or(event.position().x() > width() / 2.0);
    const QRect in = pictureOf(other);
    const QPointF at((event.position().x() - in.left()) * width() / std::max(in.width(), 1),
                     (event.position().y() - in.top()) * height() / std::max(in.height(), 1));
    if (event.type() == QEvent::MouseButtonPress) {
        if (!QRectF(rect()).contains(at)) return true;
        pressedOther_ = other;
    } else if (event.type() == QEvent::MouseButtonRelease) {
        pressedOther_.reset();
    }
    QMouseEvent moved(event.type(), at, viewport_.mapToGlobal(at), event.button(), event.buttons(), event.modifiers());
    passing_ = true;
    QCoreApplication::sendEvent(&viewport_, &moved);
    passing_ = false;
    return true;
}

bool CompareOverlay::holdKey(QEvent* event)
{
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (key.key() != Qt::Key_B) return false;
    if (event->type() == QEvent::KeyRelease) {
        const bool was = held_;
        if (!key.isAutoRepeat()) hold(false);
        return was;
    }
    if (!other_.isSet() || (!plain && !held_)) return false;
    if (event->type() == QEvent::ShortcutOverride)
        event->accept();
    else if (!key.isAutoRepeat())
        hold(true);
    return true;
}

bool CompareOverlay::moveWipe(QEvent* event)
{
    const auto& key = *static_cast<QKeyEvent*>(event);
    const int step = key.key() == Qt::Key_Comma ? -1 : key.key() == Qt::Key_Period ? 1 : 0;
    if (step == 0 || !showsWipe() || event->type() == QEvent::KeyRelease) return false;
    if (key.modifiers() & ~Qt::KeypadModifier) return false;
    if (event->type() == QEvent::ShortcutOverride)
        event->accept();
    else
        setWipe(wipe_ + step * wipeStep);
    return true;
}

void CompareOverlay::hold(bool down)
{
    if (std::exchange(held_, down) == down) return;
    emit needsChanged();
    renew();
}

bool CompareOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (passing_) return false;
    switch (event->type()) {
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease: return holdKey(event) || moveWipe(event);
    case QEvent::FocusOut: hold(false); break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        return dragWipe(mouse) || passOn(mouse);
    }
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace vitrine::ui

#include "moc_compare_overlay.cpp"
