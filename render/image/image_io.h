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

struct ReadOptions {
    ImageLimits limits{};
    bool raw = false;                  ///< Keep stored values: no sRGB decoding, codes divided by 255 or 65535.
    std::function<bool()> canceled{};  ///< Asked between rows, from the calling thread; true stops with a Failure.
};

/// Reads PNG, JPEG, TIFF, OpenEXR or Radiance HDR; the first bytes decide which, and must agree with the
/// name's extension. 8-bit and 16-bit pictures are taken as sRGB-encoded and returned linear (alpha as it
/// is); float pictures are linear already. 1 to 4 channels, for OpenEXR up to 16 with `channelNames`. Alpha
/// is returned not premultiplied. In color channels NaN becomes 0 and infinities ±65504; in other channels
/// NaN becomes 0; the count is one of the `warnings` (may be null), which are full sentences.
/// Throws Failure naming the file when it is none of these, too large (before anything is allocated),
/// broken, or canceled.
[[nodiscard]] Image readImage(const std::filesystem::path&, const ReadOptions& = {},
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
/// attribute "vitrine:preset", in TIFF into ImageDescription; JPEG carries none. `ops` is used where no OpenImageIO is.
/// Throws Failure naming file and cause; the old file then stands.
void writePicture(const std::filesystem::path&, const Image&, PictureFormat, const PictureMetadata& = {},
                  FileOps& ops = systemFileOps());

/// The bytes of the PNG (`png8` or `png16`) that `writePicture` writes under that name; nothing is written. Throws as
/// it does.
[[nodiscard]] std::string encodedPicture(const std::filesystem::path&, const Image&, PictureFormat,
                                         const PictureMetadata& = {});

/// The preset text inside a PNG or OpenEXR file that `writePicture` wrote (or any with that chunk), or
/// nothing. It is text from a file: parse it as untrusted. Throws Failure when the file cannot be read.
[[nodiscard]] std::optional<std::string> embeddedPreset(const std::filesystem::path&);

/// Reads a picture for sampling: 8-bit values as stored for 8-bit files (then `sRgb` says that they are
/// sRGB-encoded), floats for everything else (16-bit files are decoded when `sRgb`). 1, 3 or 4 channels:
/// gray with alpha becomes RGBA, OpenEXR gives its R, G, B and A. Row 0 is the TOP row of the picture and
/// is texture coordinate v = 0, as in glTF. PNG files are read without OpenImageIO.
/// Throws Failure as `readImage` does.
[[nodiscard]] std::shared_ptr<const Texture> loadTexture(const std::filesystem::path&, bool sRgb, bool repeat,
                                                         const ImageLimits& = {});

/// The same from the bytes of a PNG or JPEG file, as glTF embeds them; `name` is for messages.
[[nodiscard]] std::shared_ptr<const Texture> textureFromBytes(std::string_view bytes, const std::string& name,
                                                              bool sRgb, bool repeat, bool mipmaps = true,
                                                              const ImageLimits& = {});

}  // namespace vitrine::render
