#pragma once

#include "exhibits/museum/museum.h"

#include <string>

namespace vitrine {

/// The command line that draws this picture of the hall again, to the bit: `vitrine render hall` with all that differs
/// from the initial values, quoted for a POSIX shell. Of the request, camera, size, time and seed count.
[[nodiscard]] std::string renderCommand(const Museum&, const SceneState&, const FrameRequest&, int samples,
                                        const std::string& out);

}  // namespace vitrine
