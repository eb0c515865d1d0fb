// Interlacing 16 views of 1200 x 800 into 4800 x 3200 (600 dpi, 40.15 LPI): the interlacer beside a plain copy
// of the same bytes and beside a straightforward loop over the pixels.

#include "tests/bench/bench.h"

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/view_weights.h"
#include "render/image/srgb.h"
#include "render/measure/clock.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>
#include <thread>

namespace vitrine::bench {
namespace {

using namespace vitrine::printing;

constexpr int viewCount = 16;
int runs = 25;  // The best run counts, because the machine may do other work.

ViewSet noisyViews()
{
    std::mt19937 random(1);
    ViewSet views;
    for (int k = 0; k < viewCount; ++k) {
        render::Image image(1200, 800, 3);
        for (float& x : image.pixels) x = static_cast<float>(random() % 65536) / 65535.0F;
        views.add(image);
    }
    return views;
}

PrintLayout layoutFor(Method method, bool compensate = false, bool dither = false)
{
    PrintSettings settings;
    settings.sheet = derivedSheet("bench", 40.15, 30);
    settings.width = 4800 / 600.0 * 25.4;
    settings.height = 3200 / 600.0 * 25.4;
    settings.views = viewCount;
    settings.method = method;
    settings.compensate = compensate;
    settings.dither = dither;
    return PrintLayout(settings);
}

double copyTime = 1;  ///< Seconds for copying the bytes of the print, in this process.

double report(const char* name, double pixels, const std::function<void()>& work, int repetitions = runs)
{
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        const double start = render::wallSeconds();
        work();
        times.push_back(render::wallSeconds() - start);
    }
    std::sort(times.begin(), times.end());
    const double best = times.front();
    std::printf("| %-46s | %8.2f | %8.2f | %8.0f | %8.1f |\n", name, 1e3 * best, 1e3 * times[times.size() / 2],
                pixels / best / 1e6, best / copyTime);
    return best;
}

/// Simple implementation: weights per pixel, the view column nearest to the lens's axis, floats, pow.
void plainLoop(const PrintLayout& layout, const ViewSet& views, std::vector<std::uint8_t>& out)
{
    std::vector<ViewWeight> taps;
    std::uint8_t* at = out.data();
    for (std::int64_t y = 0; y < layout.height(); ++y) {
        const int row = static_cast<int>(y * views.height() / layout.height());
        for (std::int64_t x = 0; x < layout.width(); ++x) {
            viewWeightsAt(layout, static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5, taps);
            double sum[3] = {0, 0, 0};
            for (const ViewWeight& tap : taps) {
                const double axis =
                    static_cast<double>(tap.lens) / layout.lensesPerPixelX() + static_cast<double>(layout.width()) / 2;
                const int width = views.view(tap.view).width;
                const int column =
                    std::clamp(static_cast<int>(axis * width / static_cast<double>(layout.width())), 0, width - 1);
                const std::uint16_t* pixel = views.row(tap.view, row) + static_cast<std::size_t>(column) * 3;
                for (int c = 0; c < 3; ++c) sum[c] += tap.weight * pixel[c];
            }
            for (const double channel : sum) *at++ = render::srgb8FromLinear(static_cast<float>(channel / 65535));
        }
    }
}

}  // namespace

bool interlacing(const Options& options)
{
    runs = options.runsOr(runs);
    const ViewSet views = noisyViews();
    const PrintLayout area = layoutFor(Method::area), nearest = layoutFor(Method::nearest),
                      compensated = layoutFor(Method::area, true), dithered = layoutFor(Method::area, false, true);
    const std::size_t bytes = static_cast<std::size_t>(area.width() * area.height()) * 3;
    const auto pixels = static_cast<double>(area.width() * area.height());
    std::vector<std::uint8_t> out(bytes), copy(bytes);
    std::printf(
        "%d views of 1200 x 800 into %lld x %lld, 8 bits, %.2f pixels per lens; the columns are prepared once.\n",
        viewCount, static_cast<long long>(area.width()), static_cast<long long>(area.height()), area.pixelsPerLens());
    std::printf("%u threads of hardware; best and median of %d runs; times of a memcpy in the same run.\n\n",
                std::thread::hardware_concurrency(), runs);
    std::printf("| %-46s | %8s | %8s | %8s | %8s |\n|---|---|---|---|---|\n", "what", "best ms", "median", "MPixel/s",
                "memcpys");
    const auto copying = [&] { std::memcpy(copy.data(), out.data(), bytes); };
    for (int i = 0; i < runs; ++i) {
        const double start = render::wallSeconds();
        copying();
        copyTime = std::min(copyTime, render::wallSeconds() - start);
    }
    report("memcpy of the print's bytes", pixels, copying);
    const Interlacer nearestMaker(nearest, views), areaMaker(area, views), compensatedMaker(compensated, views),
        ditheredMaker(dithered, views);
    const Region whole{0, 0, area.width(), area.height()};
    const double near = report("nearest, 1 thread", pixels, [&] { nearestMaker.fill(whole, out.data(), 1); });
    const double mixed = report("area, linear light, 1 thread", pixels, [&] { areaMaker.fill(whole, out.data(), 1); });
    report("nearest, 2 threads", pixels, [&] { nearestMaker.fill(whole, out.data(), 2); });
    report("area, linear light, 2 threads", pixels, [&] { areaMaker.fill(whole, out.data(), 2); });
    report("area, cross-talk compensated, 1 thread", pixels, [&] { compensatedMaker.fill(whole, out.data(), 1); });
    report("area, dithered, 1 thread", pixels, [&] { ditheredMaker.fill(whole, out.data(), 1); });
    report("preparing the columns (area)", pixels, [&] { const Interlacer again(area, views); });
    report(
        "straightforward loop (area), 1 thread", pixels, [&] { plainLoop(area, views, out); }, 1);
    std::printf("\nOne thread interlaces %.0f MPixel/s with the nearest view (goal: 1000) and %.0f with areas in "
                "linear light (goal: 500).\n",
                pixels / near / 1e6, pixels / mixed / 1e6);
    return true;
}

}  // namespace vitrine::bench
