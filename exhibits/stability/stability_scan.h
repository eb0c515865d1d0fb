#pragma once

#include "exhibits/museum/museum.h"
#include "render/plan/render_backend.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine {

/// One picture of the scan: an exhibit with random settings, at a hostile time, place and size.
struct ScanCase {
    std::size_t exhibit = 0;  ///< In Museum::subjects(): `hallIndex` is the hall itself.
    SceneState sceneState;    ///< Random values of the exhibit and, now and then, of the hall.
    FrameRequest frame;
};

/// The case that `seed` draws: the same on every machine. Half of the settings are random, and everything else is
/// now and then: the camera inside the bounds, on their face, 100 km away or straight above; the exhibit 100 km from
/// the origin, mirrored or a thousand times larger; times of 0, 1e6 s, 1e9 s and none; pictures from 1 × 1 up.
[[nodiscard]] ScanCase scanCase(const Museum&, std::size_t exhibit, std::uint64_t seed);

/// Draws the case over poison and looks at all its images. Empty, or the first fault: NaN or infinity (of a texel
/// that nobody wrote, too), negative light, a depth outside [0, 1], a normal that is neither 0 nor of unit length,
/// or what the painter threw.
[[nodiscard]] std::string faultOf(const Museum&, render::RenderBackend&, const ScanCase&);

/// What it takes to bring the fault about: everything random that cannot be set back to its plain value without the
/// fault vanishing, as "roughness 0.98" or "time 1e+09 s". Draws as many pictures as there are settings.
[[nodiscard]] std::vector<std::string> causesOf(const Museum&, render::RenderBackend&, ScanCase);

}  // namespace vitrine
