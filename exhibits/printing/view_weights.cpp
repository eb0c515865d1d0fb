#include "exhibits/printing/view_weights.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

/// Shares below this are rounding errors.
constexpr double least = 1e-13;

std::int64_t lensOfStrip(std::int64_t strip, std::int64_t views)
{
    return strip >= 0 ? strip / views : -((-strip + views - 1) / views);
}

}  // namespace

double shareBefore(double t, double a, double b)
{
    const double outer = (a + b) / 2;
    if (t <= -outer) return 0;
    if (t >= outer) return 1;
    const double inner = std::abs(a - b) / 2;
    if (t < -inner) return (t + outer) * (t + outer) / (2 * a * b);
    if (t > inner) return 1 - (outer - t) * (outer - t) / (2 * a * b);
    return 0.5 + t / std::max(a, b);
}

void viewWeightsAt(const PrintLayout& layout, double x, double y, std::vector<ViewWeight>& taps)
{
    taps.clear();
    const PrintSettings& settings = layout.settings();
    const std::int64_t views = settings.views;
    const double u = layout.lensAt(x, y);
    if (settings.method == Method::nearest) {
        const double lens = std::floor(u);
        const auto j = static_cast<std::int64_t>(lens);
        // The product can round up to the number of views.
        const std::int64_t s = std::min(views - 1, static_cast<std::int64_t>((u - lens) * static_cast<double>(views)));
        taps.push_back({j, layout.viewOfStrip(j * views + s), 1});
        return;
    }
    const double center = u * static_cast<double>(views);
    const double a = std::abs(layout.lensesPerPixelX()) * static_cast<double>(views);
    const double b = std::abs(layout.lensesPerPixelY()) * static_cast<double>(views);
    const double half = settings.method == Method::guard ? settings.guard / 2 : 0;
    const double reach = (a + b) / 2 + half;
    const auto first = static_cast<std::int64_t>(std::floor(center - reach));
    const auto last = static_cast<std::int64_t>(std::ceil(center + reach));
    for (std::int64_t strip = first; strip < last; ++strip) {
        const double from = static_cast<double>(strip) - center;
        const double to = from + 1;
        // With a guard, the core of a strip counts fully, and the two edges that it shares count half.
        const double wide = shareBefore(to + half, a, b) - shareBefore(from - half, a, b);
        const double narrow = half > 0 ? shareBefore(to - half, a, b) - shareBefore(from + half, a, b) : wide;
        const double weight = (wide + narrow) / 2;
        if (weight > least) taps.push_back({lensOfStrip(strip, views), layout.viewOfStrip(strip), weight});
    }
}

}  // namespace vitrine::printing
