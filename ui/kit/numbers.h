#pragma once

#include <QLocale>
#include <QString>

namespace vitrine::ui {

/// Returns the locale of shown numbers: the decimal sign of the window's language, no group separators.
[[nodiscard]] QLocale numberLocale();
/// Converts a number with a decimal point, as files have it, to the decimal sign of the window's language.
[[nodiscard]] QString withDecimalSign(const QString& number);
/// Converts a typed number to one with a decimal point. A comma counts as a decimal point if the window's or the
/// desktop's language has a decimal comma. A number that has a point is returned unchanged.
[[nodiscard]] QString withPoint(const QString& typed);

}  // namespace vitrine::ui
