#pragma once

#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_row.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabBar>

namespace vitrine::test {

/// Returns the size that a control needs for its text. If it elides the text by design, only the height counts.
inline QSize neededSize(const QWidget& widget)
{
    const int line = widget.fontMetrics().height();
    const bool mayElide = widget.sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->text().isEmpty()) return {0, 0};
        if (const auto* name = qobject_cast<const ui::RowLabel*>(label)) return {0, name->heightFor(name->width())};
        if (label->wordWrap()) return {0, label->heightForWidth(label->width())};
        return {mayElide ? 0 : label->sizeHint().width(), label->sizeHint().height()};
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        if (button->text().isEmpty()) return {0, 0};
        const int words = widget.fontMetrics().size(Qt::TextShowMnemonic, button->text()).width();
        return {mayElide ? 0 : words, line};
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        const bool whole = box->sizeAdjustPolicy() != QComboBox::AdjustToMinimumContentsLengthWithIcon;
        return {whole ? widget.fontMetrics().horizontalAdvance(box->currentText()) : 0, line};
    }
    if (const auto* field = qobject_cast<const ui::NumberField*>(&widget))
        return {widget.fontMetrics().horizontalAdvance(field->text()), line};
    if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget))
        return {widget.fontMetrics().horizontalAdvance(spin->text()), line};
    if (qobject_cast<const QLineEdit*>(&widget)) return {0, line};
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return {0, tabs->count() > 0 ? line : 0};
    return {0, 0};
}

/// Returns whether the widget is in an area that can be scrolled.
inline bool scrolls(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return parent && parent->parentWidget() && qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
}

/// Returns whether the widget is in a panel behind others of its stack, or in the tab bar of a stack that does not
/// exist. Qt keeps those beyond the window's edge.
inline bool isStackedBehind(const QWidget& widget)
{
    for (const QWidget* part = &widget; part->parentWidget(); part = part->parentWidget())
        if (qobject_cast<const QMainWindow*>(part->parentWidget()) && !part->isWindow())
            return !part->parentWidget()->rect().intersects(part->geometry());
    return false;
}

/// Returns the visible labels, buttons and fields below `root` that are cut off: smaller than their text, or beyond the
/// edge of their parent. One line each.
inline QStringList cutOff(const QWidget& root)
{
    QStringList all;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != root.window() || isStackedBehind(*widget)) continue;
        if (const auto* area = qobject_cast<const QScrollArea*>(widget);
            area && area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
            area->widget()->width() > area->viewport()->width())
            all << QString("%1 is %2 wide in a view of %3 that does not scroll across")
                       .arg(area->widget()->metaObject()->className())
                       .arg(area->widget()->width())
                       .arg(area->viewport()->width());
        const QSize needed = neededSize(*widget);
        if (needed.isNull()) continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const QString what =
            QString("%1 “%2”").arg(widget->metaObject()->className(), label    ? label->text().left(40)
                                                                      : button ? button->text()
                                                                               : widget->accessibleName());
        if (const auto* name = qobject_cast<const ui::RowLabel*>(widget); name && !name->isWhole())
            all << QString("%1 is elided at %2 x %3").arg(what).arg(name->width()).arg(name->height());
        if (widget->width() < needed.width() || widget->height() < needed.height())
            all << QString("%1 has %2 x %3 and needs %4 x %5")
                       .arg(what)
                       .arg(widget->width())
                       .arg(widget->height())
                       .arg(needed.width())
                       .arg(needed.height());
        for (const QWidget* part = widget;
             part != &root && part->parentWidget() && !part->isWindow() && !scrolls(*part); part = part->parentWidget())
            if (!part->parentWidget()->rect().contains(part->geometry()) &&
                !qobject_cast<const QAbstractScrollArea*>(part->parentWidget())) {
                all << QString("%1 is beyond the edge").arg(what);
                break;
            }
    }
    return all;
}

}  // namespace vitrine::test
