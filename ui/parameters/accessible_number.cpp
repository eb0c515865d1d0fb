#include "ui/parameters/accessible_number.h"

#include "ui/parameters/shown_text.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

AccessibleNumber accessibleNumber(const ParameterInfo& row, const SliderScale& scale, double value, double low,
                                  double high)
{
    const double shownPerStored = info(row.unit).shownPerStored;
    const bool isShown = std::isfinite(value) || row.wordFor(value) != nullptr;
    const double meant = isShown ? value : std::get<double>(row.initial);
    // A word may stand for infinity, or for a number beyond the range.
    const double now = std::isfinite(meant) ? meant : meant > 0 ? high : low;
    // At an end of the range only one direction has a step.
    const double step = std::max(std::abs(scale.stepped(now, 1) - now), std::abs(now - scale.stepped(now, -1)));
    return {now * shownPerStored, std::min(low, now) * shownPerStored, std::max(high, now) * shownPerStored,
            step * shownPerStored, shownText(row, meant)};
}

double storedNumber(const ParameterInfo& row, double spoken)
{
    return spoken / info(row.unit).shownPerStored;
}

}  // namespace vitrine::ui
