#include "app/serve/raw_picture.h"

#include "app/kit/number_option.h"
#include "render/failure.h"
#include "render/image/srgb.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <bit>

namespace vitrine::app {
namespace {

constexpr int colors = 3;
static_assert(std::endian::native == std::endian::little, "The bytes are those of memory.");

std::size_t sizeOf(const render::Image& picture)
{
    return picture.pixels.size() * sizeof(float);
}

}  // namespace

void addRawOption(CLI::App& options, std::string& raw)
{
    addChoice(options, "--raw", raw, {rawLinear, "display"},
              "Values of the picture as floats behind the answer: linear light with all channels, or as a PNG")
        ->excludes(options.get_option("--out"));
}

void requireRawChannels(const std::string& raw, const std::string& channels)
{
    if (raw.empty() || raw == rawLinear || channels.empty() || channels == "color") return;
    throw Failure(ErrorKind::usage,
                  "channels: raw " + raw + " has color only; give raw " + rawLinear + " for \"" + channels + "\".");
}

render::Json rawJson(const render::Image& picture)
{
    const std::size_t bytes = sizeOf(picture);
    if (bytes > mostRawBytes)
        throw Failure(ErrorKind::usage, "raw: a picture of " + std::to_string(picture.width) + " x " +
                                            std::to_string(picture.height) + " pixels and " +
                                            std::to_string(picture.channels) + " channels has " +
                                            std::to_string(bytes) + " bytes, and at most " +
                                            std::to_string(mostRawBytes) + " follow an answer; let out name a file.");
    std::vector<std::string> names = picture.channelNames;
    if (names.empty()) names = {"R", "G", "B", "A"};
    names.resize(static_cast<std::size_t>(picture.channels));
    return {{"bytes", bytes},
            {"type", "float32"},
            {"shape", {picture.height, picture.width, picture.channels}},
            {"channels", names}};
}

std::string rawBytes(const render::Image& picture, const std::string& raw)
{
    if (raw == rawLinear) return {reinterpret_cast<const char*>(picture.pixels.data()), sizeOf(picture)};
    render::Image encoded = picture;
    for (std::size_t i = 0; i < encoded.pixels.size(); ++i)
        if (static_cast<int>(i % static_cast<std::size_t>(picture.channels)) < colors)
            encoded.pixels[i] = static_cast<float>(std::clamp(render::srgbFromLinear(encoded.pixels[i]), 0.0, 1.0));
    return {reinterpret_cast<const char*>(encoded.pixels.data()), sizeOf(encoded)};
}

}  // namespace vitrine::app
