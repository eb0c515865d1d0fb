#pragma once

#include "render/image/image_limits.h"
#include "render/image/stored_picture.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Unpacks a PNG with libpng: 8 or 16 bits per channel, 1 to 4 channels; palettes and 1, 2 and 4 bits
/// become 8 bits, transparent colors become alpha. Values stay as stored (usually sRGB-encoded), and rows in their
/// order: `orientation` and `color` say what the file's chunks say.
/// Throws Failure naming `name` for broken files, for what `whyTooLarge` refuses, and when `canceled`
/// (asked once per row; may be empty) returns true.
[[nodiscard]] StoredPicture decodePng(std::string_view bytes, const std::string& name, const ImageLimits&,
                                      const std::function<bool()>& canceled = {});

/// What a PNG carries besides its pixels.
struct PngText {
    std::string preset;         ///< UTF-8, in an iTXt chunk "vitrine:preset"; nothing when empty.
    std::string description;    ///< UTF-8, in "Description"; nothing when empty.
    double pixelsPerMeter = 0;  ///< In pHYs, rounded to whole numbers; nothing when 0.
};

/// Packs 8-bit or 16-bit samples (1 to 4 channels, sRGB-encoded) as a PNG with an sRGB chunk.
/// Throws Failure naming `name` when libpng refuses or memory runs out.
[[nodiscard]] std::string encodePng(const StoredPicture&, const PngText&, const std::string& name);

/// The text of the first tEXt or iTXt chunk "vitrine:preset", if any. Reads no pixels.
[[nodiscard]] std::optional<std::string> presetInPng(std::string_view bytes, const std::string& name);
/// The same of any chunk `key`.
[[nodiscard]] std::optional<std::string> textInPng(std::string_view bytes, const char* key, const std::string& name);
/// The ICC profile, empty when there is none. Reads no pixels.
[[nodiscard]] std::string profileInPng(std::string_view bytes, const std::string& name);

}  // namespace vitrine::render
