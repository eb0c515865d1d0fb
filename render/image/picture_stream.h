#pragma once

#include "render/files/atomic_write.h"
#include "render/image/oiio_codec.h"
#include "render/image/png_rows.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

enum class StreamCompression : std::uint8_t { none, deflate };

/// The chunk of a PNG that says how a print was made.
inline constexpr const char* printKey = "vitrine:print";

/// A picture too large for memory: RGB, sRGB-encoded, 8 or 16 bits.
struct StreamSpec {
    std::int64_t width = 0;
    std::int64_t height = 0;
    int bits = 8;
    double dpiX = 0, dpiY = 0;
    StreamCompression compression = StreamCompression::none;  ///< Of TIFF; PNG is always deflated.
    bool likeRowAbove = true;  ///< Rows resemble the one above (a hint for PNG's filter).
    std::string json{};        ///< What made it: TIFF's ImageDescription, PNG's text "vitrine:print".
    std::string profile{};     ///< ICC profile; none when empty.
    int threads = 1;           ///< That deflate a PNG; the file is the same for any number.
};

/// Refuses sides beyond the format that the name's ending means. Throws Failure (Blame::usage) with the limit.
void requireStreamSides(const std::filesystem::path&, std::int64_t width, std::int64_t height);
/// Bytes that must be free for such a file: all of an uncompressed TIFF, a quarter of what is packed.
[[nodiscard]] std::uint64_t streamBytes(const std::filesystem::path&, const StreamSpec&);

/// Writes a TIFF (BigTIFF by itself beyond 4000 MiB) or PNG row by row, beside its target; memory does not
/// grow with the picture. Whatever fails, or when it is destroyed before `publish`, the old file stands and
/// nothing is left behind. Every function throws Failure naming file and cause.
class PictureStream {
public:
    /// The name's ending decides the format. Asks for enough free space (all of an uncompressed TIFF).
    PictureStream(const std::filesystem::path&, const StreamSpec&, FileOps& = systemFileOps());

    /// The next `count` rows, without padding, in the machine's byte order.
    void write(const void* rows, std::int64_t count);
    /// After the last row: closes the file; a TIFF is opened again and compared.
    void finish();
    /// The finished file, to be published.
    [[nodiscard]] std::unique_ptr<PartFile> takePart() { return std::move(part_); }
    /// Puts the finished file in the target's place.
    void publish() { part_->publish(); }

private:
    [[noreturn]] void refuse(const std::string& why) const;

    std::filesystem::path path_;
    StreamSpec spec_;
    std::unique_ptr<PartFile> part_;
    OiioRowTarget tiff_;
    std::unique_ptr<OiioRows> tiffRows_;
    std::unique_ptr<PngRows> pngRows_;
    std::vector<WrittenRow> kept_;  ///< To compare with.
    std::int64_t done_ = 0;
};

/// The resolution that a file of this name will say: TIFF has 24 bits of it, PNG whole dots per meter.
[[nodiscard]] double storedDpi(const std::filesystem::path&, double dpi);

/// The JSON that a stream wrote into a TIFF or PNG of any size, or nothing. It is text from a file: parse it as
/// untrusted.
[[nodiscard]] std::optional<std::string> embeddedPrint(const std::filesystem::path&);

/// The ICC profile in a picture file; empty when there is none.
[[nodiscard]] std::string embeddedProfile(const std::filesystem::path&);

}  // namespace vitrine::render
