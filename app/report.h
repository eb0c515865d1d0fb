#pragma once

#include "app/picture_options.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/machine_json.h"
#include "render/gl/renderer.h"

#include <string>

namespace vitrine::app {

/// The frame report of a picture as JSON text: what ran in its first frame and why, what was skipped and why, counters,
/// and the time of a frame over several runs with everything kept already in place.
[[nodiscard]] std::string reportText(const Museum&, render::gl::Renderer&, const render::gl::ContextInfo&,
                                     const RequestedPicture&, const PictureMaker&);

using render::gl::machineJson;

}  // namespace vitrine::app
