#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/files/strict_json.h"
#include "render/scene/camera.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Location in a JSON document, for messages.
struct JsonPlace {
    const render::JsonDocument& document;
    std::string path;  ///< Dotted key path, as messages show it.

    /// Returns a Failure, to be thrown, that names file, line, key path and `problem`.
    [[nodiscard]] Failure failure(const Message& problem) const;
    [[nodiscard]] JsonPlace inside(std::string_view key) const;
};

/// Returns a value as JSON: a number in SI units (a whole one for counts), the word of a number outside of the range,
/// true or false, the name of a choice, three numbers for colors (linear) and directions, a text for files, an array of
/// texts for a parameter with several.
[[nodiscard]] render::Json jsonFromValue(const ParameterInfo&, const Value&);

/// Reads a value and returns the nearest legal one. If that differs, a note is added to `notes`: "exposure 99 -> 16
/// (allowed -16 to 16)". Throws Failure naming file, line and key for a wrong type, an unknown choice or a direction
/// without length.
[[nodiscard]] Value valueFromJson(const ParameterInfo&, const render::Json&, const JsonPlace&,
                                  std::string_view shownName, std::vector<std::string>& notes);

/// The same for JSON text outside of a document. If it is not a value of the parameter, returns nothing and adds a
/// note.
[[nodiscard]] std::optional<Value> valueFromText(const ParameterInfo&, const std::string& json,
                                                 std::vector<std::string>& notes);

/// Returns {"eye": [x, y, z], "target": [x, y, z], "fov": radians, "lensShift": [right, up]}, together with all other
/// keys of `kept`.
[[nodiscard]] render::Json jsonFromCamera(const render::Camera&, const render::Json& kept);

/// Reads a camera. A missing key leaves that value of the camera unchanged. Throws Failure like `valueFromJson`.
[[nodiscard]] render::Camera cameraFromJson(const render::Json&, const JsonPlace&, std::vector<std::string>& notes);

}  // namespace vitrine
