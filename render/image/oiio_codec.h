#pragma once

#include "render/image/image_limits.h"
#include "render/image/stored_picture.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::render {

/// Path, format and options of a file that OpenImageIO writes.
struct OiioTarget {
    std::string path;
    ImageFormat format = ImageFormat::exr;                   ///< exr, tiff or jpeg.
    bool halfColor = false;                                  ///< EXR: R, G, B and A as 16-bit float.
    std::vector<std::pair<std::string, std::string>> texts;  ///< Attributes.
    /// Attributes of an EXR that are matrices of 4 x 4, row by row.
    std::vector<std::pair<std::string, std::array<float, 16>>> matrices;
    double pixelsPerInch = 0;  ///< 0: not stored.
};

/// Options of a TIFF or PDF that is written a few rows at a time: codes of RGB or of inks, 8 or 16 bits.
struct OiioRowTarget {
    std::string path;
    int width = 0;
    int height = 0;
    int bits = 8;
    int channels = 3;                  ///< 3 for RGB, 4 for CMYK, whose codes are 0 for no ink.
    std::string compression = "none";  ///< TIFF: "none" or "zip".
    double dpiX = 0, dpiY = 0;         ///< Stored as rational numbers of dots per inch.
    std::string description{};         ///< ASCII, for ImageDescription, or the JSON attached to a PDF.
    std::string profile{};             ///< ICC profile; empty: none. A PDF must have one.
    /// Boxes of a PDF's page in pixels from the top left corner: left, top, right, bottom. Unset: the whole page.
    std::optional<std::array<double, 4>> trim{}, bleed{};
};

/// Writer of an open file. Each function returns a half sentence that says what went wrong; empty: success.
class OiioRows {
public:
    virtual ~OiioRows() = default;
    /// Writes `count` whole rows from row `first` on. Rows must come in order.
    [[nodiscard]] virtual std::string write(const void* rows, int first, int count) noexcept = 0;
    [[nodiscard]] virtual std::string close() noexcept = 0;
};

/// An open TIFF or PDF that is read by rows, 8 or 16 bits.
class OiioRowReader {
public:
    virtual ~OiioRowReader() = default;
    /// Reads whole rows, without padding, in any order; rows that follow the last ones read are fastest. Returns a half
    /// sentence that says what went wrong; empty: success.
    [[nodiscard]] virtual std::string read(int first, int count, void* rows) noexcept = 0;

    int width = 0, height = 0, channels = 0, bits = 8;
    bool isInks = false;  ///< The channels are cyan, magenta, yellow and black.
    std::string description{};
    int orientation = 1;    ///< 1 to 8, see `orient`.
    std::string profile{};  ///< ICC profile; empty: none.
};

/// Options for decoding a picture.
struct DecodeRequest {
    ImageLimits limits{};
    /// True: reads only the color channels (`colorChannels`) of the first part of an OpenEXR file that has any, in the
    /// order gray or red, green, blue, then alpha. False: reads all channels of the first part; color channels get
    /// their plain names ("R"), whatever their layer.
    bool colorOnly = false;
    std::function<bool()> canceled{};  ///< Polled between bands of rows.
};

/// A row that was written, kept for comparison with the file.
struct WrittenRow {
    int row = 0;
    std::string bytes{};
};

/// Interface of the OpenImageIO module. Linking OpenImageIO loads 261 libraries and costs 131 MB and 0.17 s. So it is
/// in a library of its own, which is opened on first use.
///
/// No exception crosses this interface: every function returns a half sentence that says what went wrong; empty:
/// success.
class OiioCodec {
public:
    virtual ~OiioCodec() = default;

    /// Decodes the bytes of a file with the reader of that format only. 8-bit and 16-bit samples keep their codes, all
    /// others become floats. Alpha is not premultiplied, except in EXR files. For OpenEXR the result covers the display
    /// window, black and transparent where there is no data.
    [[nodiscard]] virtual std::string decode(std::string_view bytes, ImageFormat, const DecodeRequest&,
                                             StoredPicture& out) noexcept = 0;

    /// Writes the file, opens it again and compares rows spread over the whole picture (JPEG within a tolerance). On
    /// failure it leaves a broken file, which the caller must remove.
    [[nodiscard]] virtual std::string write(const StoredPicture&, const OiioTarget&) noexcept = 0;

    /// Creates a TIFF to be written by rows; a BigTIFF if its pixels take more than 4000 MiB.
    [[nodiscard]] virtual std::string openRows(const OiioRowTarget&, std::unique_ptr<OiioRows>& out) noexcept = 0;

    /// Creates a PDF of one page, with the picture at its exact size, to be written by rows. The description is
    /// attached as a file, and the profile is the page's output intent too (ISO 32000, 14.11.5).
    [[nodiscard]] virtual std::string openPdfRows(const OiioRowTarget&, std::unique_ptr<OiioRows>& out) noexcept = 0;

    /// Opens a TIFF written by `openRows` and compares size, resolution and some rows.
    [[nodiscard]] virtual std::string checkRows(const OiioRowTarget&, const std::vector<WrittenRow>&) noexcept = 0;

    /// Reads the ICC profile of a file; empty if there is none.
    [[nodiscard]] virtual std::string readProfile(std::string_view bytes, ImageFormat, std::string& out) noexcept = 0;

    /// Reads the text attribute `key` of a file; empty if there is none.
    [[nodiscard]] virtual std::string readText(std::string_view bytes, ImageFormat, const std::string& key,
                                               std::string& out) noexcept = 0;

    /// Opens a TIFF of any size, to read it by rows.
    [[nodiscard]] virtual std::string openRowReader(const std::string& path,
                                                    std::unique_ptr<OiioRowReader>& out) noexcept = 0;

    /// Opens a PDF of any size that `openPdfRows` wrote, to read it by rows. The description is that of the attached
    /// file. Other PDFs are refused.
    [[nodiscard]] virtual std::string openPdfReader(const std::string& path,
                                                    std::unique_ptr<OiioRowReader>& out) noexcept = 0;

    /// Version of the loaded OpenImageIO: "2.4.7.1".
    [[nodiscard]] virtual const char* libraryVersion() const noexcept = 0;
};

/// Returns the codec; opens the module on the first call. Thread-safe. It searches the module `vitrine_oiio` beside the
/// executable, one folder up, in ../lib/vitrine/modules, and where it was built. Throws Failure if it cannot be opened.
[[nodiscard]] OiioCodec& oiioCodec();

/// Returns whether the module is open already. Tests check with it that the start does not load it.
[[nodiscard]] bool oiioCodecIsOpen();

}  // namespace vitrine::render

/// The module's only exported symbol. Returns null unless `version` is `vitrineOiioVersion`.
inline constexpr int vitrineOiioVersion = 7;
extern "C" vitrine::render::OiioCodec* vitrineOiio(int version);
