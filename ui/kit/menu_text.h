#pragma once

#include <QAction>
#include <QString>

namespace vitrine::ui {

/// Escapes user text for menus and buttons, which take a single "&" as the mark of a shortcut key.
[[nodiscard]] inline QString menuText(QString words)
{
    return words.replace(u'&', QStringLiteral("&&"));
}

/// Returns the name of a command without the marks of menus: "Export picture" for "Export &picture…".
[[nodiscard]] inline QString nameText(const QAction& action)
{
    return action.text().remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

/// Returns all shortcuts of a command.
[[nodiscard]] inline QString keysText(const QAction& action)
{
    return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText).replace(u';', u',');
}

/// Returns a button's tooltip: the action's tooltip, with its first shortcut in brackets.
[[nodiscard]] inline QString tipWithKey(const QAction& action)
{
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? action.toolTip() : QStringLiteral("%1 (%2)").arg(action.toolTip(), key);
}

}  // namespace vitrine::ui
