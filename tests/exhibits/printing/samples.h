#pragma once

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/print_json.h"
#include "render/files/strict_json.h"
#include "render/image/image.h"
#include "render/image/srgb.h"
#include "tests/exhibits/printing/values_of.h"

#include <random>

namespace vitrine::printing::test {

/// Returns settings for a print of `columns` x `rows` pixels at `dpi`.
inline PrintSettings settingsFor(double lpi, double dpi, int views, double columns, double rows)
{
    PrintSettings s;
    s.sheet = derivedSheet("test", lpi, 40);
    s.dpiX = s.dpiY = dpi;
    s.width = columns / dpi * 25.4;
    s.height = rows / dpi * 25.4;
    s.views = views;
    return s;
}

/// Returns views of uniform levels: view k has (k + 1) / (count + 1) of linear light.
inline ViewSet solidViews(int count)
{
    ViewSet views;
    for (int k = 0; k < count; ++k)
        views.add(render::Image(8, 8, 3, static_cast<float>(k + 1) / static_cast<float>(count + 1)));
    return views;
}

inline ViewSet noisyViews(int count, int width, int height)
{
    std::mt19937 random(7);
    ViewSet views;
    for (int k = 0; k < count; ++k) {
        render::Image image(width + k % 3, height, 3);
        for (float& x : image.pixels) x = static_cast<float>(random() % 65536) / 65535.0F;
        views.add(image);
    }
    return views;
}

inline std::vector<std::uint8_t> printOf(const PrintLayout& layout, const ViewSet& views, int threads = 1)
{
    std::vector<std::uint8_t> out(static_cast<std::size_t>(layout.width() * layout.height()) * 3);
    Interlacer(layout, views).fill({0, 0, layout.width(), layout.height()}, out.data(), threads);
    return out;
}

/// Returns the description of a print as its file has it.
inline std::string descriptionOf(const PrintLayout& layout)
{
    return render::writeJson(printJson(valuesOf(layout.settings()), layout, layout.settings().dpiX, {{"a.png"}}));
}

inline render::Image linearImage(const PrintLayout& layout, const std::vector<std::uint8_t>& codes)
{
    render::Image image(static_cast<int>(layout.width()), static_cast<int>(layout.height()), 3);
    for (std::size_t i = 0; i < codes.size(); ++i)
        image.pixels[i] = static_cast<float>(render::linearFromSrgb(codes[i] / 255.0));
    return image;
}

}  // namespace vitrine::printing::test
