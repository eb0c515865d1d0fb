#pragma once

#include "exhibits/printing/print_layout.h"
#include "render/files/strict_json.h"
#include "render/image/image.h"
#include "render/image/picture_rows.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vitrine::printing {

/// The raster of a finished print, whatever its size, from one file or from the tiles it was cut into. Rows come
/// into memory as they are asked for, and a window of them stays.
class PrintRaster {
public:
    /// `tiles` from left to right; together they must have the layout's size. Throws Failure when they do not.
    PrintRaster(const PrintLayout&, const std::vector<std::filesystem::path>& tiles);

    [[nodiscard]] const PrintLayout& layout() const { return layout_; }
    /// `PrintDescription::doubt` of the file that it was opened by.
    [[nodiscard]] const std::string& doubt() const { return doubt_; }
    void setDoubt(std::string doubt) { doubt_ = std::move(doubt); }

    /// The ICC profile of the codes, of the first tile; empty when there is none.
    [[nodiscard]] std::string profile() const { return tiles_.front().profile(); }

    /// RGB codes of 16 bits; valid until the next call. Going back further than the window makes it larger.
    /// Throws Failure when the file is broken.
    [[nodiscard]] const std::uint16_t* row(std::int64_t y);

    /// All of it, in linear Rec. 709. Throws Failure when it has more than 2^26 pixels.
    [[nodiscard]] render::Image image();

private:
    void load(std::int64_t y);

    PrintLayout layout_;
    std::vector<render::PictureRows> tiles_;
    std::int64_t capacity_ = 0;
    std::int64_t begin_ = 0, end_ = 0;  ///< Of the rows in memory; row y lies at y modulo capacity.
    std::vector<std::uint16_t> rows_;
    std::vector<std::uint16_t> part_;  ///< A tile's row.
    std::string doubt_;
};

/// Description of a print, and what speaks against it.
struct PrintDescription {
    render::JsonDocument document;
    /// A full sentence or two where the file beside the print describes another one; empty where it does not.
    std::string doubt{};
};

/// The description inside a print, which was written with its pixels. The file beside it says the same; it counts where
/// the print has lost its own. Throws Failure naming the file when there is neither.
[[nodiscard]] PrintDescription printDescription(const std::filesystem::path&);

/// Opens a print that `writePrint` made: TIFF or PNG, its description inside or beside it. Of a print in tiles, any
/// one of them or the name without number may be given. Throws Failure naming the file.
[[nodiscard]] PrintRaster readPrint(const std::filesystem::path&);

}  // namespace vitrine::printing
