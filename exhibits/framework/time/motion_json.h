#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/preset_values.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Returns for example {"kind": "sine", "from": 0.1, "to": 0.9, "period": 4.0, "phase": 0.25}: only the members that
/// its kind uses, values as in presets; "heldAt" if it is held.
[[nodiscard]] render::Json jsonFromMotion(const ParameterInfo&, const Motion&);

/// Parses an animation. Missing members are as in `Motion`, both ends the parameter's initial value. Members that were
/// clamped or are unknown are added to `notes`. Throws Failure naming file, line and key for a parameter that cannot be
/// animated, an unknown kind or ease, or a wrong type.
[[nodiscard]] Motion motionFromJson(const ParameterInfo&, const render::Json&, const JsonPlace&,
                                    std::string_view shownName, std::vector<std::string>& notes);

/// The same for separate JSON text; returns nothing, and adds a note, if it is no animation of the parameter.
[[nodiscard]] std::optional<Motion> motionFromText(const ParameterInfo&, const std::string& json,
                                                   std::vector<std::string>& notes);

/// Parses "sine:0.1:0.9:period=4:phase=0.25": a kind, both ends as a user types them, then further members of `Motion`
/// by their names in files, in SI; "heldAt=2" if it is held. Throws Failure (ErrorKind::usage) that begins with
/// `option` and says what to give. `parse` reads a typed value; nothing if it is invalid.
[[nodiscard]] Motion typedMotion(const ParameterInfo&, const std::string& option, const std::string& text,
                                 const std::function<std::optional<Value>(const std::string&)>& parse);

/// Returns the text that `typedMotion` reads back as the same animation, bit by bit, if `format` writes values as its
/// `parse` reads them.
[[nodiscard]] std::string motionText(const Motion&, const std::function<std::string(const Value&)>& format);

}  // namespace vitrine
