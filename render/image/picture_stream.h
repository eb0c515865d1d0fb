#pragma once

#include "render/files/atomic_write.h"
#include "render/image/oiio_codec.h"
#include "render/image/png_rows.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

enum class StreamCompression : std::uint8_t { none, deflate };

/// Keyword of the PNG text chunk that describes how a print was made.
inline constexpr const char* printKey = "vitrine:print";

/// Options of a picture too large for memory: codes of RGB or of inks, 8 or 16 bits.
struct StreamSpec {
    std::int64_t width = 0;
    std::int64_t height = 0;
    int bits = 8;
    int channels = 3;  ///< 3 for RGB; 4 for CMYK, which PNG cannot hold.
    double dpiX = 0, dpiY = 0;
    StreamCompression compression = StreamCompression::none;  ///< TIFF only; PNG and PDF are always deflated.
    bool likeRowAbove = true;  ///< Rows resemble the one above (a hint for PNG's filter).
    /// Description of how it was made: TIFF's ImageDescription, PNG's text "vitrine:print", a file attached to a PDF.
    std::string json{};
    std::string profile{};  ///< ICC profile; empty: none. A PDF must have one.
    int threads = 1;        ///< Number of threads that deflate a PNG; the file does not depend on it.
    /// Boxes of a PDF's page in pixels from the top left corner: left, top, right, bottom. Unset: the whole page.
    std::optional<std::array<double, 4>> trim{}, bleed{};
};

/// Sides and samples of a picture that is to be written row by row.
struct StreamShape {
    std::int64_t width = 0, height = 0;
    int channels = 3;  ///< As in `StreamSpec`.
    int bits = 8;
};

/// Checks that the format of the name's extension allows this shape. Throws Failure (ErrorKind::usage) with the limit.
void requireStream(const std::filesystem::path&, const StreamShape&);
/// Returns the free space that such a file needs, in bytes: all of an uncompressed TIFF, a quarter of that if
/// compressed.
[[nodiscard]] std::uint64_t streamBytes(const std::filesystem::path&, const StreamSpec&);

/// Writes a TIFF (BigTIFF above 4000 MiB), PNG or PDF row by row, beside its target; memory does not grow with the
/// picture. If anything fails, or it is destroyed before `publish`, the old file is unchanged and no temporary file
/// remains. Every function throws Failure naming file and cause.
class PictureStream {
public:
    /// The name's extension decides the format. Checks for enough free space (`streamBytes`).
    PictureStream(const std::filesystem::path&, const StreamSpec&, FileOps& = systemFileOps());

    /// Writes the next `count` rows, without padding, in the machine's byte order.
    void write(const void* rows, std::int64_t count);
    /// Closes the file after the last row. A TIFF is opened again and compared.
    void finish();
    /// Hands over the finished file, to be published by the caller.
    [[nodiscard]] std::unique_ptr<PartFile> takePart() { return std::move(part_); }
    /// Replaces the target by the finished file.
    void publish() { part_->publish(); }

private:
    [[noreturn]] void refuse(const std::string& why) const;

    std::filesystem::path path_;
    StreamSpec spec_;
    std::unique_ptr<PartFile> part_;
    OiioRowTarget tiff_;
    std::unique_ptr<OiioRows> tiffRows_;  ///< Rows of a TIFF or PDF.
    std::unique_ptr<PngRows> pngRows_;
    std::vector<WrittenRow> kept_;  ///< Rows for the comparison.
    std::int64_t done_ = 0;
};

/// Returns the resolution as a file of this name stores it: TIFF has 24 bits, PNG whole dots per meter. PDF stores
/// lengths instead.
[[nodiscard]] double storedDpi(const std::filesystem::path&, double dpi);

/// Returns the JSON that a stream wrote into a file of any size, or nothing. The text is untrusted.
[[nodiscard]] std::optional<std::string> embeddedPrint(const std::filesystem::path&);

/// Returns the ICC profile of a picture file; empty if there is none.
[[nodiscard]] std::string embeddedProfile(const std::filesystem::path&);

}  // namespace vitrine::render
