#pragma once

#include "exhibits/framework/table/parameters.h"

#include <QString>

#include <optional>

namespace vitrine::ui {

/// Formats a value for a field that is not being edited: four significant digits and the unit, "0.35" or "12.5 mm".
[[nodiscard]] QString shownText(const ParameterInfo&, const Value&);
/// Returns what a field of a file or text shows while it is empty.
[[nodiscard]] QString emptyText(const ParameterInfo&);
/// Formats a value with all digits, in the displayed unit, without the unit. For copying and presets.
[[nodiscard]] QString exactText(const ParameterInfo&, const Value&);
/// The same with the decimal sign of the window's language, for editing.
[[nodiscard]] QString editedText(const ParameterInfo&, const Value&);
/// Parses a typed text with arithmetic and units, and returns the nearest legal value. If the text is invalid,
/// `problem` gets a sentence why.
[[nodiscard]] std::optional<Value> typedValue(const ParameterInfo&, const QString&, QString* problem = nullptr);

/// Returns the legal range in the displayed unit: "0 to 10".
[[nodiscard]] QString legalRangeText(const ParameterInfo&);
/// Returns the values that differ from the initial ones, as the JSON text of a preset.
[[nodiscard]] QString allAsJson(const ParameterValues&, const QString& exhibit);
/// Reads the JSON text of a preset of this exhibit; nullopt if it is not one. `problem` gets why, or what was
/// corrected.
[[nodiscard]] std::optional<ParameterValues> allFromJson(const Parameters&, const QString& exhibit, const QString& json,
                                                         QString* problem = nullptr);
/// Returns the tooltip of a parameter: label, help, unit, range, initial value, key, and how to change it.
[[nodiscard]] QString tooltipText(const ParameterInfo&);

}  // namespace vitrine::ui
