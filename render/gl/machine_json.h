#pragma once

#include "render/files/strict_json.h"
#include "render/gl/context.h"

namespace vitrine::render::gl {

/// Describes the machine that drew and measured: renderer, vendor, OpenGL version, software or not, number of
/// processors.
[[nodiscard]] Json machineJson(const ContextInfo&);

}  // namespace vitrine::render::gl
