#pragma once

#include "tests/support/gallery.h"

#include <string>

namespace vitrine::test {

/// Empty, or why the driver that the environment asks for (GALLIUM_DRIVER=zink) cannot be tested here; `open` opens the
/// context. On zink of Mesa 22 a segmentation fault inside lavapipe ends the program from then on with a line that
/// ctest takes for "skipped": that version has such faults in rasterizer threads of its own, Mesa 25.0 has none.
[[nodiscard]] std::string whyNotTested(Gallery& (*open)());

}  // namespace vitrine::test
