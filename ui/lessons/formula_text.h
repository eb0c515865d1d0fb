#pragma once

#include <QString>

namespace vitrine::ui {

/// Replaces the MathML formulas (`<math>…</math>`) of a page by rich text that QTextBrowser can show: italic letters,
/// sub- and superscripts, fractions in one line as "a / (b + c)". Known elements are math, mrow, mi, mn, mo, mtext,
/// mspace, mfrac, msqrt, msub, msup, msubsup, munder, mover and munderover. A formula that is not well-formed stays as
/// it is.
[[nodiscard]] QString withFormulasAsText(const QString& page);

}  // namespace vitrine::ui
