#include "ui/parameters/value_slider.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/accessible_number.h"
#include "ui/parameters/number_drag.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double margin = 7;  // Pixels for the handle at both ends.

}  // namespace

ValueSlider::ValueSlider(const ParameterInfo& parameter, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), row_(parameter), scale_(parameter)
{
    setRange(0, ticks);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setMouseTracking(false);
}

QSize ValueSlider::sizeHint() const
{
    return {96, grown(20, *this)};
}

void ValueSlider::showValue(double value)
{
    if (value == value_) return;
    value_ = value;
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(std::clamp(scale_.position(value), 0.0, 1.0) * ticks)));
    update();
    notifyNumber(*this);
}

std::optional<AccessibleNumber> ValueSlider::accessibleNumber() const
{
    return vitrine::ui::accessibleNumber(row_, scale_, value_, row_.range.softLow, row_.range.softHigh);
}

void ValueSlider::setAccessibleNumber(double value)
{
    edit(storedNumber(row_, value), newGesture());
}

double ValueSlider::positionAt(double x) const
{
    return std::clamp((x - margin) / std::max(1.0, width() - 2 * margin), 0.0, 1.0);
}

double ValueSlider::xAt(double position) const
{
    return margin + std::clamp(position, 0.0, 1.0) * (width() - 2 * margin);
}

void ValueSlider::edit(double value, Gesture gesture)
{
    if (value == value_) return;
    showValue(value);
    emit edited(value, gesture);
}

void ValueSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colors = theme();
    const double middle = height() / 2.0;
    const double x = xAt(scale_.position(value_));
    const bool active = underMouse() || hasFocus() || dragging_;

    QColor track = colors.text;
    track.setAlphaF(colors.dark ? 0.16F : 0.2F);
    if (colors.highContrast) track = colors.outline;
    painter.setPen(Qt::NoPen);
    painter.setBrush(track);
    painter.drawRoundedRect(QRectF(margin, middle - 1.5, width() - 2 * margin, 3), 1.5, 1.5);
    painter.setBrush(active ? colors.accent : colors.dim);
    painter.drawRoundedRect(QRectF(margin, middle - 1.5, x - margin, 3), 1.5, 1.5);

    const double initial = xAt(scale_.position(std::get<double>(row_.initial)));
    QColor tick = colors.dim;
    tick.setAlphaF(0.7F);
    painter.setBrush(tick);
    painter.drawRect(QRectF(initial - 0.5, middle + 4, 1, 4));

    if (hasFocus()) {
        QColor ring = colors.accent;
        ring.setAlphaF(0.3F);
        painter.setBrush(ring);
        painter.drawEllipse(QPointF(x, middle), 8, 8);
    }
    painter.setBrush(active ? colors.accent : colors.dark ? colors.text : colors.dim);
    painter.drawEllipse(QPointF(x, middle), 5, 5);
}

void ValueSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    gesture_ = newGesture();
    valueAtPress_ = value_;
    dragging_ = true;
    lastX_ = event->position().x();
    position_ = std::clamp(scale_.position(value_), 0.0, 1.0);
    // A press on the handle grabs it; a press elsewhere moves the handle there.
    if (std::abs(lastX_ - xAt(position_)) > 7) {
        position_ = positionAt(lastX_);
        edit(scale_.value(position_), gesture_);
    }
    update();
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragging_) return;
    const Gain gain = event->modifiers() & Qt::ShiftModifier ? Gain::fine : Gain::normal;
    const double x = event->position().x();
    if (x == lastX_) return;
    position_ += (x - lastX_) / std::max(1.0, width() - 2 * margin) * factor(gain);
    if (gain == Gain::normal && std::abs(xAt(position_) - x) < 8) position_ = positionAt(x);
    position_ = std::clamp(position_, 0.0, 1.0);
    lastX_ = x;
    edit(scale_.value(position_, gain), gesture_);
}

void ValueSlider::mouseReleaseEvent(QMouseEvent*)
{
    dragging_ = false;
    update();
}

void ValueSlider::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && dragging_) {
        dragging_ = false;
        edit(valueAtPress_, gesture_);
        return;
    }
    const Gain gain = gainOf(event->modifiers());
    // A held key is one gesture.
    if (!event->isAutoRepeat()) gesture_ = newGesture();
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down: edit(scale_.stepped(value_, -1, gain), gesture_); return;
    case Qt::Key_Right:
    case Qt::Key_Up: edit(scale_.stepped(value_, 1, gain), gesture_); return;
    case Qt::Key_PageDown: edit(scale_.stepped(value_, -1, Gain::coarse), gesture_); return;
    case Qt::Key_PageUp: edit(scale_.stepped(value_, 1, Gain::coarse), gesture_); return;
    case Qt::Key_Home: edit(scale_.value(0), gesture_); return;
    case Qt::Key_End: edit(scale_.value(1), gesture_); return;
    default: event->ignore();
    }
}

void ValueSlider::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    edit(scale_.stepped(value_, event->angleDelta().y() > 0 ? 1 : -1, gainOf(event->modifiers())), newGesture());
    event->accept();
}

}  // namespace vitrine::ui

#include "moc_value_slider.cpp"
