#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/preset_values.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// {"kind": "sine", "from": 0.1, "to": 0.9, "period": 4.0, "phase": 0.25}: only what its kind goes by, values as those
/// of presets; "heldAt" where it is held.
[[nodiscard]] render::Json jsonFromMotion(const ParameterInfo&, const Motion&);

/// What is missing is as in `Motion`, both ends the row's initial value. What had to be brought into its limits, or is
/// not known, is added to `notes`. Throws Failure naming file, line and key for a row that cannot move, an unknown kind
/// or ease, a wrong type.
[[nodiscard]] Motion motionFromJson(const ParameterInfo&, const render::Json&, const JsonPlace&,
                                    std::string_view shownName, std::vector<std::string>& notes);

/// The same of JSON text that stands alone; nothing, and a note, where it is no motion of the row.
[[nodiscard]] std::optional<Motion> motionFromText(const ParameterInfo&, const std::string& json,
                                                   std::vector<std::string>& notes);

/// "sine:0.1:0.9:period=4:phase=0.25": a kind, both ends as they are typed, then what else `Motion` has by the names of
/// files, in SI; "heldAt=2" where it is held. Throws Failure (Blame::usage) that begins with `option` and says what to
/// give. `parse` reads a typed value; nothing where it is none.
[[nodiscard]] Motion typedMotion(const ParameterInfo&, const std::string& option, const std::string& text,
                                 const std::function<std::optional<Value>(const std::string&)>& parse);

/// The text that `typedMotion` reads back as the same motion, to the bit, where `format` writes a value as its `parse`
/// reads it.
[[nodiscard]] std::string motionText(const Motion&, const std::function<std::string(const Value&)>& format);

}  // namespace vitrine
