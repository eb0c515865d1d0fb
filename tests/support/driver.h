#pragma once

#include "tests/support/gallery.h"

#include <string>

namespace vitrine::test {

/// Returns why the driver that the environment selects (GALLIUM_DRIVER=zink) cannot be tested here; empty if it can.
/// `open` opens the context. On zink of Mesa 22, a later segmentation fault inside lavapipe ends the program with a
/// line that ctest takes for "skipped". That version has such faults in its own rasterizer threads; Mesa 25.0 has none.
[[nodiscard]] std::string whyNotTested(Gallery& (*open)());

}  // namespace vitrine::test
