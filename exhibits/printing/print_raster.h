#pragma once

#include "exhibits/printing/print_layout.h"
#include "render/image/image.h"
#include "render/image/picture_rows.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::printing {

/// Raster of a finished print of any size, from one file or from the tiles into which it was cut. Rows are loaded on
/// demand, and a window of them is kept.
class PrintRaster {
public:
    /// `tiles` are in order from the left and must together have the layout's size. `repeated`: number of first columns
    /// of each that the tile at its left has, too; missing ones are 0. Throws Failure if the size differs.
    PrintRaster(const PrintLayout&, const std::vector<std::filesystem::path>& tiles,
                std::vector<std::int64_t> repeated = {});

    [[nodiscard]] const PrintLayout& layout() const { return layout_; }
    /// Returns `PrintDescription::doubt` of the file with which it was opened.
    [[nodiscard]] const std::string& doubt() const { return doubt_; }
    void setDoubt(std::string doubt) { doubt_ = std::move(doubt); }

    /// Returns the ICC profile of the codes, from the first tile; empty if there is none.
    [[nodiscard]] std::string profile() const { return tiles_.front().profile(); }

    /// Returns 16-bit RGB codes, valid until the next call. Reading rows before the window enlarges it. Throws Failure
    /// if the file is broken.
    [[nodiscard]] const std::uint16_t* row(std::int64_t y);

    /// Returns the whole raster in linear Rec. 709. Throws Failure if it has more than 2^26 pixels.
    [[nodiscard]] render::Image image();

private:
    void load(std::int64_t y);

    PrintLayout layout_;
    std::vector<render::PictureRows> tiles_;
    std::vector<std::int64_t> repeated_;  ///< As many as tiles.
    std::int64_t capacity_ = 0;
    std::int64_t begin_ = 0, end_ = 0;  ///< Range of the rows in memory; row y is at y modulo capacity.
    std::vector<std::uint16_t> rows_;
    std::vector<std::uint16_t> part_;  ///< One row of a tile.
    std::string doubt_;
};

}  // namespace vitrine::printing
