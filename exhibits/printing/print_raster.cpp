#include "exhibits/printing/print_raster.h"

#include "exhibits/printing/print_json.h"
#include "render/failure.h"
#include "render/image/picture_stream.h"
#include "render/image/rec709.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t mostImagePixels = 1 << 26;

/// Splits "name-3.tif" into "name" and its number. Returns false if it has no number.
bool splitTile(const fs::path& path, std::string& stem)
{
    stem = path.stem().string();
    const std::size_t dash = stem.find_last_of('-');
    if (dash == std::string::npos || dash + 1 == stem.size() ||
        stem.find_first_not_of("0123456789", dash + 1) != std::string::npos)
        return false;
    stem.resize(dash);
    return true;
}

fs::path tileOf(const fs::path& path, const std::string& stem, std::size_t number)
{
    fs::path tile = path;
    tile.replace_filename(stem + "-" + std::to_string(number) + path.extension().string());
    return tile;
}

}  // namespace

PrintRaster::PrintRaster(const PrintLayout& layout, const std::vector<fs::path>& tiles) : layout_(layout)
{
    std::int64_t width = 0;
    std::int64_t height = 0;
    for (const fs::path& tile : tiles) {
        tiles_.emplace_back(tile);
        width += tiles_.back().width();
        height = tiles_.back().height();
        if (height != layout.height()) break;
    }
    if (width != layout.width() || height != layout.height()) {
        throw Failure(ErrorKind::file, "The print " + tiles.front().string() + " has " + std::to_string(width) + " x " +
                                           std::to_string(height) + " pixels, and its description says " +
                                           std::to_string(layout.width()) + " x " + std::to_string(layout.height()) +
                                           "; look at the unscaled, uncut file, or at all its tiles.");
    }
    // The window initially covers three lenses.
    const double lens = layout.printPitch() * layout.settings().dpiY / 25.4;
    capacity_ = std::min<std::int64_t>(height, std::max<std::int64_t>(64, std::llround(std::min(3 * lens, 4096.0))));
    rows_.resize(static_cast<std::size_t>(capacity_) * static_cast<std::size_t>(width) * 3);
}

void PrintRaster::load(std::int64_t y)
{
    std::uint16_t* to =
        rows_.data() + static_cast<std::size_t>(y % capacity_) * static_cast<std::size_t>(layout_.width()) * 3;
    for (render::PictureRows& tile : tiles_) {
        tile.read(y, 1, to);
        to += static_cast<std::size_t>(tile.width()) * 3;
    }
}

const std::uint16_t* PrintRaster::row(std::int64_t y)
{
    if (y < begin_) {
        // The caller needs more rows at once than the window has.
        capacity_ = std::min(2 * capacity_, layout_.height());
        rows_.resize(static_cast<std::size_t>(capacity_) * static_cast<std::size_t>(layout_.width()) * 3);
        begin_ = end_ = y;
    } else if (y >= end_ + capacity_) {
        begin_ = end_ = y;
    }
    for (; end_ <= y; ++end_) load(end_);
    begin_ = std::max(begin_, end_ - capacity_);
    return rows_.data() + static_cast<std::size_t>(y % capacity_) * static_cast<std::size_t>(layout_.width()) * 3;
}

render::Image PrintRaster::image()
{
    if (layout_.width() * layout_.height() > mostImagePixels) {
        throw Failure(ErrorKind::file,
                      "A print of " + std::to_string(layout_.width()) + " x " + std::to_string(layout_.height()) +
                          " pixels is too large to be held at once; choose one of up to 67 million pixels.");
    }
    render::Image image(static_cast<int>(layout_.width()), static_cast<int>(layout_.height()), 3);
    const std::size_t samples = static_cast<std::size_t>(layout_.width()) * 3;
    for (std::int64_t y = 0; y < layout_.height(); ++y) {
        const std::uint16_t* codes = row(y);
        float* out = image.pixels.data() + static_cast<std::size_t>(y) * samples;
        for (std::size_t i = 0; i < samples; ++i)
            out[i] = static_cast<float>(render::linearFromSrgb(codes[i] / 65535.0));
    }
    render::convertFromProfile(image, profile());
    return image;
}

namespace {

/// Returns the description that was written with the pixels. Nothing if there is none, or if it is unreadable but
/// another one may be used.
std::optional<render::JsonDocument> insideOf(const fs::path& print, bool anotherMayDo)
{
    try {
        if (const auto text = render::embeddedPrint(print)) return render::parseJson(*text, print.string());
    } catch (const Failure&) {
        if (!anotherMayDo) throw;
    }
    return std::nullopt;
}

bool saysTheSame(const std::string& file, const render::JsonDocument& inside)
{
    try {
        return render::readJson(file).root() == inside.root();
    } catch (const Failure&) {
        return false;
    }
}

}  // namespace

PrintDescription printDescription(const fs::path& print)
{
    std::error_code error;
    const std::string beside = print.string() + ".json";
    const bool hasBeside = fs::exists(beside, error);
    std::optional<render::JsonDocument> inside = insideOf(print, hasBeside);
    if (inside && (!hasBeside || saysTheSame(beside, *inside))) return {std::move(*inside), {}};
    if (inside)
        return {std::move(*inside), beside + " does not describe " + print.string() +
                                        ": it is of another print, or was changed. The description inside the print "
                                        "was used; make the print anew, or remove " +
                                        beside + "."};
    if (hasBeside) return {render::readJson(beside), {}};
    throw Failure(ErrorKind::file, "Cannot look at " + print.string() +
                                       ": it carries no description of its sheet, and there is no " + beside +
                                       " beside it; choose a file that vitrine print wrote.");
}

PrintRaster readPrint(const fs::path& path)
{
    std::error_code error;
    const fs::path first = fs::exists(path, error) ? path : tileOf(path, path.stem().string(), 1);
    const fs::path named = fs::exists(first, error) ? first : path;
    PrintDescription description = printDescription(named);
    const PrintLayout layout(settingsFromJson(description.document));
    std::vector<fs::path> tiles{named};
    std::string stem;
    if (render::PictureRows(named).width() < layout.width() && splitTile(named, stem)) {
        tiles.clear();
        std::int64_t width = 0;
        for (std::size_t number = 1; width < layout.width() && fs::exists(tileOf(named, stem, number), error);
             ++number) {
            tiles.push_back(tileOf(named, stem, number));
            width += render::PictureRows(tiles.back()).width();
        }
        if (tiles.empty()) tiles.push_back(named);
    }
    PrintRaster raster(layout, tiles);
    raster.setDoubt(std::move(description.doubt));
    return raster;
}

}  // namespace vitrine::printing
