#pragma once

#include "render/image/oiio_codec.h"
#include "render/image/png_row_reader.h"
#include "render/image/profile_conversion.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

/// Reader of a PNG or TIFF, or of a PDF that `PictureStream` wrote, of any size, a few rows at a time; memory does not
/// grow with the picture.
class PictureRows {
public:
    /// Throws Failure naming the file if it cannot be opened, or is none of these.
    explicit PictureRows(const std::filesystem::path&);

    [[nodiscard]] std::int64_t width() const { return width_; }
    [[nodiscard]] std::int64_t height() const { return height_; }
    /// Description of the print that `PictureStream` wrote; empty if there is none. The text is untrusted.
    [[nodiscard]] const std::string& json() const { return json_; }

    /// ICC profile of its codes; empty: none. Inks are converted to sRGB when they are read.
    [[nodiscard]] std::string profile() const
    {
        return png_ ? png_->profile() : inks_ ? std::string() : tiff_->profile;
    }

    /// Reads `count` rows from row `first` on as 16-bit RGB codes (8-bit ones times 257); `out` holds width * count *
    /// 3. Rows in rising order are fast; going back restarts at the top. Throws Failure naming the file if it is
    /// broken.
    void read(std::int64_t first, std::int64_t count, std::uint16_t* out);

private:
    void beginInks();
    void readRow(std::int64_t row, std::uint16_t* out);
    void check(const std::string& why) const;

    std::filesystem::path path_;
    std::unique_ptr<PngRowReader> png_;
    std::unique_ptr<OiioRowReader> tiff_;    ///< TIFF or PDF.
    std::optional<ProfileConversion> inks_;  ///< From the inks of a TIFF to sRGB.
    std::vector<char> converted_;            ///< One row of it.
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    int bits_ = 8;
    std::size_t channels_ = 3;
    std::string json_;
    std::vector<char> stored_;  ///< One row as stored in the file.
    std::int64_t next_ = 0;     ///< PNG: the next row to be read.
};

}  // namespace vitrine::render
