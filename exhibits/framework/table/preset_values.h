#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/files/strict_json.h"
#include "render/scene/camera.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Where in a JSON document something is read, for messages.
struct JsonPlace {
    const render::JsonDocument& document;
    std::string path;  ///< Dotted key path, as messages show it.

    /// To throw: names file, line, key path and `problem`.
    [[nodiscard]] Failure failure(const Message& problem) const;
    [[nodiscard]] JsonPlace inside(std::string_view key) const;
};

/// How a row's value is written: numbers in SI (whole ones for counts) or, outside of the range, their word, true and
/// false, the name of a choice, three numbers for colors (linear) and directions, text for files, an array of texts
/// where there may be several.
[[nodiscard]] render::Json jsonFromValue(const ParameterInfo&, const Value&);

/// The legal value nearest to the one written. What had to be changed is added to `notes`:
/// "exposure 99 -> 16 (allowed -16 to 16)". Throws Failure naming file, line and key for a wrong type, an
/// unknown choice or a direction without length.
[[nodiscard]] Value valueFromJson(const ParameterInfo&, const render::Json&, const JsonPlace&,
                                  std::string_view shownName, std::vector<std::string>& notes);

/// The same of JSON text that stands alone; nothing, and a note, where it is no value of the row.
[[nodiscard]] std::optional<Value> valueFromText(const ParameterInfo&, const std::string& json,
                                                 std::vector<std::string>& notes);

/// {"eye": [x, y, z], "target": [x, y, z], "fov": radians, "lensShift": [right, up]}. Other keys of `kept` stay.
[[nodiscard]] render::Json jsonFromCamera(const render::Camera&, const render::Json& kept);

/// Throws Failure as `valueFromJson` does; a missing key keeps the camera's own value.
[[nodiscard]] render::Camera cameraFromJson(const render::Json&, const JsonPlace&, std::vector<std::string>& notes);

}  // namespace vitrine
