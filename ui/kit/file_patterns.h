#pragma once

#include "ui/kit/text.h"

#include <QStringList>

#include <string_view>

namespace vitrine::ui {

/// Patterns of a file dialog for extensions as `ParameterInfo::extensions` has them: "*.glb *.gltf".
[[nodiscard]] inline QString filePatterns(std::string_view endings)
{
    QStringList patterns;
    for (const QString& ending : text(endings).split(QLatin1Char(' '), Qt::SkipEmptyParts))
        patterns << QStringLiteral("*.") + ending;
    return patterns.join(QLatin1Char(' '));
}

}  // namespace vitrine::ui
