#pragma once

#include "exhibits/museum/museum.h"
#include "render/plan/render_backend.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::stability {

/// One picture of the scan: an exhibit with random settings, at an extreme time, position and size.
struct ScanCase {
    std::size_t exhibit = 0;  ///< Index in Museum::subjects(); `hallIndex` is the hall itself.
    SceneState sceneState;    ///< Random values of the exhibit and, sometimes, of the hall.
    FrameRequest frame;
};

/// Returns the case of a seed, the same on every machine. In half of the cases all settings are random, in the others
/// half of them. Other conditions vary sometimes. The camera is inside the bounds, on their face, 100 km away, straight
/// above, or anywhere. The exhibit is 100 km from the origin, mirrored, scaled by 1000 or 0.001, or rotated and
/// stretched. Times include 1e9 s, 1e300 s, negative ones and NaN. Sizes begin at 1 × 1.
[[nodiscard]] ScanCase scanCase(const Museum&, std::size_t exhibit, std::uint64_t seed);

/// Draws the case over poison and examines all its images. Returns the first fault, or an empty text. Faults are NaN or
/// infinity (also of an unwritten texel), negative light, a depth outside [0, 1], a normal that is neither 0 nor of
/// unit length, and exceptions of the backend.
[[nodiscard]] std::string faultOf(const Museum&, render::RenderBackend&, const ScanCase&);

/// Returns the causes of the fault, as "roughness 0.98" or "time 1e+09 s": every random setting that cannot be reset
/// without losing the fault. Draws as many pictures as there are settings.
[[nodiscard]] std::vector<std::string> causesOf(const Museum&, render::RenderBackend&, ScanCase);

}  // namespace vitrine::stability
