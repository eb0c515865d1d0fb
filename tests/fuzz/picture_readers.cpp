#include "exhibits/printing/print_json.h"
#include "exhibits/printing/print_raster.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vitrine::fuzz {

bool readImage(std::string_view bytes)
{
    render::ImageLimits limits;
    limits.pixels = 1U << 20U;
    limits.decodedBytes = 16U << 20U;
    const bool texture = accepts([&] {
        const auto t = render::textureFromBytes(bytes, "fuzz", {}, limits);
        require(t && t->width > 0 && t->height > 0, "a texture has a size");
        const std::size_t texels = static_cast<std::size_t>(t->width) * static_cast<std::size_t>(t->height);
        require(t->bytes.size() % texels == 0 && t->floats.size() % texels == 0 &&
                    !(t->bytes.empty() && t->floats.empty()),
                "a texture has all its texels");
    });
    const MemoryFile file(bytes);
    const bool image = accepts([&] {
        render::ReadOptions options;
        options.limits = limits;
        const render::Image read = render::readImage(file.path(), options);
        require(read.pixels.size() == static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height) *
                                          static_cast<std::size_t>(read.channels),
                "an image has all its pixels");
        require(std::all_of(read.pixels.begin(), read.pixels.end(), [](float x) { return std::isfinite(x); }),
                "an image is finite");
    });
    (void)accepts([&] { (void)render::embeddedPreset(file.path()); });
    (void)accepts([&] { (void)render::embeddedProfile(file.path()); });
    return texture || image;
}

bool readPrintFile(std::string_view bytes)
{
    const MemoryFile file(bytes);
    return accepts([&] {
        printing::PrintRaster print = printing::readPrint(file.path());
        const printing::PrintLayout& layout = print.layout();
        // Larger prints are read in the same way, and would take a fuzzer's memory.
        if (layout.width() > 4096 || layout.height() > 4096) return;
        for (const std::int64_t row : {std::int64_t{0}, layout.height() - 1})
            require(print.row(row) != nullptr, "a print has all its rows");
    });
}

bool readDescription(std::string_view bytes)
{
    return accepts([&] {
        const printing::SavedSettings saved = printing::savedSettings(std::string(bytes), "fuzz.tif.json");
        requireLegal(saved.values);
        (void)printing::settingsText(saved.values, saved.sources);
        const render::JsonDocument document = render::parseJson(std::string(bytes), "fuzz.tif.json");
        if (!document.root().contains("print")) return;
        const printing::PrintLayout layout(printing::settingsFromJson(document));
        require(layout.width() > 0 && layout.height() > 0 && std::isfinite(layout.printPitch()) &&
                    std::isfinite(layout.lensAt(0, 0)),
                "a print has a size and lenses");
        (void)printing::warningsOf(layout);
    });
}

}  // namespace vitrine::fuzz
