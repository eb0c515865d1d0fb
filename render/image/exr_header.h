#pragma once

#include "render/image/image_limits.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Checks the header of an OpenEXR file (openexr.com, "OpenEXR File Layout") without the OpenEXR library, which
/// allocates what a header claims before it can be checked. Returns a half sentence that says why the file is refused:
/// an attribute, a size or a chunk table that the file cannot hold, or subsampled channels. Empty: OpenEXR may open it.
[[nodiscard]] std::string whyExrRefused(std::string_view bytes, const ImageLimits&);

}  // namespace vitrine::render
