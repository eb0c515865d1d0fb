#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/decode.h"
#include "render/image/exr_header.h"
#include "render/image/image_io.h"
#include "render/image/jpeg_end.h"
#include "render/image/oiio_codec.h"
#include "render/image/orientation.h"
#include "render/image/picture_stream.h"
#include "render/image/png_file.h"
#include "render/image/rec709.h"
#include "render/image/srgb.h"
#include "render/image/still_header.h"
#include "render/image/video_codec.h"
#include "render/image/webp_header.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::render {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& why)
{
    throw Failure(ErrorKind::file, "Cannot read " + name + ": " + why + "; choose another picture.");
}

/// Roles of the channels: which carry color or alpha, and which of them is alpha.
struct Roles {
    std::vector<bool> color;
    int alpha = -1;
};

Roles rolesOf(const StoredPicture& picture)
{
    Roles roles;
    roles.color.assign(static_cast<std::size_t>(picture.channels), picture.channelNames.empty());
    if (picture.channelNames.empty()) {
        if (picture.channels == 2 || picture.channels == 4) roles.alpha = picture.channels - 1;
        return roles;
    }
    for (std::size_t c = 0; c < picture.channelNames.size(); ++c) {
        const std::string& name = picture.channelNames[c];
        roles.color[c] = name == "R" || name == "G" || name == "B" || name == "A" || name == "Y";
        if (name == "A") roles.alpha = static_cast<int>(c);
    }
    return roles;
}

template <typename Code>
void decodeCodes(const std::vector<Code>& codes, const Roles& roles, bool raw, std::vector<float>& out)
{
    constexpr std::size_t last = std::numeric_limits<Code>::max();
    std::vector<float> linear(last + 1);
    std::vector<float> plain(last + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(last);
        plain[i] = static_cast<float>(x);
        linear[i] = raw ? plain[i] : static_cast<float>(linearFromSrgb(x));
    }
    const std::size_t channels = roles.color.size();
    for (std::size_t i = 0; i < codes.size(); ++i) {
        out[i] = static_cast<int>(i % channels) == roles.alpha ? plain[codes[i]] : linear[codes[i]];
    }
}

/// Replaces values that are not finite; returns the number of such samples.
std::size_t scrub(std::vector<float>& samples, const Roles& roles)
{
    constexpr float largest = 65504;  // The largest 16-bit float, the largest value that the format could store.
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        float& x = samples[i];
        if (std::isfinite(x)) continue;
        // In a depth channel, infinity means that nothing was hit. Only color must be finite.
        if (std::isinf(x) && !roles.color[i % roles.color.size()]) continue;
        x = std::isnan(x) ? 0.0F : std::copysign(largest, x);
        ++count;
    }
    return count;
}

/// Divides color by alpha: OpenEXR stores premultiplied color.
void divideByAlpha(std::vector<float>& samples, const Roles& roles)
{
    if (roles.alpha < 0) return;
    const std::size_t channels = roles.color.size();
    for (std::size_t first = 0; first < samples.size(); first += channels) {
        const float alpha = samples[first + static_cast<std::size_t>(roles.alpha)];
        if (!(alpha > 0) || alpha == 1) continue;
        for (std::size_t c = 0; c < channels; ++c) {
            if (roles.color[c] && static_cast<int>(c) != roles.alpha) samples[first + c] /= alpha;
        }
    }
}

std::vector<float> floatsOf(StoredPicture& picture, ImageFormat format, bool raw, std::vector<std::string>& warnings)
{
    const Roles roles = rolesOf(picture);
    std::vector<float> out;
    if (auto* floats = std::get_if<std::vector<float>>(&picture.samples)) {
        out = std::move(*floats);
        // A quotient by a very small alpha can be infinite, too.
        if (format == ImageFormat::exr && !raw) divideByAlpha(out, roles);
        if (const std::size_t count = scrub(out, roles); count > 0) {
            warnings.push_back(std::to_string(count) + " samples were not finite numbers and were replaced.");
        }
        return out;
    }
    out.resize(picture.sampleCount());
    if (const auto* bytes = std::get_if<0>(&picture.samples))
        decodeCodes(*bytes, roles, raw, out);
    else
        decodeCodes(std::get<1>(picture.samples), roles, raw, out);
    return out;
}

std::string readChecked(const std::filesystem::path& path, const ImageLimits& limits, ImageFormat& format)
{
    std::string bytes = readFile(path, limits.fileBytes);
    format = formatOf(bytes, path.string());
    if (!extensionAllows(path, format)) {
        fail(path.string(), "its content is " + std::string(fileFormat(format).name) + " although its name ends in \"" +
                                path.extension().string() + "\"");
    }
    return bytes;
}

/// Returns the samples with their channels rearranged. `sources` gives the old channel for each new one; -1 gives
/// `fill`.
template <typename Sample>
std::vector<Sample> rearranged(const std::vector<Sample>& from, std::size_t channels, const std::vector<int>& sources,
                               Sample fill)
{
    const std::size_t pixels = from.size() / channels;
    std::vector<Sample> out;
    out.reserve(pixels * sources.size());
    for (std::size_t p = 0; p < pixels; ++p) {
        for (const int source : sources)
            out.push_back(source < 0 ? fill : from[p * channels + static_cast<std::size_t>(source)]);
    }
    return out;
}

/// Returns the stored channel for each channel of a texture. Gray color becomes red, green and blue: OpenGL has no
/// sRGB-encoded format with one channel.
std::vector<int> textureChannels(int stored, bool color)
{
    const std::vector<int> gray = color ? std::vector<int>{0, 0, 0} : std::vector<int>{0};
    const std::array<std::vector<int>, 4> all = {{gray, {0, 0, 0, 1}, {0, 1, 2}, {0, 1, 2, 3}}};
    return all.at(static_cast<std::size_t>(stored - 1));
}

/// Returns whether all channels are color or alpha, in the usual order.
bool isPlainColor(const std::vector<std::string>& names)
{
    using Names = std::vector<std::string>;
    return names.empty() || names == Names{"Y"} || names == Names{"Y", "A"} || names == Names{"R", "G", "B"} ||
           names == Names{"R", "G", "B", "A"};
}

/// Returns the samples as linear light if the file's color space is not sRGB; else nothing.
std::optional<std::vector<float>> converted(StoredPicture& picture, ImageFormat format)
{
    if (!isPlainColor(picture.channelNames)) return std::nullopt;
    const bool encoded = !std::holds_alternative<std::vector<float>>(picture.samples);
    const ToRec709 conversion(picture.color, picture.channels, encoded);
    if (!conversion.problem().empty()) picture.warnings.push_back(conversion.problem());
    if (!conversion.isNeeded()) return std::nullopt;
    std::vector<float> floats = floatsOf(picture, format, encoded, picture.warnings);
    conversion.apply(floats);
    return floats;
}

/// Converts 8-bit codes of another color space to sRGB-encoded ones.
void bringToSrgb(StoredPicture& picture, ImageFormat format)
{
    const std::optional<std::vector<float>> light = converted(picture, format);
    if (!light) return;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool alpha = channels % 2 == 0;
    auto& codes = std::get<0>(picture.samples);
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes[i] = alpha && i % channels == channels - 1 ? code8((*light)[i]) : srgb8FromLinear((*light)[i]);
}

std::shared_ptr<Texture> makeTexture(StoredPicture& picture, ImageFormat format, const TextureOptions& options,
                                     const std::string& name)
{
    auto texture = std::make_shared<Texture>();
    texture->name = name;
    texture->repeat = options.repeat;
    texture->mipmaps = options.mipmaps;
    texture->width = picture.width;
    texture->height = picture.height;
    const std::vector<int> sources = textureChannels(picture.channels, options.sRgb);
    texture->channels = static_cast<int>(sources.size());
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool keep = sources.size() == channels;
    if (std::holds_alternative<std::vector<std::uint8_t>>(picture.samples)) {
        if (options.sRgb && options.obeysFile) bringToSrgb(picture, format);
        auto& bytes = std::get<0>(picture.samples);
        texture->sRgb = options.sRgb;
        texture->bytes = keep ? std::move(bytes) : rearranged<std::uint8_t>(bytes, channels, sources, 0);
    } else {
        std::optional<std::vector<float>> floats;
        if (options.sRgb && options.obeysFile) floats = converted(picture, format);
        // Float pictures are linear: they need no decoding, but their color must still be divided by alpha.
        const bool raw = !options.sRgb && format != ImageFormat::exr;
        if (!floats) floats = floatsOf(picture, format, raw, picture.warnings);
        texture->floats = keep ? std::move(*floats) : rearranged(*floats, channels, sources, 0.0F);
    }
    return texture;
}

/// A decoded file.
struct DecodedFile {
    ImageFormat format{};
    StoredPicture picture{};
};

/// Reads and decodes a file. The first row of the result is the visible top.
DecodedFile decodedFile(const std::filesystem::path& path, const DecodeRequest& request)
{
    DecodedFile file;
    const std::string bytes = readChecked(path, request.limits, file.format);
    file.picture = decodePicture(bytes, file.format, path.string(), request);
    orient(file.picture, file.picture.orientation);
    return file;
}

Image readAs(const std::filesystem::path& path, const ReadOptions& options, bool colorOnly,
             std::vector<std::string>* warnings)
{
    auto [format, picture] = decodedFile(path, {options.limits, colorOnly, options.canceled});
    Image image;
    image.width = picture.width;
    image.height = picture.height;
    image.channels = picture.channels;
    if (!colorOnly) image.channelNames = picture.channelNames;
    std::optional<std::vector<float>> light;
    if (!options.raw && !options.keepColors) light = converted(picture, format);
    image.pixels = light ? std::move(*light) : floatsOf(picture, format, options.raw, picture.warnings);
    if (warnings) warnings->insert(warnings->end(), picture.warnings.begin(), picture.warnings.end());
    return image;
}

}  // namespace

ImageFormat formatOf(std::string_view bytes, const std::string& name)
{
    const std::optional<ImageFormat> format = sniffImage(bytes);
    if (!format) fail(name, "it is not a " + readFormats() + " picture");
    if (format == ImageFormat::exr) {
        if (const std::string why = whyExrRefused(bytes, ImageLimits{}); !why.empty()) fail(name, why);
    }
    if (format == ImageFormat::hdr &&
        bytes.substr(0, bytes.find("\n\n")).find("FORMAT=32-bit_rle_xyze") != std::string_view::npos)
        fail(name,
             "its colors are coded as XYZE, and only RGBE is read; convert it, for example with Radiance's ra_xyze -r");
    return *format;
}

namespace {

/// Decodes BMP or GIF.
StoredPicture decodeStill(std::string_view bytes, ImageFormat format, const std::string& name,
                          const ImageLimits& limits)
{
    const bool isGif = format == ImageFormat::gif;
    const StillHeader header = isGif ? gifHeader(bytes) : bmpHeader(bytes);
    if (header.pictures > 1) fail(name, "it is an animation; save its pictures one by one");
    if (!header.whole || header.pictures == 0) fail(name, "it is cut short: the file ends within the picture");
    if (const std::string why = whyTooLarge(header.size, format, bytes.size(), limits); !why.empty()) fail(name, why);
    StoredPicture picture;
    if (const std::string why = videoCodec().readStill(bytes, isGif, picture); !why.empty()) fail(name, why);
    const auto width = static_cast<std::uint64_t>(picture.width), height = static_cast<std::uint64_t>(picture.height);
    if (width != header.size.width || height != header.size.height)
        fail(name, "it is broken (its header tells another size)");
    return picture;
}

}  // namespace

StoredPicture decodePicture(std::string_view bytes, ImageFormat format, const std::string& name,
                            const DecodeRequest& request)
{
    if (format == ImageFormat::png) return decodePng(bytes, name, request.limits, request.canceled);
    if (format == ImageFormat::bmp || format == ImageFormat::gif)
        return decodeStill(bytes, format, name, request.limits);
    if (format == ImageFormat::jpeg && !jpegIsWhole(bytes))
        fail(name, "it is cut short: the file ends within the picture");
    WebpHeader webp;
    if (format == ImageFormat::webp) {
        webp = webpHeader(bytes);
        if (webp.animated) fail(name, "it is an animation; save its pictures one by one");
        if (const std::string why = whyTooLarge(webp.size, format, bytes.size(), request.limits); !why.empty())
            fail(name, why);
    }
    StoredPicture picture;
    if (const std::string why = oiioCodec().decode(bytes, format, request, picture); !why.empty()) fail(name, why);
    if (format == ImageFormat::hdr) picture.orientation = hdrOrientation(bytes);
    if (format == ImageFormat::webp) {
        picture.orientation = webp.orientation;
        picture.color.profile = webp.profile;
    }
    return picture;
}

Image readImage(const std::filesystem::path& path, const ReadOptions& options, std::vector<std::string>* warnings)
{
    return readAs(path, options, false, warnings);
}

Image readColor(const std::filesystem::path& path, const ReadOptions& options, std::vector<std::string>* warnings)
{
    return readAs(path, options, true, warnings);
}

std::optional<std::string> embeddedPreset(const std::filesystem::path& path)
{
    ImageFormat format{};
    const std::string bytes = readChecked(path, ImageLimits{}, format);
    if (format == ImageFormat::png) {
        if (std::optional<std::string> preset = presetInPng(bytes, path.string())) return preset;
        return settingsInDescription(textInPng(bytes, printKey, path.string()).value_or(""));
    }
    if (format == ImageFormat::hdr || format == ImageFormat::bmp || format == ImageFormat::gif) return std::nullopt;
    const bool exr = format == ImageFormat::exr;
    std::string text;
    if (const std::string why = oiioCodec().readText(bytes, format, exr ? "vitrine:preset" : "ImageDescription", text);
        !why.empty())
        fail(path.string(), why);
    if (!exr) return settingsInDescription(text);
    if (text.empty()) return std::nullopt;
    return text;
}

std::string embeddedDescription(const std::filesystem::path& path)
{
    ImageFormat format{};
    const std::string bytes = readChecked(path, ImageLimits{}, format);
    if (format == ImageFormat::png) return textInPng(bytes, "Description", path.string()).value_or("");
    std::string text;
    if (const std::string why = oiioCodec().readText(bytes, format, "ImageDescription", text); !why.empty())
        fail(path.string(), why);
    return text;
}

std::optional<std::string> settingsInDescription(const std::string& text)
{
    if (!text.starts_with('{')) return std::nullopt;
    try {
        const Json root = parseJson(text, "the description").root();
        if (!root.contains("format") || !root["format"].is_string()) return std::nullopt;
        const auto& format = root["format"].get_ref<const std::string&>();
        if (format == "vitrine-job")
            return root.contains("scene") ? std::optional(writeJson(root["scene"])) : std::nullopt;
        if (format.starts_with("vitrine-")) return text;
    } catch (const Failure&) {  // Text of another program that begins with a brace.
    }
    return std::nullopt;
}

std::shared_ptr<const Texture> loadTexture(const std::filesystem::path& path, bool sRgb, bool repeat,
                                           const ImageLimits& limits, std::vector<std::string>* warnings)
{
    auto [format, picture] = decodedFile(path, {limits, true, {}});
    auto texture = makeTexture(picture, format, {.sRgb = sRgb, .repeat = repeat}, path.filename().string());
    if (warnings) warnings->insert(warnings->end(), picture.warnings.begin(), picture.warnings.end());
    return texture;
}

std::shared_ptr<Texture> textureFromBytes(std::string_view bytes, const std::string& name,
                                          const TextureOptions& options, const ImageLimits& limits)
{
    const ImageFormat format = formatOf(bytes, name);
    if (format != ImageFormat::png && format != ImageFormat::jpeg) {
        fail(name, "it is " + std::string(fileFormat(format).name) + ", and only PNG and JPEG are allowed here");
    }
    StoredPicture picture = decodePicture(bytes, format, name, {limits, true, {}});
    if (options.obeysFile) orient(picture, picture.orientation);
    return makeTexture(picture, format, options, name);
}

}  // namespace vitrine::render
