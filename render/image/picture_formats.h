#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Supported file formats. All others are refused: Debian's OpenImageIO has its own decoders for them (BMP, GIF, DPX,
/// PSD, ...), which are known to be unsafe. WebP is decoded by libwebp, BMP and GIF by FFmpeg. PDF is only written.
enum class ImageFormat : std::uint8_t { png, jpeg, tiff, exr, hdr, webp, bmp, gif, pdf };

/// `exr` stores 32-bit floats. `exrHalf` stores R, G, B and A as 16-bit floats, other channels as 32-bit. `jpeg` is
/// lossy (quality 92, no chroma subsampling); transparent pictures are blended over white.
enum class PictureFormat : std::uint8_t { png8, png16, exr, exrHalf, tiff8, tiff16, jpeg };

/// Bit depth in which pictures are written.
struct WrittenDepth {
    int bits = 8;  ///< Per channel.
    PictureFormat format{};
};

/// File format of pictures, and what the program does with it. The one place where a format is declared.
struct PictureFileFormat {
    ImageFormat format{};
    std::string_view name;                     ///< For people: "OpenEXR".
    std::vector<std::string_view> extensions;  ///< In lower case, with the dot, the usual one first: ".tif".
    const char* plugin = "";                   ///< OpenImageIO plugin that reads and writes it. Empty: others do.
    std::vector<WrittenDepth> written = {};    ///< The usual depth first. Empty: the format is read only.
    std::string_view mediaType;                ///< "image/png". Empty: web browsers do not read the format.
    bool isLinear = false;                     ///< Holds linear light as floats.
    bool isStreamed = false;                   ///< Written row by row, as prints are (`PictureStream`).
    bool isRead = true;                        ///< Pictures are read from it.
};

/// All formats, in the order in which they are named to people.
[[nodiscard]] const std::vector<PictureFileFormat>& pictureFormats();

/// Returns the declaration of the format.
[[nodiscard]] const PictureFileFormat& fileFormat(ImageFormat);
/// Returns the declaration of the file format to which a `PictureFormat` belongs.
[[nodiscard]] const PictureFileFormat& fileFormat(PictureFormat);
/// Returns the format that a file of this name should have. Null if its name has no extension or an unknown one.
[[nodiscard]] const PictureFileFormat* formatNamed(const std::filesystem::path&);

/// Detects the format from the first bytes of a file.
[[nodiscard]] std::optional<ImageFormat> sniffImage(std::string_view bytes);

/// Returns whether a file begins as a PDF, which is read as a print only (`PictureRows`).
[[nodiscard]] bool isPdf(std::string_view bytes);

/// Returns whether a file of this name may hold `format` (".jpg" and ".jpeg", any case). A name without extension may.
[[nodiscard]] bool extensionAllows(const std::filesystem::path&, ImageFormat);

/// Returns the bits per channel of a written format.
[[nodiscard]] int bitsOf(PictureFormat);

/// Returns the format in which a file of this name is written, with this number of bits if given. Nothing if there is
/// none.
[[nodiscard]] std::optional<PictureFormat> writtenFormat(const std::filesystem::path&,
                                                         std::optional<int> bits = std::nullopt);

/// Usual extensions of the formats that are written at a depth, or at any: "png", "jpg".
[[nodiscard]] std::vector<std::string_view> writtenEndings(std::optional<int> bits = std::nullopt);
/// Returns the same extensions as a text for people: ".png, .jpg, .tif or .exr".
[[nodiscard]] std::string writtenExtensions(std::optional<int> bits = std::nullopt);
/// Returns the extensions of streamed formats as a text for people: ".png or .tif".
[[nodiscard]] std::string streamedExtensions();
/// Returns all extensions of streamed formats in the form of `ParameterInfo::extensions`: "png tif tiff pdf".
[[nodiscard]] std::string_view streamedEndings();
/// Returns all extensions of written formats, which carry settings, in the form of `ParameterInfo::extensions`.
[[nodiscard]] std::string_view settingsEndings();
/// Returns all extensions of readable formats in the form of `ParameterInfo::extensions`: "png jpg jpeg tif".
[[nodiscard]] std::string_view readEndings();
/// Returns the names of all readable formats as a text for people: "PNG, JPEG, TIFF or OpenEXR".
[[nodiscard]] const std::string& readFormats();

}  // namespace vitrine::render
