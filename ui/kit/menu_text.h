#pragma once

#include <QString>

namespace vitrine::ui {

/// Somebody's words, for a menu or a button, which take a single "&" as the mark of a key.
[[nodiscard]] inline QString menuText(QString words)
{
    return words.replace(u'&', QStringLiteral("&&"));
}

}  // namespace vitrine::ui
