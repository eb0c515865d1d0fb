#pragma once

#include "render/image/stored_picture.h"

#include <string_view>

namespace vitrine::render {

/// The value of the tag Orientation (CIPA DC-008, "Exif 3.0", 4.6.5.1.6) in an Exif block, which is a TIFF header with
/// its directory: 1 to 8. Returns 1, "as stored", where the block is broken or lacks the tag.
[[nodiscard]] int exifOrientation(std::string_view block);

/// The same number for the resolution line of a Radiance HDR file (Ward, "Real Pixels", Graphics Gems II, 1991): the
/// first axis counts the stored rows, and y points upward. Returns 1 where there is no such line.
[[nodiscard]] int hdrOrientation(std::string_view file);

/// Reorders the samples of a picture so that row 0 is the visible top and column 0 the visible left. 5 to 8 exchange
/// width and height. `orientation` is 1 to 8.
void orient(StoredPicture&, int orientation);

}  // namespace vitrine::render
