#include "ui/explore/morph_pad.h"

#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"
#include "ui/parameters/number_drag.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double margin = 10;        // Pixels for the handle at the edges.
constexpr double keyStep = 0.02;     // Part of the side for one press of an arrow key.
constexpr double reach = 10;         // Pixels around the handle's center in which a press grabs it.
constexpr double shareOfSide = 0.3;  // Part of the side that a corner's picture takes.

/// Accessible interface of the pad: says the corners and their weights.
class AccessiblePad final : public QAccessibleWidget {
public:
    explicit AccessiblePad(MorphPad* pad) : QAccessibleWidget(pad, QAccessible::Canvas), pad_(pad) {}
    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        return which == QAccessible::Value ? pad_->valueText() : QAccessibleWidget::text(which);
    }

private:
    MorphPad* pad_;
};

QAccessibleInterface* accessible(const QString&, QObject* object)
{
    auto* pad = qobject_cast<MorphPad*>(object);
    return pad ? new AccessiblePad(pad) : nullptr;
}

QPointF inside(const QPointF& place)
{
    return {std::clamp(place.x(), 0.0, 1.0), std::clamp(place.y(), 0.0, 1.0)};
}

}  // namespace

MorphPad::MorphPad(const PadCorners& corners, QWidget* parent) : QWidget(parent), corners_(corners)
{
    static const bool installed = [] {
        QAccessible::installFactory(accessible);
        return true;
    }();
    (void)installed;
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Between four settings"));
    setToolTip(tr("Drag the handle to blend the settings of the four corners. Numbers, colors and angles are "
                  "interpolated; choices are those of the nearest corner. One drag is one undo step; Esc cancels it. "
                  "Arrow keys move the handle, with Shift finer, with Ctrl coarser."));
    tellChange();
    connect(&corners, &PadCorners::changed, this, &MorphPad::tellChange);
}

void MorphPad::show(const QPointF& place, bool hollow)
{
    if (place == place_ && hollow == hollow_) return;
    place_ = place;
    hollow_ = hollow;
    tellChange();
}

void MorphPad::tellChange()
{
    setEnabled(corners_.ready());
    setAccessibleDescription(valueText());
    QAccessibleValueChangeEvent event(this, valueText());
    QAccessible::updateAccessibility(&event);
    update();
}

QString MorphPad::nameOf(const PadCorners::Corner& corner)
{
    switch (corner.source) {
    case PadCorners::Source::onShow: return tr("Current settings");
    case PadCorners::Source::kept: return tr("Kept settings");
    case PadCorners::Source::preset: break;
    }
    return corner.name;
}

QString MorphPad::valueText() const
{
    if (!corners_.ready()) return tr("Reading a preset …");
    const auto weights = PadCorners::weightsAt(place_);
    QStringList parts;
    for (std::size_t i = 0; i < PadCorners::count; ++i)
        if (weights.at(i) > 0.0005)
            parts << tr("%1 % %2", "share of a setting, and its name")
                         .arg(numberLocale().toString(100 * weights.at(i), 'f', 0), nameOf(corners_.at(i)));
    return parts.join(QStringLiteral(", "));
}

QRectF MorphPad::field() const
{
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

QPointF MorphPad::pixelOf(const QPointF& place) const
{
    const QRectF at = field();
    return {at.left() + place.x() * at.width(), at.top() + place.y() * at.height()};
}

void MorphPad::move(const QPointF& place)
{
    const QPointF next = inside(place);
    if (next == place_ && !hollow_) return;
    place_ = next;
    hollow_ = false;
    emit moved(place_, gesture_);
    tellChange();
}

void MorphPad::paintCorner(QPainter& painter, std::size_t corner, double weight) const
{
    const QPointF place = PadCorners::placeOf(corner);
    const QRectF at = field();
    const double width = shareOfSide * at.width();
    const QSizeF size(width, width * 9 / 16);
    const QRectF frame(place.x() > 0 ? at.right() - size.width() : at.left(),
                       place.y() > 0 ? at.bottom() - size.height() : at.top(), size.width(), size.height());
    const Theme& colors = theme();
    painter.save();
    QPainterPath rounded;
    rounded.addRoundedRect(frame, 4, 4);
    painter.setClipPath(rounded);
    painter.setOpacity(0.45 + 0.55 * weight);
    const QPixmap& picture = corners_.at(corner).picture;
    if (!picture.isNull()) {
        painter.drawPixmap(frame, picture, picture.rect());
    } else {
        QColor fill = colors.text;
        fill.setAlphaF(0.08F);
        painter.fillRect(frame, fill);
        painter.setPen(colors.dim);
        painter.drawText(frame.adjusted(4, 0, -4, 0), Qt::AlignCenter | Qt::TextWordWrap, nameOf(corners_.at(corner)));
    }
    painter.restore();
    QColor edge = colors.accent;
    edge.setAlphaF(static_cast<float>(0.15 + 0.85 * weight));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(edge, 1 + weight));
    painter.drawRoundedRect(frame, 4, 4);
}

void MorphPad::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const Theme& colors = theme();
    const QRectF at = field();
    if (!isEnabled()) painter.setOpacity(0.5);
    painter.setPen(QPen(hasFocus() ? colors.accent : colors.outline, 1));
    painter.setBrush(colors.base);
    painter.drawRoundedRect(at.adjusted(-4, -4, 4, 4), 6, 6);

    const auto weights = PadCorners::weightsAt(place_);
    for (std::size_t i = 0; i < PadCorners::count; ++i) paintCorner(painter, i, hollow_ ? 0 : weights.at(i));

    QColor faint = colors.text;
    faint.setAlphaF(0.1F);
    painter.setPen(QPen(faint, 1));
    painter.drawLine(QPointF(at.center().x(), at.top()), QPointF(at.center().x(), at.bottom()));
    painter.drawLine(QPointF(at.left(), at.center().y()), QPointF(at.right(), at.center().y()));

    const QPointF handle = pixelOf(place_);
    QColor cross = colors.accent;
    cross.setAlphaF(hollow_ ? 0.15F : 0.4F);
    painter.setPen(QPen(cross, 1));
    painter.drawLine(QPointF(at.left(), handle.y()), QPointF(at.right(), handle.y()));
    painter.drawLine(QPointF(handle.x(), at.top()), QPointF(handle.x(), at.bottom()));
    if (hasFocus()) {
        QColor ring = colors.accent;
        ring.setAlphaF(0.3F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ring);
        painter.drawEllipse(handle, 11, 11);
    }
    painter.setPen(QPen(hollow_ ? colors.dim : colors.base, 2));
    painter.setBrush(hollow_ ? QBrush(colors.base) : QBrush(colors.accent));
    painter.drawEllipse(handle, 6.5, 6.5);
}

void MorphPad::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    gesture_ = newGesture();
    placeAtPress_ = place_;
    hollowAtPress_ = hollow_;
    dragging_ = true;
    grip_ = event->position();
    // A press on the handle grabs it; a press elsewhere moves the handle there.
    if (QLineF(grip_, pixelOf(place_)).length() > reach) {
        const QRectF at = field();
        move({(grip_.x() - at.left()) / at.width(), (grip_.y() - at.top()) / at.height()});
    }
    update();
}

void MorphPad::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragging_) return;
    const QRectF at = field();
    const QPointF by = event->position() - grip_;
    if (by.isNull()) return;
    grip_ = event->position();
    const bool fine = event->modifiers() & Qt::ShiftModifier;
    const double gain = factor(fine ? Gain::fine : Gain::normal);
    QPointF next = place_ + QPointF(by.x() / at.width(), by.y() / at.height()) * gain;
    // When the pointer returns from outside of the square, the handle follows it again.
    const QPointF under{(grip_.x() - at.left()) / at.width(), (grip_.y() - at.top()) / at.height()};
    if (!fine && QLineF(pixelOf(next), grip_).length() > reach) next = under;
    move(next);
}

void MorphPad::mouseReleaseEvent(QMouseEvent*)
{
    dragging_ = false;
    update();
}

void MorphPad::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

void MorphPad::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && dragging_) {
        dragging_ = false;
        place_ = placeAtPress_;
        hollow_ = hollowAtPress_;
        emit takenBack(gesture_);
        tellChange();
        return;
    }
    const double step = keyStep * factor(gainOf(event->modifiers()));
    const auto go = [&](const QPointF& place) {
        // A held key is one gesture.
        if (!event->isAutoRepeat()) gesture_ = newGesture();
        move(place);
    };
    switch (event->key()) {
    case Qt::Key_Left: go(place_ - QPointF(step, 0)); return;
    case Qt::Key_Right: go(place_ + QPointF(step, 0)); return;
    case Qt::Key_Up: go(place_ - QPointF(0, step)); return;
    case Qt::Key_Down: go(place_ + QPointF(0, step)); return;
    case Qt::Key_Home: go({0, 0}); return;
    case Qt::Key_End: go({1, 1}); return;
    default: event->ignore();
    }
}

}  // namespace vitrine::ui

#include "moc_morph_pad.cpp"
