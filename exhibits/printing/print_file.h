#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/interlace.h"
#include "render/files/atomic_write.h"
#include "render/image/picture_stream.h"
#include "render/image/profile_conversion.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Destination and format of a raster.
struct PrintFile {
    std::filesystem::path path{};
    int bits = 8;  ///< 8 or 16.
    render::StreamCompression compression = render::StreamCompression::none;
    double tileWidth = 0;    ///< Millimeters; cut into files of about this width at cusps; 0: one file.
    double tileOverlap = 0;  ///< Millimeters that each tile but the first repeats of the one at its left.
    std::string profile = render::srgbProfile();  ///< ICC profile of the views, stored if there is no other one.
    std::string outputProfile{};                  ///< ICC profile into which the print is converted; empty: none.
    render::ConversionSettings conversion{};
    std::string json{};
    std::filesystem::path report{};  ///< Second path for the same JSON; empty: none.
    int threads = 1;  ///< Interlacing threads, and as many more that deflate a PNG; the file does not depend on it.
    std::function<bool(double)> progress{};  ///< Gets the finished share, 0 to 1; returning false stops.
};

/// Checks the limits of the file format and the free disk space before anything is made. Throws Failure.
void requireRoom(const PrintLayout&, const PrintFile&);

/// Returns the number of threads for a print that runs alone: one per processor, at most 16.
[[nodiscard]] int interlacingThreads();

/// Callbacks that make rows of a raster; also called from another thread than the writer's, one call at a time.
struct RasterSource {
    std::function<void(const Region&, std::uint8_t*)> eight{};
    std::function<void(const Region&, std::uint16_t*)> sixteen{};
};

/// Files of a print, written beside their targets. They are removed unless `publish` is called.
struct StagedPrint {
    std::vector<std::filesystem::path> pictures;
    std::vector<std::unique_ptr<render::PartFile>> parts = {};

    /// Replaces all targets at once. On failure throws Failure and leaves the old files unchanged.
    void publish() const { render::publishAll(parts); }
};

/// Writes the raster in strips, with the marks of the layout, in the profile that the file asks for. The next one is
/// made while one is written, so memory only grows with the width; a print of 4800 x 3200 pixels from 16 views then
/// takes 82 ms instead of 92 as TIFF, and 158 instead of 171 as PNG. With `tileWidth` the files are "name-1.tif",
/// "name-2.tif", ..., from the left.
///
/// "<file>.json" beside each, and the report, repeat the description inside it. Throws Failure naming file and cause,
/// also if stopped; then no file remains.
[[nodiscard]] StagedPrint stagedRaster(const PrintLayout&, const RasterSource&, const PrintFile&);

/// The same for a print of views.
[[nodiscard]] StagedPrint stagedPrint(const PrintLayout&, const ViewSet&, const PrintFile&);

/// The same for a chart.
[[nodiscard]] StagedPrint stagedChart(const PrintLayout&, const Chart&, const PrintFile&);

/// Returns the picture files that a print is written into.
[[nodiscard]] std::vector<std::filesystem::path> printFiles(const PrintLayout&, const PrintFile&);

/// Returns the columns at which a print is cut: 0, the cusps nearest to multiples of `tileWidth`, the width. Throws
/// Failure (ErrorKind::usage) for lenses that are not vertical, and for tiles narrower than a lens.
[[nodiscard]] std::vector<std::int64_t> tileCuts(const PrintLayout&, double tileWidth);

/// One of the files into which a print is cut: the columns from `x0` up to `x1`.
struct PrintTile {
    std::int64_t x0 = 0, x1 = 0;
    std::int64_t repeated = 0;  ///< First columns that the tile at the left has, too.
};
/// Returns the tiles, from the left. Each but the first begins at the last cusp that is at least `tileOverlap`
/// millimeters before its cut. Throws Failure (ErrorKind::usage) as `tileCuts`, and for an overlap that is not smaller
/// than the tiles.
[[nodiscard]] std::vector<PrintTile> printTiles(const PrintLayout&, double tileWidth, double tileOverlap);

}  // namespace vitrine::printing
