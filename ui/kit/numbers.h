#pragma once

#include <QLocale>
#include <QString>

namespace vitrine::ui {

/// How numbers are shown: with the decimal sign of the language that the window speaks, without group separators.
[[nodiscard]] QLocale numberLocale();
/// A number that is written with a point, as files have it, with the decimal sign of the window's language.
[[nodiscard]] QString withDecimalSign(const QString& number);
/// A typed number with a point for the decimal comma of the window's or the desktop's language: a number has no other
/// comma. One with a point already is left as it is.
[[nodiscard]] QString withPoint(const QString& typed);

}  // namespace vitrine::ui
