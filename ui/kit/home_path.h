#pragma once

#include <QString>

namespace vitrine::ui {

/// Returns the text with the user's home folder in paths replaced by "~".
[[nodiscard]] QString withShortPaths(QString text);

}  // namespace vitrine::ui
