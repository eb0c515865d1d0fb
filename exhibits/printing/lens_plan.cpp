#include "exhibits/printing/lens_plan.h"

#include "exhibits/printing/view_weights.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {

LensPlan::LensPlan(const PrintLayout& layout, const ViewSet& set) : views(static_cast<std::size_t>(set.count()))
{
    for (std::size_t strip = 0; strip < views; ++strip)
        viewOfSlot.push_back(layout.viewOfStrip(static_cast<std::int64_t>(strip)));
    planColumns(layout);
    planLenses(layout, set);
}

void LensPlan::planColumns(const PrintLayout& layout)
{
    const std::int64_t width = layout.width();
    const bool reverse = layout.settings().reverse;
    const auto count = static_cast<std::int64_t>(views);
    const auto stripOf = [&](const ViewWeight& tap) {
        return tap.lens * count + (reverse ? tap.view : count - 1 - tap.view);
    };
    // Two passes: first the strips and their number, then the weights, which depend on the number.
    std::vector<ViewWeight> row;
    const auto tapsOf = [&](std::int64_t x) {
        const std::int64_t front = layout.settings().mirror ? width - 1 - x : x;
        viewWeightsAt(layout, static_cast<double>(front) + 0.5, 0, row);
    };
    std::vector<std::int64_t> firstStrip;
    std::int64_t least = 0;
    std::int64_t most = 0;
    for (std::int64_t x = 0; x < width; ++x) {
        tapsOf(x);
        const std::int64_t first = stripOf(row.front());
        const std::int64_t last = stripOf(row.back());
        firstStrip.push_back(first);
        taps = std::max(taps, static_cast<std::size_t>(last - first + 1));
        least = x == 0 ? first : std::min(least, first);
        most = x == 0 ? last : std::max(most, last);
    }
    const auto lensOf = [&](std::int64_t strip) { return strip >= 0 ? strip / count : -((count - 1 - strip) / count); };
    firstLens_ = lensOf(least);
    lenses = static_cast<std::size_t>(lensOf(most) - firstLens_ + 1);
    single = taps == 1;
    tapWeights.resize(static_cast<std::size_t>(width) * taps);
    for (std::int64_t x = 0; x < width; ++x) {
        const std::int64_t first = firstStrip[static_cast<std::size_t>(x)];
        firstSlot.push_back(static_cast<std::uint32_t>(first - firstLens_ * count));
        tapsOf(x);
        for (const ViewWeight& tap : row) {
            const auto weight = static_cast<float>(tap.weight);
            tapWeights[static_cast<std::size_t>(x) * taps + static_cast<std::size_t>(stripOf(tap) - first)] = weight;
            single = single && weight == 1;
        }
    }
}

void LensPlan::planLenses(const PrintLayout& layout, const ViewSet& set)
{
    const auto printWidth = static_cast<double>(layout.width());
    BoxTaps box;
    std::vector<std::size_t> spansOfView;
    for (int k = 0; k < set.count(); ++k) {
        const int viewWidth = set.view(k).width;
        int alike = 0;
        while (set.view(alike).width != viewWidth) ++alike;
        spansOfView.push_back(alike < k ? spansOfView[static_cast<std::size_t>(alike)] : spans.size());
        if (alike < k) continue;
        const double scale = viewWidth / printWidth;
        // All spans get the length of the longest, padded with weights of 0, if the view is wide enough.
        const double columns = scale / layout.lensesPerPixelX();
        const int longest = columns <= 1 ? 2 : 2 * ((static_cast<int>(std::ceil(columns)) + 2) / 2);
        for (std::size_t i = 0; i < lenses; ++i) {
            const auto lens = static_cast<double>(firstLens_ + static_cast<std::int64_t>(i));
            const double axis = (lens - layout.settings().phase) / layout.lensesPerPixelX() + printWidth / 2;
            boxTaps(axis * scale, scale / layout.lensesPerPixelX(), viewWidth, box);
            if (viewWidth >= longest && static_cast<int>(box.weights.size()) <= longest) {
                const int back = std::max(0, box.first + longest - viewWidth);
                box.first -= back;
                box.weights.insert(box.weights.begin(), static_cast<std::size_t>(back), 0.0F);
                box.weights.resize(std::max(box.weights.size(), static_cast<std::size_t>(longest)), 0.0F);
            }
            if (box.weights.size() % 2 != 0) box.weights.push_back(0);
            spans.push_back(
                {box.first, static_cast<int>(box.weights.size() / 2), static_cast<std::uint32_t>(weights.size())});
            for (std::size_t pair = 0; pair < box.weights.size(); pair += 2) {
                weights.insert(weights.end(), 3, box.weights[pair]);
                weights.insert(weights.end(), 3, box.weights[pair + 1]);
                weights.insert(weights.end(), 2, 0.0F);
            }
        }
    }
    for (const int view : viewOfSlot) spansOf.push_back(spansOfView[static_cast<std::size_t>(view)]);
}

LensPlan::Lenses LensPlan::lensesOf(std::size_t x0, std::size_t x1) const
{
    const auto [least, most] = std::minmax(firstSlot[x0], firstSlot[x1 - 1]);
    return {least / views, std::min((most + taps - 1) / views + 1, lenses)};
}

}  // namespace vitrine::printing
