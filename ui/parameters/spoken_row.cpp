#include "ui/parameters/spoken_row.h"

#include "ui/parameters/shown_text.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

SpokenNumber spokenNumber(const ParameterInfo& row, const SliderScale& scale, double value, double low, double high)
{
    const double shownPerStored = info(row.unit).shownPerStored;
    const double now = std::isfinite(value) ? value : std::get<double>(row.initial);
    // At an end of the range only one direction has a step.
    const double step = std::max(std::abs(scale.stepped(now, 1) - now), std::abs(now - scale.stepped(now, -1)));
    return {now * shownPerStored, low * shownPerStored, high * shownPerStored, step * shownPerStored,
            shownText(row, now)};
}

double storedNumber(const ParameterInfo& row, double spoken)
{
    return spoken / info(row.unit).shownPerStored;
}

}  // namespace vitrine::ui
