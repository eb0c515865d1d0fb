#include "ui/parameters/number_field.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/accessible_number.h"
#include "ui/parameters/shown_text.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

namespace vitrine::ui {

NumberField::NumberField(const ParameterInfo& parameter, QWidget* parent)
    : QLineEdit(parent), row_(parameter), drag_(parameter), scale_(parameter)
{
    setFrame(false);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setTextMargins(2, 0, 2, 0);
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::NoContextMenu);  // The menu of the parameter opens instead, which has "Reset".
    growHeight(*this, 22);
    setAttribute(Qt::WA_Hover);
    endEdit();
    QPalette clear = palette();
    clear.setColor(QPalette::Base, Qt::transparent);
    setPalette(clear);
}

QSize NumberField::sizeHint() const
{
    return {grown(80, *this), grown(22, *this)};
}

QSize NumberField::minimumSizeHint() const
{
    return {grown(56, *this), grown(22, *this)};
}

void NumberField::showValue(double value)
{
    if (value == value_) return;
    value_ = value;
    if (!editing_) refresh();
    notifyNumber(*this);
}

std::optional<AccessibleNumber> NumberField::accessibleNumber() const
{
    return vitrine::ui::accessibleNumber(row_, scale_, value_, row_.range.low, row_.range.high);
}

void NumberField::setAccessibleNumber(double value)
{
    if (editing_) endEdit();
    edit(storedNumber(row_, value), newGesture());
}

void NumberField::refresh()
{
    setText(shownText(row_, value_));
    setCursorPosition(0);
}

void NumberField::edit(double value, Gesture gesture)
{
    if (value == value_) return;
    showValue(value);
    emit edited(value, gesture);
}

void NumberField::beginEdit()
{
    if (editing_) return;
    editing_ = true;
    wrong_ = false;
    setReadOnly(false);
    setCursor(Qt::IBeamCursor);
    setText(editedText(row_, value_));
    selectAll();
    update();
}

void NumberField::endEdit()
{
    editing_ = false;
    wrong_ = false;
    setReadOnly(true);
    setCursor(Qt::SizeHorCursor);
    deselect();
    refresh();
    update();
}

bool NumberField::commit()
{
    if (!editing_ || text() == editedText(row_, value_)) {
        endEdit();
        return true;
    }
    QString problem;
    const std::optional<Value> typed = typedValue(row_, text(), &problem);
    const QPoint below = mapToGlobal(QPoint(0, height()));
    if (!typed) {
        wrong_ = true;
        update();
        QToolTip::showText(below, problem, this);
        return false;
    }
    endEdit();
    if (!problem.isEmpty()) QToolTip::showText(below, problem, this);
    edit(std::get<double>(*typed), newGesture());
    return true;
}

void NumberField::dragFrom(double x)
{
    gesture_ = newGesture();
    drag_.press(value_, x);
}

void NumberField::dragTo(double x, Qt::KeyboardModifiers modifiers)
{
    if (drag_.move(x, gainOf(modifiers))) edit(drag_.value(), gesture_);
}

void NumberField::dragEnd()
{
    drag_.release();
}

void NumberField::mousePressEvent(QMouseEvent* event)
{
    if (editing_ || event->button() != Qt::LeftButton) {
        QLineEdit::mousePressEvent(event);
        return;
    }
    dragFrom(event->position().x());
}

void NumberField::mouseMoveEvent(QMouseEvent* event)
{
    if (!drag_.pressed()) {
        QLineEdit::mouseMoveEvent(event);
        return;
    }
    dragTo(event->position().x(), event->modifiers());
}

void NumberField::mouseReleaseEvent(QMouseEvent* event)
{
    if (!drag_.pressed()) {
        QLineEdit::mouseReleaseEvent(event);
        return;
    }
    if (!drag_.release()) beginEdit();
}

void NumberField::keyPressEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat()) gesture_ = drag_.pressed() ? gesture_ : newGesture();
    switch (event->key()) {
    case Qt::Key_Escape:
        if (drag_.pressed()) {
            const double before = drag_.startValue();
            drag_.release();
            edit(before, gesture_);
        } else if (editing_) {
            endEdit();
        } else {
            event->ignore();  // The viewport handles Esc.
        }
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (editing_)
            commit();
        else
            beginEdit();
        return;
    case Qt::Key_Up:
    case Qt::Key_Down: {
        if (editing_ && !commit()) return;
        edit(scale_.stepped(value_, event->key() == Qt::Key_Up ? 1 : -1, gainOf(event->modifiers())), gesture_);
        return;
    }
    default: break;
    }
    const QString typed = event->text();
    const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!editing_ && plain && !typed.isEmpty() && typed[0].isPrint()) beginEdit();
    wrong_ = false;
    if (editing_)
        QLineEdit::keyPressEvent(event);
    else
        event->ignore();
}

void NumberField::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus() || editing_ || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    edit(scale_.stepped(value_, event->angleDelta().y() > 0 ? 1 : -1, gainOf(event->modifiers())), newGesture());
    event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event)
{
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason) beginEdit();
    update();
}

void NumberField::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason) return;
    if (!commit()) endEdit();  // An invalid text leaves the value as it was.
    update();
}

void NumberField::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && palette().color(QPalette::Base).alpha() != 0) {
        QPalette clear = palette();
        clear.setColor(QPalette::Base, Qt::transparent);
        setPalette(clear);
    }
    QLineEdit::changeEvent(event);
}

void NumberField::paintEvent(QPaintEvent* event)
{
    const Theme& colors = theme();
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor fill = colors.text;
        fill.setAlphaF(editing_ ? 0.02F : underMouse() ? 0.1F : 0.055F);
        painter.setBrush(fill);
        painter.setPen(wrong_ ? QPen(colors.error) : hasFocus() ? QPen(colors.accent) : QPen(colors.outline));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
    QLineEdit::paintEvent(event);
}

}  // namespace vitrine::ui

#include "moc_number_field.cpp"
