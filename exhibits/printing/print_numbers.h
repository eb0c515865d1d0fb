#pragma once

#include "exhibits/printing/print_layout.h"

#include <string>
#include <vector>

namespace vitrine::printing {

/// Properties of a print that matter to printers and viewers.
struct PrintNumbers {
    double pixelsPerLens = 0;
    double effectiveLpi = 0;       ///< Lenses per inch of the strips, with the dpi stored in the file.
    double effectiveViews = 0;     ///< At most the pixels per lens.
    double zoneDegrees = 0;        ///< Exact zone, by the mean over the lens.
    double depthBudget = 0;        ///< Total depth before and behind the print without doubled contours, millimeters.
    std::vector<double> ownShare;  ///< Share of each view at its own angle; the rest is cross-talk.
};
/// Returns the numbers. `storedDpi` is the resolution along the row as stored in the file.
[[nodiscard]] PrintNumbers numbersOf(const PrintLayout&, double storedDpi);

/// Returns full sentences on expected defects.
[[nodiscard]] std::vector<std::string> warningsOf(const PrintLayout&);

}  // namespace vitrine::printing
