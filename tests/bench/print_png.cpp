// PNGs of prints of 4800 x 3200 pixels: by libpng row after row, as the writer was before (level 1, one filter), and by
// PngRows with one and two threads; both of the same rows in memory, in one run. Prints a table; passes or fails
// nothing.
//   bench_print_png [--runs 5]

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_set.h"
#include "render/files/assets.h"
#include "render/image/image_io.h"
#include "render/image/png_rows.h"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>

using namespace vitrine;
using namespace vitrine::printing;

namespace {

constexpr std::int64_t printWidth = 4800;
constexpr std::int64_t printHeight = 3200;
int runs = 5;  // The machine may have other work: the best run counts.

struct Pixels {
    std::int64_t width, height;
    int bits;
    bool likeRowAbove;
    std::vector<std::uint8_t> bytes;
};

ViewSet noise()
{
    std::mt19937 random(1);
    ViewSet views;
    for (int k = 0; k < 16; ++k) {
        render::Image image(1200, 800, 3);
        for (float& x : image.pixels) x = static_cast<float>(random() % 65536) / 65535.0F;
        views.add(image);
    }
    return views;
}

ViewSet waves()
{
    ViewSet views;
    render::Image image(1200, 800, 3);
    for (int k = 0; k < 16; ++k) {
        for (int y = 0; y < 800; ++y)
            for (int x = 0; x < 1200; ++x)
                for (int c = 0; c < 3; ++c)
                    image.at(x, y, c) =
                        static_cast<float>(0.5 + 0.5 * std::sin(0.01 * (c + 1) * x + 0.013 * y + 0.4 * k));
        views.add(image);
    }
    return views;
}

ViewSet framesOf(const char* name)
{
    ViewSet views;
    for (int k = 0; k < 16; ++k) {
        char file[80];
        std::snprintf(file, sizeof file, "frames/%s/view_%02d.png", name, k);
        const render::Image image = render::readImage(render::asset(file));
        render::Image rgb(image.width, image.height, 3);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c) rgb.at(x, y, c) = image.at(x, y, c);
        views.add(rgb);
    }
    return views;
}

Pixels printOf(const ViewSet& views, Method method, int bits = 8, double direction = 0, bool dither = false)
{
    PrintSettings settings;
    settings.sheet = derivedSheet("bench", 40.15, 30);
    settings.width = static_cast<double>(printWidth) / 600.0 * 25.4;
    settings.height = static_cast<double>(printHeight) / 600.0 * 25.4;
    settings.views = 16;
    settings.method = method;
    settings.direction = direction;
    settings.dither = dither;
    const PrintLayout layout(settings);
    const Region all{0, 0, layout.width(), layout.height()};
    const auto samples = static_cast<std::size_t>(layout.width() * layout.height()) * 3;
    Pixels pixels{layout.width(), layout.height(), bits, layout.vertical(),
                  std::vector<std::uint8_t>(samples * static_cast<std::size_t>(bits / 8))};
    const Interlacer maker(layout, views);
    if (bits == 8)
        maker.fill(all, pixels.bytes.data(), 2);
    else
        maker.fill(all, reinterpret_cast<std::uint16_t*>(pixels.bytes.data()), 2);
    return pixels;
}

/// As PngRows was before: one thread, zlib at level 1, one filter for all rows.
void writeByLibpng(const Pixels& pixels, const std::string& path)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_compression_buffer_size(png, 1U << 18U);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, pixels.likeRowAbove ? PNG_FILTER_UP : PNG_FILTER_SUB);
    png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height),
                 pixels.bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    if (pixels.bits == 16) png_set_swap(png);
    const std::size_t stride = pixels.bytes.size() / static_cast<std::size_t>(pixels.height);
    for (std::size_t y = 0; y < static_cast<std::size_t>(pixels.height); ++y)
        png_write_row(png, pixels.bytes.data() + y * stride);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

void writeByRows(const Pixels& pixels, const std::string& path, int threads)
{
    render::PngRowTarget target{path, pixels.width, pixels.height, pixels.bits, 600, 600, pixels.likeRowAbove};
    target.threads = threads;
    render::PngRows rows(target, render::systemFileOps());
    std::string why = rows.begin();
    const std::size_t stride = pixels.bytes.size() / static_cast<std::size_t>(pixels.height);
    for (std::int64_t y = 0; y < pixels.height && why.empty(); y += 64)
        why = rows.write(pixels.bytes.data() + static_cast<std::size_t>(y) * stride,
                         std::min<std::int64_t>(64, pixels.height - y));
    if (why.empty()) why = rows.close();
    if (!why.empty()) std::fprintf(stderr, "bench_print_png: %s\n", why.c_str());
}

double processorSeconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Times {
    double best = 1e9;
    double processor = 1e9;  ///< Of all threads together.
    double megabytes = 0;
};

void measure(Times& times, const std::string& path, const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    const double processor = processorSeconds();
    work();
    times.processor = std::min(times.processor, processorSeconds() - processor);
    times.best = std::min(times.best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    times.megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
}

struct Worst {
    double speed = 1e9, processor = 1e9, size = 0;
};

void compare(const char* name, const Pixels& pixels, Worst& worst)
{
    const std::string path =
        (std::filesystem::temp_directory_path() / ("vitrine-bench-" + std::to_string(::getpid()) + ".png")).string();
    Times before;
    Times one;
    Times two;
    for (int i = 0; i < runs; ++i) {
        measure(before, path, [&] { writeByLibpng(pixels, path); });
        measure(one, path, [&] { writeByRows(pixels, path, 1); });
        measure(two, path, [&] { writeByRows(pixels, path, 2); });
    }
    std::filesystem::remove(path);
    std::printf("| %-36s | %6.0f | %6.0f | %6.2f | %6.0f | %6.0f | %6.0f | %6.2f | %5.1f | %5.1f | %5.3f |\n", name,
                1e3 * before.best, 1e3 * before.processor, before.megabytes, 1e3 * one.best, 1e3 * two.best,
                1e3 * two.processor, two.megabytes, before.best / two.best, before.processor / two.processor,
                two.megabytes / before.megabytes);
    std::fflush(stdout);
    worst.speed = std::min(worst.speed, before.best / two.best);
    worst.processor = std::min(worst.processor, before.processor / two.processor);
    worst.size = std::max(worst.size, two.megabytes / before.megabytes);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "--runs") == 0) runs = std::max(std::atoi(argv[2]), 1);
    std::printf("Prints of %lld x %lld from 16 views; the best of %d runs, each of both writers.\n\n",
                static_cast<long long>(printWidth), static_cast<long long>(printHeight), runs);
    std::printf("CPU is the processors' time of all threads together.\n\n");
    std::printf("| %-36s | %6s | %6s | %6s | %6s | %6s | %6s | %6s | %5s | %5s | %5s |\n", "print", "libpng", "CPU ms",
                "MB", "1 thr.", "2 thr.", "CPU ms", "MB", "times", "CPU", "size");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
    Worst worst;
    {
        const ViewSet views = noise();
        compare("noise, area", printOf(views, Method::area), worst);
        compare("noise, nearest", printOf(views, Method::nearest), worst);
        compare("noise, area, 16 bits", printOf(views, Method::area, 16), worst);
    }
    {
        const ViewSet views = waves();
        compare("waves, area", printOf(views, Method::area), worst);
        compare("waves, nearest", printOf(views, Method::nearest), worst);
        compare("waves, area, 16 bits", printOf(views, Method::area, 16), worst);
        compare("waves, area, dithered", printOf(views, Method::area, 8, 0, true), worst);
    }
    for (const char* name : {"turning_mug", "melting_torus"}) {
        const ViewSet views = framesOf(name);
        const std::string frames(name);
        compare((frames + ", area").c_str(), printOf(views, Method::area), worst);
        compare((frames + ", nearest").c_str(), printOf(views, Method::nearest), worst);
        compare((frames + ", nearest, lenses across").c_str(), printOf(views, Method::nearest, 8, 90), worst);
        compare((frames + ", area, 16 bits").c_str(), printOf(views, Method::area, 16), worst);
        compare((frames + ", area, dithered").c_str(), printOf(views, Method::area, 8, 0, true), worst);
    }
    std::printf(
        "\nTwo threads write them at least %.1f times as fast (goal: 6), in %.1f times less time of processors, "
        "and no file is more than %.3f times as large (goal: 1.05).\n",
        worst.speed, worst.processor, worst.size);
}
