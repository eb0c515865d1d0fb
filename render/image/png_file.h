#pragma once

#include "render/image/image_limits.h"
#include "render/image/stored_picture.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Decodes a PNG with libpng: 8 or 16 bits per channel, 1 to 4 channels. Palettes and 1, 2 and 4 bits become 8 bits;
/// transparent colors become alpha. Values stay as stored (usually sRGB-encoded), and rows in their order;
/// `orientation` and `color` are those of the file's chunks. Throws Failure naming `name` for broken files, for
/// pictures that `whyTooLarge` refuses, and when `canceled` (polled once per row; may be empty) returns true.
[[nodiscard]] StoredPicture decodePng(std::string_view bytes, const std::string& name, const ImageLimits&,
                                      const std::function<bool()>& canceled = {});

/// Metadata of a PNG.
struct PngText {
    std::string preset;         ///< UTF-8, in an iTXt chunk "vitrine:preset"; empty: none.
    std::string description;    ///< UTF-8, in "Description"; empty: none.
    double pixelsPerMeter = 0;  ///< Stored in pHYs, rounded to whole numbers; 0: none.
};

/// Encodes 8-bit or 16-bit samples (1 to 4 channels, sRGB-encoded) as a PNG with an sRGB chunk. Throws Failure naming
/// `name` if libpng fails or memory runs out.
[[nodiscard]] std::string encodePng(const StoredPicture&, const PngText&, const std::string& name);

/// Returns the text of the first tEXt or iTXt chunk "vitrine:preset", if any. Reads no pixels.
[[nodiscard]] std::optional<std::string> presetInPng(std::string_view bytes, const std::string& name);
/// The same for any chunk `key`.
[[nodiscard]] std::optional<std::string> textInPng(std::string_view bytes, const char* key, const std::string& name);
/// Returns the ICC profile; empty if there is none. Reads no pixels.
[[nodiscard]] std::string profileInPng(std::string_view bytes, const std::string& name);

}  // namespace vitrine::render
