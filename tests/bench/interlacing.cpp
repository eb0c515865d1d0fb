// Interlacing 16 views of 1200 x 800 into 4800 x 3200 (600 dpi, 40.15 LPI): the interlacer beside a plain copy
// of the same bytes and beside a straightforward loop over the pixels.

#include "exhibits/lenticular/interlace.h"
#include "exhibits/lenticular/strip_weights.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>
#include <thread>

using namespace vitrine;
using namespace vitrine::lenticular;

namespace {

constexpr int viewCount = 16;
constexpr int runs = 9;

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

PrintLayout layoutFor(Method method)
{
    PrintSettings settings;
    settings.sheet = derivedSheet("bench", 40.15, 30);
    settings.width = 4800 / 600.0 * 25.4;
    settings.height = 3200 / 600.0 * 25.4;
    settings.views = viewCount;
    settings.method = method;
    return PrintLayout(settings);
}

void report(const char* name, double pixels, const std::function<void()>& work, int repetitions = runs)
{
    std::vector<double> times;
    work();
    for (int i = 0; i < repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    const double median = times[times.size() / 2];
    std::printf("| %-44s | %8.2f | %8.2f | %8.0f |\n", name, 1e3 * times.front(), 1e3 * median, pixels / times.front() / 1e6);
}

/// What one writes first: weights per pixel, a view's nearest column under the lens's axis, floats, pow.
void plainLoop(const PrintLayout& layout, const ViewSet& views, std::vector<std::uint8_t>& out)
{
    std::vector<Tap> taps;
    std::uint8_t* at = out.data();
    for (std::int64_t y = 0; y < layout.height(); ++y) {
        const int row = static_cast<int>(y * views.height() / layout.height());
        for (std::int64_t x = 0; x < layout.width(); ++x) {
            tapsAt(layout, static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5, taps);
            double sum[3] = {0, 0, 0};
            for (const Tap& tap : taps) {
                const double axis = static_cast<double>(tap.lens) / layout.lensesPerPixelX() + static_cast<double>(layout.width()) / 2;
                const int width = views.view(tap.view).width;
                const int column = std::clamp(static_cast<int>(axis * width / static_cast<double>(layout.width())), 0, width - 1);
                const std::uint16_t* pixel = views.row(tap.view, row) + static_cast<std::size_t>(column) * 4;
                for (int c = 0; c < 3; ++c) sum[c] += tap.weight * pixel[c];
            }
            for (const double channel : sum) *at++ = render::srgb8FromLinear(static_cast<float>(channel / 65535));
        }
    }
}

}  // namespace

int main()
{
    const ViewSet views = noisyViews();
    const PrintLayout area = layoutFor(Method::area);
    const PrintLayout nearest = layoutFor(Method::nearest);
    const std::size_t bytes = static_cast<std::size_t>(area.width() * area.height()) * 3;
    const auto pixels = static_cast<double>(area.width() * area.height());
    std::vector<std::uint8_t> out(bytes);
    std::vector<std::uint8_t> copy(bytes);
    std::printf("%d views of 1200 x 800 into %lld x %lld, 8 bits, %.2f pixels per lens; the columns are prepared once.\n", viewCount,
                static_cast<long long>(area.width()), static_cast<long long>(area.height()), area.pixelsPerLens());
    std::printf("%u threads of hardware; best and median of %d runs.\n\n", std::thread::hardware_concurrency(), runs);
    std::printf("| %-44s | %8s | %8s | %8s |\n|---|---|---|---|\n", "what", "best ms", "median", "MPixel/s");
    report("memcpy of the print's bytes", pixels, [&] { std::memcpy(copy.data(), out.data(), bytes); });
    const Interlacer nearestMaker(nearest, views);
    const Interlacer areaMaker(area, views);
    const Region whole{0, 0, area.width(), area.height()};
    for (const int threads : {1, 2}) {
        const std::string suffix = threads == 1 ? ", 1 thread" : ", 2 threads";
        report(("nearest" + suffix).c_str(), pixels, [&] { nearestMaker.fill(whole, out.data(), threads); });
        report(("area, linear light" + suffix).c_str(), pixels, [&] { areaMaker.fill(whole, out.data(), threads); });
    }
    report("preparing the columns (area)", pixels, [&] { const Interlacer again(area, views); });
    report("straightforward loop (area), 1 thread", pixels, [&] { plainLoop(area, views, out); }, 1);
}
