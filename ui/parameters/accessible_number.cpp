#include "ui/parameters/accessible_number.h"

#include "ui/parameters/shown_text.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

AccessibleNumber accessibleNumber(const ParameterInfo& parameter, const SliderScale& scale, double value, double low,
                                  double high)
{
    const double shownPerStored = info(parameter.unit).shownPerStored;
    const bool isShown = std::isfinite(value) || parameter.wordFor(value) != nullptr;
    const double meant = isShown ? value : std::get<double>(parameter.initial);
    // A word may stand for infinity, or for a number beyond the range.
    const double now = std::isfinite(meant) ? meant : meant > 0 ? high : low;
    // At an end of the range only one direction has a step.
    const double step = std::max(std::abs(scale.stepped(now, 1) - now), std::abs(now - scale.stepped(now, -1)));
    return {now * shownPerStored, std::min(low, now) * shownPerStored, std::max(high, now) * shownPerStored,
            step * shownPerStored, shownText(parameter, meant)};
}

double storedNumber(const ParameterInfo& parameter, double spoken)
{
    return spoken / info(parameter.unit).shownPerStored;
}

}  // namespace vitrine::ui
