#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/interlace.h"
#include "render/image/picture_stream.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Where and how a raster is written.
struct PrintFile {
    std::filesystem::path path{};
    int bits = 8;  ///< 8 or 16.
    render::StreamCompression compression = render::StreamCompression::none;
    double tileWidth = 0;   ///< In millimeters: cut into files of about this width at cusps; 0: one file.
    std::string profile{};  ///< ICC profile of the views.
    std::string json{};
    std::filesystem::path report{};  ///< Another place for the same JSON; empty: none.
    int threads = 1;  ///< That interlace, and as many more that deflate a PNG; the file is the same for any number.
    std::function<bool(double)> progress{};  ///< Told the part that is done, 0 to 1; false stops.
};

/// Refuses a print whose files the format or the disk cannot hold, before anything is made. Throws Failure.
void requireRoom(const PrintLayout&, const PrintFile&);

/// How many threads a print of its own is given: one per processor, at most 16.
[[nodiscard]] int interlacingThreads();

/// Makes rows of a raster; called from another thread than the writer's, one call at a time.
struct RasterSource {
    std::function<void(const Region&, std::uint8_t*)> eight{};
    std::function<void(const Region&, std::uint16_t*)> sixteen{};
};

/// Writes the raster in strips, the next one made while one is written, so that memory grows with its width
/// only. With `tileWidth` the files are "name-1.tif", "name-2.tif", ..., from the left; all are put in place
/// together at the end, with "<file>.json" beside each, which is the description inside it, and the report. Returns
/// the picture files. Throws Failure naming file and cause; then none is put in place.
std::vector<std::filesystem::path> writeRaster(const PrintLayout&, const RasterSource&, const PrintFile&);

/// The same for the views' print.
std::vector<std::filesystem::path> writePrint(const PrintLayout&, const ViewSet&, const PrintFile&);

/// The same for a chart.
std::vector<std::filesystem::path> writeChart(const PrintLayout&, const Chart&, const PrintFile&);

/// The columns at which a print is cut: 0, the cusps nearest to multiples of `tileWidth`, the width. Throws
/// Failure (Blame::usage) for lenses that are not vertical, or tiles narrower than a lens.
[[nodiscard]] std::vector<std::int64_t> tileCuts(const PrintLayout&, double tileWidth);

}  // namespace vitrine::printing
