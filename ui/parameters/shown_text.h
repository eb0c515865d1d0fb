#pragma once

#include "exhibits/framework/parameters.h"

#include <QString>

#include <optional>

namespace vitrine::ui {

/// For a field that is not being edited: five digits and the unit, "0.35" or "12.5 mm".
[[nodiscard]] QString shownText(const ParameterInfo&, const Value&);
/// For copying and presets: every digit, in the unit shown, without it.
[[nodiscard]] QString exactText(const ParameterInfo&, const Value&);
/// The same for editing: with the decimal sign of the window's language.
[[nodiscard]] QString editedText(const ParameterInfo&, const Value&);
/// What was typed: arithmetic, units; brought to the nearest legal value. On nothing, `problem` says why.
[[nodiscard]] std::optional<Value> typedValue(const ParameterInfo&, const QString&, QString* problem = nullptr);

/// "0 to 10", in the unit shown.
[[nodiscard]] QString legalRangeText(const ParameterInfo&);
/// The values that differ from the initial ones, as the JSON text of a preset.
[[nodiscard]] QString allAsJson(const ParameterValues&, const QString& exhibit);
/// The values of such a text, of the same exhibit; nothing when it is none. `problem` says why, or what had to be
/// changed.
[[nodiscard]] std::optional<ParameterValues> allFromJson(const Parameters&, const QString& exhibit, const QString& json,
                                                         QString* problem = nullptr);
/// The whole tooltip of a row: its label, help, unit, range, initial value, key, and how to change it.
[[nodiscard]] QString tooltipText(const ParameterInfo&);

}  // namespace vitrine::ui
