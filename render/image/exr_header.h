#pragma once

#include "render/image/image_limits.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Reads the header of an OpenEXR file (openexr.com, "OpenEXR File Layout") without OpenEXR, which takes the memory
/// that a header claims before anything can be checked. Returns why the file is refused, as a half sentence: an
/// attribute, a size or a table of chunks that the file cannot hold, or subsampled channels. Empty: OpenEXR may open
/// it.
[[nodiscard]] std::string whyExrRefused(std::string_view bytes, const ImageLimits&);

}  // namespace vitrine::render
