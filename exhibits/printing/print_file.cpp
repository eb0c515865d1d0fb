#include "exhibits/printing/print_file.h"

#include "exhibits/printing/print_marks.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <optional>
#include <thread>

namespace vitrine::printing {
namespace {

/// Returns rows per strip: about 8 million samples, in whole strips of the file.
std::int64_t stripRows(std::int64_t width)
{
    return std::clamp<std::int64_t>((8 << 20) / (width * 3) / 64 * 64, 16, 512);
}

/// Makes rows of a raster in the colors of the file.
template <typename Code> class RowMaker {
public:
    RowMaker(const PrintLayout& layout, std::function<void(const Region&, Code*)> make, const PrintFile& file)
        : make_(std::move(make)), marks_(layout, tileCuts(layout, file.tileWidth))
    {
        if (!file.outputProfile.empty()) conversion_.emplace(file.profile, file.outputProfile, file.conversion);
    }

    [[nodiscard]] std::size_t channels() const
    {
        return conversion_ ? static_cast<std::size_t>(conversion_->channels()) : 3;
    }
    void fill(const Region& region, Code* out)
    {
        const auto pixels =
            static_cast<std::size_t>(region.x1 - region.x0) * static_cast<std::size_t>(region.y1 - region.y0);
        if (conversion_) unconverted_.resize(pixels * 3);
        Code* rgb = conversion_ ? unconverted_.data() : out;
        make_(region, rgb);
        marks_.draw(region, rgb);
        if (conversion_) conversion_->apply(rgb, out, pixels);
    }

private:
    std::function<void(const Region&, Code*)> make_;
    PrintMarks marks_;
    std::optional<render::ProfileConversion> conversion_;
    std::vector<Code> unconverted_;
};

template <typename Code>
void writeColumns(const PrintLayout& layout, const std::function<void(const Region&, Code*)>& source,
                  const PrintFile& file, std::int64_t x0, std::int64_t x1, render::PictureStream& out)
{
    RowMaker<Code> maker(layout, source, file);
    const std::int64_t height = layout.height();
    const std::int64_t rows = std::min(stripRows(x1 - x0), height);
    const std::size_t strip = static_cast<std::size_t>(rows) * static_cast<std::size_t>(x1 - x0) * maker.channels();
    std::vector<Code> written(strip);
    std::vector<Code> next(strip);
    maker.fill({x0, 0, x1, rows}, written.data());
    for (std::int64_t y = 0; y < height; y += rows) {
        const std::int64_t end = std::min(y + rows, height);
        std::future<void> making;
        if (end < height) {
            making = std::async(std::launch::async, [&, end] {
                maker.fill({x0, end, x1, std::min(end + rows, height)}, next.data());
            });
        }
        out.write(written.data(), end - y);
        if (making.valid()) making.get();
        std::swap(written, next);
        const double share = (static_cast<double>(x0) +
                              static_cast<double>(x1 - x0) * static_cast<double>(end) / static_cast<double>(height)) /
                             static_cast<double>(layout.width());
        if (file.progress && !file.progress(share))
            throw Failure(ErrorKind::usage, "Writing " + file.path.string() + " was stopped; nothing was changed.");
    }
    out.finish();
}

/// Returns the column of the cusp that is nearest to a column.
std::int64_t cuspColumn(const PrintLayout& layout, double at)
{
    const double cusp = std::round(layout.lensAt(at, 0));
    const double x = (cusp - layout.lensAt(0, 0)) / layout.lensesPerPixelX();
    return layout.settings().mirror ? layout.width() - std::llround(static_cast<double>(layout.width()) - x)
                                    : std::llround(x);
}

std::filesystem::path tilePath(const std::filesystem::path& path, std::size_t tile)
{
    std::filesystem::path name = path;
    name.replace_filename(path.stem().string() + "-" + std::to_string(tile + 1) + path.extension().string());
    return name;
}

/// Returns the part of a box that lies in the columns, from their left edge.
std::array<double, 4> inColumns(std::array<double, 4> box, std::int64_t x0, std::int64_t x1)
{
    for (const std::size_t side : {std::size_t{0}, std::size_t{2}})
        box.at(side) =
            std::clamp(box.at(side), static_cast<double>(x0), static_cast<double>(x1)) - static_cast<double>(x0);
    return box;
}

render::StreamSpec specOf(const PrintLayout& layout, const PrintFile& file, std::int64_t x0, std::int64_t x1)
{
    const PrintSettings& settings = layout.settings();
    render::StreamSpec spec;
    spec.width = x1 - x0;
    spec.height = layout.height();
    spec.bits = file.bits;
    spec.channels = render::profileChannels(file.outputProfile);
    spec.dpiX = settings.dpiX;
    spec.dpiY = settings.dpiY;
    spec.compression = file.compression;
    spec.likeRowAbove = layout.vertical();
    spec.json = file.json;
    spec.profile = file.outputProfile.empty() ? file.profile : file.outputProfile;
    spec.threads = file.threads;
    spec.trim = inColumns(layout.trimBox(), x0, x1);
    spec.bleed = inColumns(layout.bleedBox(), x0, x1);
    return spec;
}

}  // namespace

void requireRoom(const PrintLayout& layout, const PrintFile& file)
{
    std::int64_t columns = 0;
    for (const PrintTile& tile : printTiles(layout, file.tileWidth, file.tileOverlap)) {
        render::requireStream(
            file.path, {tile.x1 - tile.x0, layout.height(), render::profileChannels(file.outputProfile), file.bits});
        columns += tile.x1 - tile.x0;
    }
    render::requireSpace(file.path, render::streamBytes(file.path, specOf(layout, file, 0, columns)));
}

int interlacingThreads()
{
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
}

std::vector<std::int64_t> tileCuts(const PrintLayout& layout, double tileWidth)
{
    if (tileWidth == 0) return {0, layout.width()};
    if (!layout.vertical()) throw Failure(ErrorKind::usage, "Only prints with vertical lenses can be cut into tiles.");
    const double lenses = tileWidth / layout.printPitch();
    if (!(lenses >= 1) || !std::isfinite(lenses)) {
        throw Failure(ErrorKind::usage, "Tiles of " + shortText(tileWidth) + " mm are narrower than a lens, " +
                                            shortText(layout.printPitch()) + " mm.");
    }
    std::vector<std::int64_t> cuts{0};
    const double tile = tileWidth / mmPerInch * layout.settings().dpiX;
    for (double at = tile; at < static_cast<double>(layout.width()); at += tile) {
        const std::int64_t column = cuspColumn(layout, at);
        if (column > cuts.back() && column < layout.width()) cuts.push_back(column);
    }
    cuts.push_back(layout.width());
    return cuts;
}

std::vector<PrintTile> printTiles(const PrintLayout& layout, double tileWidth, double tileOverlap)
{
    const std::vector<std::int64_t> cuts = tileCuts(layout, tileWidth);
    if (tileWidth > 0 && !(tileOverlap < tileWidth))
        throw Failure(ErrorKind::usage, "An overlap of " + shortText(tileOverlap) +
                                            " mm is not smaller than the tiles, which are " + shortText(tileWidth) +
                                            " mm wide; give a smaller one.");
    const double overlap = tileOverlap / mmPerInch * layout.settings().dpiX;
    std::vector<PrintTile> tiles;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        PrintTile tile{cuts[i], cuts[i + 1]};
        if (i > 0 && overlap > 0) {
            // The cusp nearest to half a lens farther to the left is the last one before that column.
            const double before = static_cast<double>(cuts[i]) - overlap - 0.5 / std::abs(layout.lensesPerPixelX());
            tile.x0 = std::max(cuspColumn(layout, before), cuts[i - 1]);
            tile.repeated = cuts[i] - tile.x0;
        }
        tiles.push_back(tile);
    }
    return tiles;
}

std::vector<std::filesystem::path> printFiles(const PrintLayout& layout, const PrintFile& file)
{
    const std::size_t tiles = tileCuts(layout, file.tileWidth).size() - 1;
    if (tiles == 1) return {file.path};
    std::vector<std::filesystem::path> paths;
    for (std::size_t tile = 0; tile < tiles; ++tile) paths.push_back(tilePath(file.path, tile));
    return paths;
}

StagedPrint stagedRaster(const PrintLayout& layout, const RasterSource& source, const PrintFile& file)
{
    const std::vector<PrintTile> tiles = printTiles(layout, file.tileWidth, file.tileOverlap);
    requireRoom(layout, file);
    StagedPrint staged{printFiles(layout, file)};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const PrintTile& tile = tiles[i];
        render::PictureStream stream(staged.pictures[i], specOf(layout, file, tile.x0, tile.x1));
        if (file.bits == 16)
            writeColumns<std::uint16_t>(layout, source.sixteen, file, tile.x0, tile.x1, stream);
        else
            writeColumns<std::uint8_t>(layout, source.eight, file, tile.x0, tile.x1, stream);
        staged.parts.push_back(stream.takePart());
    }
    if (!file.json.empty()) {
        for (const std::filesystem::path& path : staged.pictures)
            staged.parts.push_back(render::stagedFile(path.string() + ".json", file.json));
        if (!file.report.empty()) staged.parts.push_back(render::stagedFile(file.report, file.json));
    }
    return staged;
}

StagedPrint stagedPrint(const PrintLayout& layout, const ViewSet& views, const PrintFile& file)
{
    const Interlacer maker(layout, views);
    return stagedRaster(layout,
                        {[&](const Region& region, std::uint8_t* out) { maker.fill(region, out, file.threads); },
                         [&](const Region& region, std::uint16_t* out) { maker.fill(region, out, file.threads); }},
                        file);
}

StagedPrint stagedChart(const PrintLayout& layout, const Chart& chart, const PrintFile& file)
{
    return stagedRaster(layout,
                        {[&](const Region& region, std::uint8_t* out) { chart.fill(region, out); },
                         [&](const Region& region, std::uint16_t* out) { chart.fill(region, out); }},
                        file);
}

}  // namespace vitrine::printing
