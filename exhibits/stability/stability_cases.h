#pragma once

#include "exhibits/museum/museum.h"
#include "render/plan/render_backend.h"

#include <functional>
#include <string>
#include <vector>

namespace vitrine::stability {

/// One line of the table that `vitrine doctor --stability` prints.
struct StabilityResult {
    std::string number;   ///< Number of the hard case, as in tests/stability/README.md; empty if it has none.
    std::string what;     ///< "A smooth union of width zero".
    bool passed = false;  ///< Always true if `tried` is false.
    double value = 0;     ///< Measured value: the largest error, or the number of faults.
    double limit = 0;     ///< The case passes if `value` is not above it.
    std::string detail;   ///< Place of the value, and result of plain code on this driver.
    bool tried = true;    ///< False: nothing was drawn for it, because `StabilityProgress` ended it before.
};

/// Progress of a group of cases, called before each step with the part that is done, 0 to below 1. The cases end early
/// if it returns false. Empty: they run to the end.
using StabilityProgress = std::function<bool(double part)>;

/// Compares the shader library on the backend's GPU with itself at float64: at inputs that break plain code, and at
/// points all over space. Draws two pictures.
[[nodiscard]] std::vector<StabilityResult> arithmeticCases(render::RenderBackend&);

/// Tests properties of pictures that hold on any driver. A picture is bitwise equal when drawn twice, with every pass
/// run, and over any garbage in memory. In tiles it is equal within half a level. A mean of thousands is right within
/// 1e-6. Draws about eight small pictures of every exhibit.
/// If `progress` ends a case early, its `detail` says how many exhibits it tried.
[[nodiscard]] std::vector<StabilityResult> pictureCases(const Museum&, render::RenderBackend&,
                                                        const StabilityProgress& progress = {});

/// Scans one exhibit (see stability_scan.h) with up to `count` seeds from `first` on. `value` is the number of faulty
/// pictures; `detail` is the first fault with its seed and causes; `what` says how many pictures were drawn. Stops at
/// the third fault, or when `progress` returns false.
[[nodiscard]] StabilityResult scanExhibit(const Museum&, render::RenderBackend&, std::size_t exhibit,
                                          std::uint64_t first, int count, const StabilityProgress& progress = {});

}  // namespace vitrine::stability
