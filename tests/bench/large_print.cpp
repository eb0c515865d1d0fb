// Time and peak memory of `vitrine print` for a print of 40,000 x 36,000 pixels, 1.7 x 1.5 m at 600 dpi, from files.
// Memory must stay below 300 MB, although the print has 4.3 GB and the views 390 MB. Needs 5 GB below TMPDIR, /tmp by
// default.

#include "tests/bench/bench.h"

#include "render/image/image_io.h"
#include "tests/bench/child.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace vitrine::bench {
namespace {

constexpr int viewCount = 24, viewWidth = 1600, viewHeight = 1440;

/// Writes pictures without large uniform areas; each view is different.
void writeViews(const std::string& folder)
{
    std::filesystem::create_directories(folder);
    render::Image image(viewWidth, viewHeight, 3);
    for (int k = 0; k < viewCount; ++k) {
        for (int y = 0; y < viewHeight; ++y)
            for (int x = 0; x < viewWidth; ++x)
                for (int c = 0; c < 3; ++c)
                    image.at(x, y, c) =
                        static_cast<float>(0.5 + 0.5 * std::sin(0.01 * (c + 1) * x + 0.013 * y + 0.4 * k));
        char name[32];
        std::snprintf(name, sizeof name, "/view-%02d.png", k);
        render::writePicture(folder + name, image, render::PictureFormat::png8);
    }
}

}  // namespace

bool largePrint(const Options& options)
{
    const double scale = options.scale;
    const test::TemporaryFolder folder;
    writeViews(folder / "views");
    const auto width = static_cast<long long>(40000 * scale);
    const auto height = static_cast<long long>(36000 * scale);
    const auto millimeters = [](long long pixels) { return std::to_string(static_cast<double>(pixels) / 600 * 25.4); };
    const double pixels = static_cast<double>(width) * static_cast<double>(height);
    std::printf("%d views of %d x %d, PNG, into %lld x %lld at 600 dpi and 40 LPI, 8 bits; `vitrine print` as a "
                "process of its own.\n\n",
                viewCount, viewWidth, viewHeight, width, height);
    std::printf("| file | MB | s (wall) | s (CPU) | MPixel/s | peak of memory, MB |\n|---|---|---|---|---|---|\n");
    const std::string out = folder / "print.tif";
    const Run run = runProgram({"print", "--views", folder / "views", "--lpi", "40", "--dpi", "600", "--width-mm",
                                millimeters(width), "--height-mm", millimeters(height), "--out", out});
    if (run.code != 0) {
        std::fprintf(stderr, "benchmarks: vitrine print ended with %d.\n", run.code);
        return false;
    }
    std::printf("| TIFF | %.0f | %.1f | %.1f | %.0f | %.0f |\n",
                static_cast<double>(std::filesystem::file_size(out)) / 1e6, run.wallSeconds, run.cpuSeconds,
                pixels / run.wallSeconds / 1e6, run.peakMegabytes);
    std::printf("\nA print of %lld x %lld takes %.0f MB of memory at most (goal: 300).\n", width, height,
                run.peakMegabytes);
    return true;
}

}  // namespace vitrine::bench
