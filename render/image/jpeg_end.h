#pragma once

#include <string_view>

namespace vitrine::render {

/// Returns whether the bytes of a JPEG file reach its end-of-image marker (ITU-T T.81, B.1 and B.2). libjpeg fills a
/// truncated file with gray and only warns. Bytes after the marker are ignored.
[[nodiscard]] bool jpegIsWhole(std::string_view bytes);

}  // namespace vitrine::render
