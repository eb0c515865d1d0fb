#pragma once

#include "app/kit/picture_options.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/machine_json.h"
#include "render/gl/renderer.h"

#include <string>

namespace vitrine::app {

/// Returns the frame report of a picture as JSON text: passes of its first frame with their reasons, skipped ones with
/// theirs, counters, and the time of a frame over several runs with everything cached.
[[nodiscard]] std::string reportText(const Museum&, render::gl::Renderer&, const render::gl::ContextInfo&,
                                     const RequestedPicture&, const PictureMaker&);

using render::gl::machineJson;

}  // namespace vitrine::app
