#pragma once

#include <QAccessible>
#include <QAccessibleWidget>
#include <QLineEdit>
#include <QStringList>
#include <QWidget>

#include <cmath>

namespace vitrine::test {

/// Returns whether a screen reader must be able to name this part: it takes the focus, or can be pressed, chosen or
/// set.
[[nodiscard]] inline bool needsName(const QAccessibleInterface& part)
{
    switch (part.role()) {
    case QAccessible::Button:
    case QAccessible::ButtonMenu:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::ComboBox:
    case QAccessible::EditableText:
    case QAccessible::SpinBox:
    case QAccessible::Slider:
    case QAccessible::Dial:
    case QAccessible::PageTab:
    case QAccessible::MenuItem:
    case QAccessible::ListItem:
    case QAccessible::List:
    case QAccessible::Tree:
    case QAccessible::Table:
    case QAccessible::Chart:
    case QAccessible::Graphic:
    case QAccessible::Animation:
    case QAccessible::ColorChooser:
    case QAccessible::ProgressBar:
    case QAccessible::Dialog:
    case QAccessible::Notification:
    case QAccessible::AlertMessage: return true;
    case QAccessible::StaticText:  // Parts without text need no name,
    case QAccessible::Cell:
    case QAccessible::TreeItem: return false;  // such as an empty cell.
    default: return part.state().focusable;
    }
}

/// Collects what a screen reader could not say about this part and all visible parts in it, a line each.
inline void complain(QAccessibleInterface* part, const QString& where, QStringList& complaints)
{
    if (!part || !part->isValid() || part->state().invisible) return;
    const auto* widget = qobject_cast<const QWidget*>(part->object());
    const bool ofQt =
        widget && (widget->objectName().startsWith(QLatin1String("qt_")) || widget->inherits("QScrollArea") ||
                   widget->inherits("QSplitter") || qobject_cast<const QLineEdit*>(widget->parentWidget()));
    const QString kind = part->object() ? QString::fromLatin1(part->object()->metaObject()->className())
                                        : QString::number(part->role(), 16);
    const QString name = part->text(QAccessible::Name);
    const QString here = where + QLatin1Char('/') + (name.isEmpty() ? kind : name);
    if (!ofQt && needsName(*part)) {
        if (name.trimmed().isEmpty()) complaints << here + QLatin1String(": no name");
        if (widget && part->state().focusable && part->role() == QAccessible::Client)
            complaints << here + QLatin1String(": no role, it is a ") + kind;
    }
    const bool sets = part->role() == QAccessible::Slider || part->role() == QAccessible::SpinBox;
    if (auto* value = part->valueInterface()) {
        const double now = value->currentValue().toDouble(), least = value->minimumValue().toDouble(),
                     most = value->maximumValue().toDouble();
        if (!(least <= now && now <= most && least < most) && part->role() != QAccessible::ScrollBar &&
            part->role() != QAccessible::ProgressBar)
            complaints << here + QStringLiteral(": %1 is not within %2 to %3").arg(now).arg(least).arg(most);
        if (sets && !(value->minimumStepSize().toDouble() > 0)) complaints << here + QLatin1String(": no step");
    } else if (sets) {
        complaints << here + QLatin1String(": no value");
    }
    for (int i = 0; i < part->childCount(); ++i) complain(part->child(i), here, complaints);
}

[[nodiscard]] inline QStringList complaintsOf(QWidget& root)
{
    QStringList complaints;
    complain(QAccessible::queryAccessibleInterface(&root), {}, complaints);
    return complaints;
}

}  // namespace vitrine::test
