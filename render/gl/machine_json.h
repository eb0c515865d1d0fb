#pragma once

#include "render/files/strict_json.h"
#include "render/gl/context.h"

namespace vitrine::render::gl {

/// What drew and measured: renderer, vendor, version of OpenGL, whether it is software, processors.
[[nodiscard]] Json machineJson(const ContextInfo&);

}  // namespace vitrine::render::gl
