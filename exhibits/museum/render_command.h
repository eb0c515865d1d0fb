#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

namespace vitrine {

/// Returns the options of a command line that set the scene: time, seed, camera, and all values and motions that differ
/// from the initial ones.
[[nodiscard]] std::vector<std::string> sceneWords(const Museum&, const SceneState&, const FrameRequest&,
                                                  bool withCamera = true);

/// Returns the command line that draws the same picture of the hall, bit by bit: `vitrine render hall` with all values
/// that differ from the initial ones, quoted for a POSIX shell. Uses camera, size, time and seed of the request.
[[nodiscard]] std::string renderCommand(const Museum&, const SceneState&, const FrameRequest&, int samples,
                                        const std::string& out);

}  // namespace vitrine
