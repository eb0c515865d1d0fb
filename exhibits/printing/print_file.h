#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/interlace.h"
#include "render/image/picture_stream.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Destination and format of a raster.
struct PrintFile {
    std::filesystem::path path{};
    int bits = 8;  ///< 8 or 16.
    render::StreamCompression compression = render::StreamCompression::none;
    double tileWidth = 0;   ///< Millimeters; cut into files of about this width at cusps; 0: one file.
    std::string profile{};  ///< ICC profile of the views.
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

/// Writes the raster in strips. The next one is made while one is written, so memory only grows with the width. With
/// `tileWidth` the files are "name-1.tif", "name-2.tif", ..., from the left.
///
/// All files are published together at the end. "<file>.json" beside each, and the report, repeat the description
/// inside it. Returns the picture files. Throws Failure naming file and cause; then no file is published.
std::vector<std::filesystem::path> writeRaster(const PrintLayout&, const RasterSource&, const PrintFile&);

/// The same for a print of views.
std::vector<std::filesystem::path> writePrint(const PrintLayout&, const ViewSet&, const PrintFile&);

/// The same for a chart.
std::vector<std::filesystem::path> writeChart(const PrintLayout&, const Chart&, const PrintFile&);

/// Returns the columns at which a print is cut: 0, the cusps nearest to multiples of `tileWidth`, the width. Throws
/// Failure (ErrorKind::usage) for lenses that are not vertical, and for tiles narrower than a lens.
[[nodiscard]] std::vector<std::int64_t> tileCuts(const PrintLayout&, double tileWidth);

}  // namespace vitrine::printing
