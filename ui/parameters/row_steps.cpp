// The rows of the panel from a gamepad: one is chosen, and changed as by its arrow keys.
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/value_slider.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace vitrine::ui {
namespace {

void type(QWidget& control, int key, bool again)
{
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier, {}, again);
    QApplication::sendEvent(&control, &press);
}

}  // namespace

void ParameterPanel::stepRow(int step)
{
    const std::optional<std::size_t> now = rowAt(QApplication::focusWidget());
    const auto count = static_cast<std::ptrdiff_t>(rows_.size());
    std::ptrdiff_t next = now ? static_cast<std::ptrdiff_t>(*now) + step : 0;
    for (; next >= 0 && next<count; next += step> 0 || !now ? 1 : -1) {
        const ParameterRow& row = *rows_[static_cast<std::size_t>(next)];
        if (row.isVisible() && focusIn(row)) return;
    }
}

void ParameterPanel::nudge(int step, bool again)
{
    QWidget* control = QApplication::focusWidget();
    if (!rowAt(control)) return;
    if (qobject_cast<ValueSlider*>(control)) {
        type(*control, step > 0 ? Qt::Key_Right : Qt::Key_Left, again);
    } else if (qobject_cast<NumberField*>(control)) {
        type(*control, step > 0 ? Qt::Key_Up : Qt::Key_Down, again);
    } else if (qobject_cast<QComboBox*>(control)) {
        type(*control, step > 0 ? Qt::Key_Down : Qt::Key_Up, again);
    } else if (auto* button = qobject_cast<QAbstractButton*>(control)) {
        // A switch is on to the right; anything else that is pressed is so once.
        if (!again && (!button->isCheckable() || button->isChecked() != (step > 0))) button->click();
    }
}

}  // namespace vitrine::ui
