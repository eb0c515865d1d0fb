#include "exhibits/printing/print_raster.h"

#include "render/failure.h"
#include "render/image/rec709.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t mostImagePixels = 1 << 26;

}  // namespace

PrintRaster::PrintRaster(const PrintLayout& layout, const std::vector<fs::path>& tiles,
                         std::vector<std::int64_t> repeated)
    : layout_(layout), repeated_(std::move(repeated))
{
    repeated_.resize(tiles.size());
    std::int64_t width = 0;
    std::int64_t height = 0;
    for (const fs::path& tile : tiles) {
        tiles_.emplace_back(tile);
        const std::int64_t own = tiles_.back().width() - repeated_[tiles_.size() - 1];
        if (own < 1 || own > tiles_.back().width()) break;
        width += own;
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
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        render::PictureRows& tile = tiles_[i];
        const auto whole = static_cast<std::size_t>(tile.width()) * 3;
        const auto left = static_cast<std::size_t>(repeated_[i]) * 3;
        part_.resize(whole);
        tile.read(y, 1, left > 0 ? part_.data() : to);
        if (left > 0) std::copy(part_.begin() + static_cast<std::ptrdiff_t>(left), part_.end(), to);
        to += whole - left;
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

}  // namespace vitrine::printing
