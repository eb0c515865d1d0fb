#pragma once

#include "exhibits/museum/museum.h"
#include "render/plan/render_backend.h"

#include <functional>
#include <string>
#include <vector>

namespace vitrine {

/// One line of the table that `vitrine doctor --stability` prints.
struct StabilityResult {
    std::string number;  ///< Of the hard case, as in tests/stability/README.md; empty for what has none.
    std::string what;    ///< "A smooth union of width zero".
    bool passed = false;
    double value = 0;    ///< What was measured: the largest error, or how many of the things that may not be.
    double limit = 0;    ///< Passed where `value` is not above it.
    std::string detail;  ///< For people: where the value was found, what plain code gives on this driver.
};

/// The shader library on the painter's GPU against itself at float64: at the inputs that break plain code, and at
/// points all over space. Two pictures are drawn.
[[nodiscard]] std::vector<StabilityResult> arithmeticCases(render::RenderBackend&);

/// Promises about pictures that any driver must keep: the same twice, with everything run and over any garbage in
/// memory, to the bit; by tiles, to half a level; a mean of thousands. Some eight small pictures of every exhibit.
[[nodiscard]] std::vector<StabilityResult> pictureCases(const Museum&, render::RenderBackend&);

/// The scan of one exhibit (see stability_scan.h) with `count` seeds from `first` on: `value` is how many pictures
/// had a fault, `detail` the first of them with its seed and what it takes to bring it about. Stops at the third.
/// `progress` (may be empty) is told after each picture how many were drawn.
[[nodiscard]] StabilityResult scanExhibit(const Museum&, render::RenderBackend&, std::size_t exhibit,
                                          std::uint64_t first, int count,
                                          const std::function<void(int)>& progress = {});

}  // namespace vitrine
