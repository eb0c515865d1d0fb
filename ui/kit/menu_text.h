#pragma once

#include <QAction>
#include <QString>

namespace vitrine::ui {

/// Somebody's words, for a menu or a button, which take a single "&" as the mark of a key.
[[nodiscard]] inline QString menuText(QString words)
{
    return words.replace(u'&', QStringLiteral("&&"));
}

/// What an action does and its first shortcut, for the tooltip of a button that does it.
[[nodiscard]] inline QString tipWithKey(const QAction& action)
{
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? action.toolTip() : QStringLiteral("%1 (%2)").arg(action.toolTip(), key);
}

}  // namespace vitrine::ui
