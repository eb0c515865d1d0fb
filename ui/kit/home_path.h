#pragma once

#include <QString>

namespace vitrine::ui {

/// The text with paths below the user's home folder as "~/…", as people say them.
[[nodiscard]] QString withShortPaths(QString text);

}  // namespace vitrine::ui
