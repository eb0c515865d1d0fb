#pragma once

#include "app/kit/picture_options.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/machine_json.h"
#include "render/gl/renderer.h"

#include <functional>

namespace vitrine::app {

/// Returns the frame report of a picture as JSON: passes of its first frame (`first`) with their reasons, skipped ones
/// with theirs, counters, and the time of a frame over several runs with everything cached. Calls `between` before each
/// frame that it draws; what that throws stops it.
[[nodiscard]] render::Json pictureReport(
    const Museum&, render::gl::Renderer&, const render::gl::ContextInfo&, const RequestedPicture&,
    const render::FrameReport& first, const std::function<void()>& between = [] {});

using render::gl::machineJson;

}  // namespace vitrine::app
