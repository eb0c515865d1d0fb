#pragma once

#include "exhibits/framework/scene/takes_input.h"
#include "exhibits/your_shader/your_shader_table.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>

// Pointer and keys in the picture of a visitor's shader. They set parameters. Places go from 0 to 1, origin at the
// lower left.
namespace vitrine::guest {

/// Returns the grip at a place: a point of the shader within `reach`, or the mouse if the shader reads it. The range of
/// a point covers the picture.
[[nodiscard]] std::optional<std::size_t> gripAt(const YourShaderTable&, const ParameterValues&, const glm::dvec2& place,
                                                const glm::dvec2& reach);

/// Returns the changes that the pointer makes at a place.
[[nodiscard]] ParameterChanges pointedAt(const YourShaderTable&, std::size_t grip, PointerEvent,
                                         const glm::dvec2& place);

/// Returns the change that a key makes at a time of the shader, in seconds.
[[nodiscard]] ParameterChanges keyedAt(const YourShaderTable&, const ParameterValues&, int code, bool isDown,
                                       double time);

/// Returns the changes that the button of an event makes at a time of the shader, in seconds: the event is pressed in
/// the next step, and if time stands still, it advances to that step. Nothing if the parameter is no event.
[[nodiscard]] std::optional<ParameterChanges> pushedAt(const YourShaderTable&, const ParameterValues&,
                                                       std::size_t parameter, double time);

}  // namespace vitrine::guest
