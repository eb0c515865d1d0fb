#pragma once

#include "render/image/image_limits.h"
#include "render/image/stored_picture.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::render {

/// How a file is written by OpenImageIO.
struct OiioTarget {
    std::string path;
    ImageFormat format = ImageFormat::exr;                   ///< exr, tiff or jpeg.
    bool halfColor = false;                                  ///< EXR: R, G, B and A as 16-bit float.
    std::vector<std::pair<std::string, std::string>> texts;  ///< Attributes.
    double pixelsPerInch = 0;                                ///< 0: not said.
};

/// A TIFF that is written a few rows at a time: RGB, 8 or 16 bits, sRGB-encoded.
struct OiioRowTarget {
    std::string path;
    int width = 0;
    int height = 0;
    int bits = 8;
    std::string compression = "none";  ///< "none" or "zip".
    double dpiX = 0, dpiY = 0;         ///< Stored as rational numbers of dots per inch.
    std::string description{};         ///< ASCII, for ImageDescription.
    std::string profile{};             ///< ICC profile; none when empty.
};

/// The rows of an open file. Each function returns a half sentence on what went wrong, empty when nothing did.
class OiioRows {
public:
    virtual ~OiioRows() = default;
    /// `rows` are `count` whole rows from row `first`; they come in order.
    [[nodiscard]] virtual std::string write(const void* rows, int first, int count) noexcept = 0;
    [[nodiscard]] virtual std::string close() noexcept = 0;
};

/// An open TIFF that is read by rows, 8 or 16 bits.
class OiioRowReader {
public:
    virtual ~OiioRowReader() = default;
    /// Whole rows without padding, in any order; those after the last ones read come fastest. Returns a half
    /// sentence on what went wrong, empty when nothing did.
    [[nodiscard]] virtual std::string read(int first, int count, void* rows) noexcept = 0;

    int width = 0, height = 0, channels = 0, bits = 8;
    std::string description{};
    int orientation = 1;    ///< 1 to 8, as `orient` takes it.
    std::string profile{};  ///< ICC profile; empty when there is none.
};

/// How a picture is unpacked.
struct DecodeRequest {
    ImageLimits limits{};
    /// Only the channels that carry color (`colorChannels`), of the first part of an OpenEXR file that has any, in the
    /// order gray or red, green, blue, then alpha. Otherwise all channels of the first part; those of the color have
    /// their plain names ("R"), whatever their layer.
    bool colorOnly = false;
    std::function<bool()> canceled{};  ///< Asked between bands of rows.
};

/// A row that was written, to compare with what the file says.
struct WrittenRow {
    int row = 0;
    std::string bytes{};
};

/// What the OpenImageIO module does for the rest. Linking OpenImageIO loads 261 libraries and costs
/// 131 MB and 0.17 s, so it lives in a library of its own that is opened when the first picture asks.
///
/// No exception crosses this border: every function returns what went wrong as a half sentence, empty
/// when nothing did.
class OiioCodec {
public:
    virtual ~OiioCodec() = default;

    /// Unpacks the bytes of a file with the reader of that format and no other. 8-bit and 16-bit samples
    /// keep their codes, everything else becomes float; alpha is not multiplied in, except in EXR files.
    /// OpenEXR: the display window, black and transparent where there is no data.
    [[nodiscard]] virtual std::string decode(std::string_view bytes, ImageFormat, const DecodeRequest&,
                                             StoredPicture& out) noexcept = 0;

    /// Writes the file, opens it again and compares rows spread over the whole picture (JPEG loosely). Leaves a broken
    /// file behind when it fails: the caller removes it.
    [[nodiscard]] virtual std::string write(const StoredPicture&, const OiioTarget&) noexcept = 0;

    /// Creates a TIFF to be written by rows; BigTIFF when its pixels take more than 4000 MiB.
    [[nodiscard]] virtual std::string openRows(const OiioRowTarget&, std::unique_ptr<OiioRows>& out) noexcept = 0;

    /// Opens a file that `openRows` made and compares size, resolution and some rows.
    [[nodiscard]] virtual std::string checkRows(const OiioRowTarget&, const std::vector<WrittenRow>&) noexcept = 0;

    /// The ICC profile in a file; empty when there is none.
    [[nodiscard]] virtual std::string readProfile(std::string_view bytes, ImageFormat, std::string& out) noexcept = 0;

    /// The text attribute `key` of a file; empty when there is none.
    [[nodiscard]] virtual std::string readText(std::string_view bytes, ImageFormat, const std::string& key,
                                               std::string& out) noexcept = 0;

    /// Opens a TIFF of any size, to read it by rows.
    [[nodiscard]] virtual std::string openRowReader(const std::string& path,
                                                    std::unique_ptr<OiioRowReader>& out) noexcept = 0;

    /// "2.4.7.1", of the OpenImageIO that runs.
    [[nodiscard]] virtual const char* libraryVersion() const noexcept = 0;
};

/// The codec; opens the module on the first call, from any thread. The module `vitrine_oiio` is looked for
/// beside the running program, one folder up, in ../lib/vitrine/modules, and where it was built.
/// Throws Failure when it cannot be opened.
[[nodiscard]] OiioCodec& oiioCodec();

/// Whether the module is open already (so that tests can tell that a start does not pay for it).
[[nodiscard]] bool oiioCodecIsOpen();

}  // namespace vitrine::render

/// The one symbol of the module. `version` must be `vitrineOiioVersion`; otherwise the answer is null.
inline constexpr int vitrineOiioVersion = 4;
extern "C" vitrine::render::OiioCodec* vitrineOiio(int version);
