#include "ui/kit/home_path.h"

#include <QDir>

namespace vitrine::ui {

QString withShortPaths(QString text)
{
    const QString home = QDir::homePath();
    if (home == QDir::rootPath()) return text;
    const QString inside = home + QLatin1Char('/');
    for (qsizetype at = text.indexOf(inside); at >= 0; at = text.indexOf(inside, at + 1)) {
        // "/home/ann" must not match in "/disk/home/ann".
        const QChar before = at > 0 ? text[at - 1] : QLatin1Char(' ');
        if (before.isLetterOrNumber() || QStringLiteral("/._-~").contains(before)) continue;
        text.replace(at, home.size(), QLatin1Char('~'));
    }
    return text;
}

}  // namespace vitrine::ui
