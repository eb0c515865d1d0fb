#pragma once

#include "render/files/strict_json.h"
#include "render/image/image.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Kind of raw picture with the values of OpenEXR: radiance, and all channels.
inline constexpr const char* rawLinear = "linear";

/// Largest size of the bytes that follow an answer: a picture of 3840 x 2160 with four channels fits.
inline constexpr std::size_t mostRawBytes = 128U << 20U;

/// Adds the option "--raw", which asks for the values of a picture in place of a file. The command must have "--out".
void addRawOption(CLI::App&, std::string& raw);

/// Throws Failure (ErrorKind::usage) for more channels than color where the values are those of a PNG.
void requireRawChannels(const std::string& raw, const std::string& channels);

/// Describes the bytes of a raw picture: {"bytes", "type", "shape": [height, width, channels], "channels"}. Throws
/// Failure (ErrorKind::usage) if they are more than `mostRawBytes`.
[[nodiscard]] render::Json rawJson(const render::Image&);

/// Returns the pixels as little-endian floats, row 0 at the top, channels interleaved. Colors are sRGB-encoded unless
/// `raw` is `rawLinear`: then a PNG's codes are the values times 255, rounded.
[[nodiscard]] std::string rawBytes(const render::Image&, const std::string& raw);

}  // namespace vitrine::app
