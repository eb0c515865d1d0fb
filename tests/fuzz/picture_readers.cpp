#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/print_numbers.h"
#include "exhibits/printing/read_print.h"
#include "exhibits/printing/view_files.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"
#include "render/video/carried_settings.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

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
        // Larger prints are read in the same way, but need too much memory in a fuzzer.
        if (layout.width() > 4096 || layout.height() > 4096) return;
        require(print.row(0) != nullptr, "a print has a first row");
        // OpenImageIO allocates 64 MB for each row of a TIFF that it reads, which is slow under sanitizers. The last
        // row is therefore read for heights of 1 and of more than 1000 only.
        if (layout.height() == 1 || layout.height() > 1000)
            require(print.row(layout.height() - 1) != nullptr, "a print has a last row");
    });
}

bool readVideo(std::string_view bytes)
{
    using render::VideoFormat;
    const VideoFormat format = bytes.starts_with("GIF8")               ? VideoFormat::gif
                               : bytes.starts_with("RIFF")             ? VideoFormat::webp
                               : bytes.starts_with("\x1A\x45\xDF\xA3") ? VideoFormat::webm
                               : bytes.starts_with("\x89PNG")          ? VideoFormat::apng
                                                                       : VideoFormat::mp4;
    const MemoryFile file(bytes);
    bool found = false;
    (void)accepts([&] {
        const std::optional<std::string> settings = render::carriedSettings(file.path(), format);
        if (!settings) return;
        found = true;
        (void)render::parseJson(*settings, "settings");
    });
    return found;
}

bool readNames(std::string_view bytes)
{
    constexpr std::size_t most = 16;
    std::vector<std::string> names;
    for (std::size_t at = 0; at < bytes.size() && names.size() < most;) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        names.emplace_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    const auto before = printing::beforeByNumber;
    bool any = false;
    for (const std::string& a : names) {
        require(!before(a, a), "no name comes before itself");
        for (const std::string& b : names) {
            require(a == b || before(a, b) != before(b, a), "of two names one comes first");
            for (const std::string& c : names)
                require(!(before(a, b) && before(b, c)) || before(a, c), "the order of names is transitive");
        }
        const render::Image quilt(12, 8, 1);
        any |= accepts([&] {
            const printing::PrintTable& table = printing::printTable();
            jobs::GivenValues given(table.initial());
            given.type(jobs::optionOf(given.options(), table.quilt.row), {a, "quilt.png"});
            const ParameterValues typed = given.settled({});
            const int columns = typed[table.quiltColumns], rows = typed[table.quiltRows];
            const render::Image view = printing::viewOfQuilt(quilt, columns, rows, columns * rows - 1);
            require(view.width >= 1 && view.height >= 1, "a view has pixels");
        });
    }
    return any;
}

bool readDescription(std::string_view bytes)
{
    return accepts([&] {
        const printing::SavedSettings saved = printing::savedSettings(std::string(bytes), "fuzz.tif.json");
        requireLegal(saved.values);
        (void)printing::settingsText(saved.values);
        const render::JsonDocument document = render::parseJson(std::string(bytes), "fuzz.tif.json");
        if (!document.root().contains("views")) return;
        const printing::PrintLayout layout(printing::settingsFromJson(document));
        require(layout.width() > 0 && layout.height() > 0 && std::isfinite(layout.printPitch()) &&
                    std::isfinite(layout.lensAt(0, 0)),
                "a print has a size and lenses");
        (void)printing::warningsOf(layout);
    });
}

}  // namespace vitrine::fuzz
