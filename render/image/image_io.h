#pragma once

#include "render/files/file_ops.h"
#include "render/image/image.h"
#include "render/image/image_limits.h"
#include "render/image/picture_formats.h"
#include "render/image/texture.h"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::render {

class PartFile;

struct ReadOptions {
    ImageLimits limits{};
    bool raw = false;  ///< Keep stored values: no sRGB decoding, codes divided by 255 or 65535.
    /// Decode as sRGB and ignore the file's profile, if the result is to carry that profile on.
    bool keepColors = false;
    std::function<bool()> canceled{};  ///< Polled between rows, on the calling thread; true stops with a Failure.
};

/// Reads PNG, JPEG, TIFF, OpenEXR, Radiance HDR, WebP, BMP or GIF. The first bytes decide which; the name's extension
/// must agree.
///
/// 8-bit and 16-bit pictures are taken as sRGB-encoded and returned linear (alpha unchanged); float pictures are linear
/// already. The file's color data (ICC profile, PNG's gAMA and cHRM, OpenEXR's chromaticities) and its orientation, row
/// order and display window are applied. The result has 1 to 4 channels, for OpenEXR up to 16 with `channelNames`.
/// Alpha is returned not premultiplied.
///
/// In color channels NaN becomes 0 and infinities ±65504; in other channels NaN becomes 0. The number of such samples
/// is one of the `warnings` (may be null), which are full sentences. Throws Failure naming the file if it is none of
/// these formats, too large (before anything is allocated), broken, or canceled.
[[nodiscard]] Image readImage(const std::filesystem::path&, const ReadOptions& = {},
                              std::vector<std::string>* warnings = nullptr);

/// The same for the color channels alone: gray, gray and alpha, RGB or RGBA, without names. In an OpenEXR file with
/// layers or views, `colorChannels` chooses one. Throws also if a file has no color, and names its channels.
[[nodiscard]] Image readColor(const std::filesystem::path&, const ReadOptions& = {},
                              std::vector<std::string>* warnings = nullptr);

/// Camera of a picture as OpenEXR stores it ("Standard Attributes"): matrices for row vectors, row by row. Camera space
/// is left-handed: x to the right, y up, z along the view. The picture spans 0 to 1, from its upper left corner.
struct ExrCamera {
    std::array<float, 16> worldToCamera{}, worldToNdc{};
};

struct PictureMetadata {
    std::string preset{};               ///< JSON text that restores the settings of the picture; empty: none.
    std::string description{};          ///< Text for people; empty: none.
    double pixelsPerInch = 0;           ///< Resolution of a print; 0: none.
    std::optional<ExrCamera> camera{};  ///< Only OpenEXR stores it.
    std::vector<std::pair<std::string, std::string>> texts{};  ///< Further attributes of an OpenEXR file.
};

/// Writes a picture of linear light. Afterwards the file is either complete and verified, or does not exist: it checks
/// for enough free space, writes beside the target, reads back and compares, syncs, renames.
///
/// PNG and TIFF take 1 to 4 channels, sRGB-encoded and rounded to the nearest code (alpha linear, NaN 0); alpha is not
/// premultiplied. OpenEXR takes up to 32 channels, named by `channelNames` (by default Y, YA, RGB or RGBA), with color
/// premultiplied by A as the format demands, the chromaticities of Rec. 709 and the name of this program.
///
/// The preset goes into an iTXt chunk or attribute "vitrine:preset", in TIFF into ImageDescription, in JPEG into the
/// comment. A JPEG comment holds 65,532 bytes; a longer preset is a Failure. `ops` is used for all formats that do not
/// need OpenImageIO. Throws Failure naming file and cause; the old file is then unchanged.
void writePicture(const std::filesystem::path&, const Image&, PictureFormat, const PictureMetadata& = {},
                  FileOps& ops = systemFileOps());

/// The same, except that the file does not yet replace the target. For pictures that are published together with other
/// files (`publishAll`).
[[nodiscard]] std::unique_ptr<PartFile> stagedPicture(const std::filesystem::path&, const Image&, PictureFormat,
                                                      const PictureMetadata& = {}, FileOps& ops = systemFileOps());

/// Returns the bytes of the PNG (`png8` or `png16`) that `writePicture` would write; writes nothing. Throws as
/// `writePicture` does.
[[nodiscard]] std::string encodedPicture(const std::filesystem::path&, const Image&, PictureFormat,
                                         const PictureMetadata& = {});

/// Returns the preset text inside a PNG, OpenEXR, TIFF or JPEG file that `writePicture` wrote (or any with that chunk),
/// or that of the views of a lenticular print. Returns nothing if there is none. The text is untrusted. Throws Failure
/// if the file cannot be read.
[[nodiscard]] std::optional<std::string> embeddedPreset(const std::filesystem::path&);

/// Returns the description inside a PNG or OpenEXR file that `writePicture` wrote; empty if there is none. Throws
/// Failure if the file cannot be read.
[[nodiscard]] std::string embeddedDescription(const std::filesystem::path&);

/// Returns the preset text in a picture's description: the description itself, or the scene in the settings document of
/// a job. Returns nothing if another program wrote the text.
[[nodiscard]] std::optional<std::string> settingsInDescription(const std::string&);

/// Reads a picture as a texture: 8-bit values for 8-bit files (then `sRgb` says that they are sRGB-encoded), floats for
/// all others (16-bit files are decoded if `sRgb`). It has 3 or 4 channels, or 1 if it is no color (not `sRgb`). A
/// sampled value of 1 channel is gray, (x, x, x, 1). Row 0 is the visible top and texture coordinate v = 0, as in glTF.
/// Color (`sRgb`) is handled as by `readColor`; for OpenEXR only the color channels are read. PNG files are read
/// without OpenImageIO. `warnings` and Failure are those of `readColor`.
[[nodiscard]] std::shared_ptr<const Texture> loadTexture(const std::filesystem::path&, bool sRgb, bool repeat,
                                                         const ImageLimits& = {},
                                                         std::vector<std::string>* warnings = nullptr);

/// Options for making a texture from a file's bytes.
struct TextureOptions {
    bool sRgb = true;
    bool repeat = true;
    bool mipmaps = true;
    /// Applies orientation and color space of the file. False for glTF: its specification (2.0, 5.19) demands that
    /// color spaces of its pictures are ignored, and its texture coordinates count rows and columns as stored.
    bool obeysFile = true;
};

/// The same from the bytes of a PNG or JPEG file, as glTF embeds them; `name` is for messages.
[[nodiscard]] std::shared_ptr<Texture> textureFromBytes(std::string_view bytes, const std::string& name,
                                                        const TextureOptions&, const ImageLimits& = {});

}  // namespace vitrine::render
