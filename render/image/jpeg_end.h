#pragma once

#include <string_view>

namespace vitrine::render {

/// Whether the bytes of a JPEG file go on to its end-of-image marker (ITU-T T.81, B.1 and B.2): libjpeg fills up a
/// file that was cut short with gray and calls that a warning. Bytes behind the marker do not matter.
[[nodiscard]] bool jpegIsWhole(std::string_view bytes);

}  // namespace vitrine::render
