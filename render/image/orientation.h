#pragma once

#include "render/image/stored_picture.h"

#include <string_view>

namespace vitrine::render {

/// Returns the value of the Exif tag Orientation (CIPA DC-008, "Exif 3.0", 4.6.5.1.6), 1 to 8. `block` is a TIFF header
/// with its directory. Returns 1, "as stored", if the block is broken or lacks the tag.
[[nodiscard]] int exifOrientation(std::string_view block);

/// Returns the equivalent number for the resolution line of a Radiance HDR file (Ward, "Real Pixels", Graphics Gems II,
/// 1991). In that line, the first axis counts the stored rows, and y points upward. Returns 1 if there is no such line.
[[nodiscard]] int hdrOrientation(std::string_view file);

/// Reorders the samples of a picture so that row 0 is the visible top and column 0 the visible left. `orientation` is 1
/// to 8; 5 to 8 exchange width and height.
void orient(StoredPicture&, int orientation);

}  // namespace vitrine::render
