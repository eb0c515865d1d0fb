#include "exhibits/printing/print_numbers.h"

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {

PrintNumbers numbersOf(const PrintLayout& layout, double storedDpi)
{
    const PrintSettings& s = layout.settings();
    PrintNumbers numbers;
    numbers.pixelsPerLens = layout.pixelsPerLens();
    numbers.effectiveLpi = layout.printLpi() * storedDpi / s.dpiX;
    numbers.effectiveViews = std::min<double>(s.views, layout.wholePixelsPerLens());
    numbers.zoneDegrees = zoneByAperture(s.sheet) / radiansPerDegree;
    numbers.depthBudget = 2 * numbers.effectiveViews * s.sheet.thickness / s.sheet.index;
    const ViewMatrix mixing = viewMixing(layout);
    for (int k = 0; k < s.views; ++k) numbers.ownShare.push_back(std::min(mixing.at(k, k), 1.0));
    return numbers;
}

std::vector<std::string> warningsOf(const PrintLayout& layout)
{
    std::vector<std::string> warnings;
    const PrintSettings& s = layout.settings();
    const double perLens = layout.pixelsPerLens();
    if (layout.wholePixelsPerLens() < 2) {
        warnings.push_back("With " + shortText(perLens) + " pixels per lens the printer cannot separate views.");
    } else if (s.views > layout.wholePixelsPerLens()) {
        warnings.push_back(std::to_string(s.views) + " views share " + shortText(perLens) +
                           " pixels per lens: no more than " + shortText(layout.wholePixelsPerLens()) +
                           " of them can be told apart.");
    }
    if (s.views == 1) warnings.push_back("With one view the print shows the same picture from everywhere.");
    if (s.visualLpi > 0 && std::abs(s.visualLpi / s.sheet.lpi() - 1) > 0.02) {
        warnings.push_back("The visual LPI " + shortText(s.visualLpi) + " is far from the sheet's " +
                           shortText(s.sheet.lpi()) + ".");
    }
    return warnings;
}

}  // namespace vitrine::printing
