#pragma once

#include "render/files/file_ops.h"
#include "render/image/image.h"
#include "render/image/image_limits.h"
#include "render/scene/mesh.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

class PartFile;

struct ReadOptions {
    ImageLimits limits{};
    bool raw = false;                  ///< Keep stored values: no sRGB decoding, codes divided by 255 or 65535.
    bool keepColors = false;           ///< Decode as sRGB whatever the file says: for files that carry its profile on.
    std::function<bool()> canceled{};  ///< Asked between rows, from the calling thread; true stops with a Failure.
};

/// Reads PNG, JPEG, TIFF, OpenEXR, Radiance HDR, WebP, BMP or GIF; the first bytes decide which, and must agree with
/// the name's extension. 8-bit and 16-bit pictures are taken as sRGB-encoded and returned linear (alpha as it is);
/// float pictures are linear already. What the file says about its colors (ICC profile, PNG's gAMA and cHRM, OpenEXR's
/// chromaticities) and about how it is to be shown (orientation, order of rows, display window) is obeyed. 1 to 4
/// channels, for OpenEXR up to 16 with `channelNames`. Alpha is returned not premultiplied. In color channels NaN
/// becomes 0 and infinities ±65504; in other channels NaN becomes 0; the count is one of the `warnings` (may be null),
/// which are full sentences. Throws Failure naming the file when it is none of these, too large (before anything is
/// allocated), broken, or canceled.
[[nodiscard]] Image readImage(const std::filesystem::path&, const ReadOptions& = {},
                              std::vector<std::string>* warnings = nullptr);

/// The same, of the color alone: gray, gray and alpha, RGB or RGBA, without names. Of an OpenEXR file with layers or
/// views, the one that `colorChannels` chooses. Throws also where a file has no color, and names its channels.
[[nodiscard]] Image readColor(const std::filesystem::path&, const ReadOptions& = {},
                              std::vector<std::string>* warnings = nullptr);

/// `exr` stores 32-bit floats; `exrHalf` stores R, G, B and A as 16-bit floats, other channels as 32-bit. `jpeg` is
/// lossy (quality 92, colors at full resolution) and over white where the picture is transparent.
enum class PictureFormat : std::uint8_t { png8, png16, exr, exrHalf, tiff8, tiff16, jpeg };

struct PictureMetadata {
    std::string preset{};       ///< JSON text that restores what is seen; none when empty.
    std::string description{};  ///< For people; none when empty.
    double pixelsPerInch = 0;   ///< Of a print; none when 0.
};

/// Writes a picture of linear light so that the file is either complete and checked or not there:
/// asks for enough free space, writes beside the target, reads back and compares, syncs, renames.
/// PNG and TIFF take 1 to 4 channels, sRGB-encoded and rounded to the nearest code (alpha linear, NaN 0),
/// alpha not premultiplied; OpenEXR takes up to 16 channels, named by `channelNames` (by default Y, YA, RGB
/// or RGBA), with color multiplied by A as the format demands. The preset goes into an iTXt chunk or
/// attribute "vitrine:preset", in TIFF into ImageDescription, in JPEG into the comment, which holds 65,533 bytes:
/// Failure where it is longer. `ops` is used where no OpenImageIO is. Throws Failure naming file and cause; the old
/// file then stands.
void writePicture(const std::filesystem::path&, const Image&, PictureFormat, const PictureMetadata& = {},
                  FileOps& ops = systemFileOps());

/// The same, but for its taking the target's place: for pictures that are published with other files (`publishAll`).
[[nodiscard]] std::unique_ptr<PartFile> stagedPicture(const std::filesystem::path&, const Image&, PictureFormat,
                                                      const PictureMetadata& = {}, FileOps& ops = systemFileOps());

/// The bytes of the PNG (`png8` or `png16`) that `writePicture` writes under that name; nothing is written. Throws as
/// it does.
[[nodiscard]] std::string encodedPicture(const std::filesystem::path&, const Image&, PictureFormat,
                                         const PictureMetadata& = {});

/// The preset text inside a PNG, OpenEXR, TIFF or JPEG file that `writePicture` wrote (or any with that chunk), or that
/// of the views of a lenticular print; nothing where there is none. It is text from a file: parse it as untrusted.
/// Throws Failure when the file cannot be read.
[[nodiscard]] std::optional<std::string> embeddedPreset(const std::filesystem::path&);

/// The preset text in a description that a picture carries: the description itself, or what a print's description
/// says of its views; nothing where it is another program's text.
[[nodiscard]] std::optional<std::string> settingsInDescription(const std::string&);

/// Reads a picture for sampling: 8-bit values for 8-bit files (then `sRgb` says that they are sRGB-encoded), floats for
/// everything else (16-bit files are decoded when `sRgb`). 3 or 4 channels, or 1 of what is no color (not `sRgb`); a
/// sampled value of 1 channel is gray, (x, x, x, 1). Row 0 is the visible top and texture coordinate v = 0, as in glTF.
/// Color (`sRgb`) is obeyed as `readColor` does; of OpenEXR its color is taken. PNG files are read without OpenImageIO.
/// `warnings` as of `readColor`. Throws Failure as `readColor` does.
[[nodiscard]] std::shared_ptr<const Texture> loadTexture(const std::filesystem::path&, bool sRgb, bool repeat,
                                                         const ImageLimits& = {},
                                                         std::vector<std::string>* warnings = nullptr);

/// How a texture is made of a file's bytes.
struct TextureOptions {
    bool sRgb = true;
    bool repeat = true;
    bool mipmaps = true;
    /// Orientation and color space of the file count. False for glTF, whose specification (2.0, 5.19) demands that
    /// color spaces of its pictures are ignored, and whose texture coordinates count rows and columns as stored.
    bool obeysFile = true;
};

/// The same from the bytes of a PNG or JPEG file, as glTF embeds them; `name` is for messages.
[[nodiscard]] std::shared_ptr<Texture> textureFromBytes(std::string_view bytes, const std::string& name,
                                                        const TextureOptions&, const ImageLimits& = {});

}  // namespace vitrine::render
