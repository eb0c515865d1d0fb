#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/image/decode.h"
#include "render/image/image_io.h"
#include "render/image/jpeg_end.h"
#include "render/image/oiio_codec.h"
#include "render/image/png_file.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::render {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& why)
{
    throw Failure(Blame::file, "Cannot read " + name + ": " + why + "; choose another picture.");
}

/// Which channels carry color or alpha, and which of them alpha.
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

/// Replaces what is not finite; returns how many samples that were.
std::size_t scrub(std::vector<float>& samples, const Roles& roles)
{
    constexpr float largest = 65504;  // The largest 16-bit float: what the format could have held.
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        float& x = samples[i];
        if (std::isfinite(x)) continue;
        // A depth of infinity means that nothing was hit: only color has to be finite.
        if (std::isinf(x) && !roles.color[i % roles.color.size()]) continue;
        x = std::isnan(x) ? 0.0F : std::copysign(largest, x);
        ++count;
    }
    return count;
}

/// OpenEXR stores color multiplied by alpha.
void divideByAlpha(std::vector<float>& samples, const Roles& roles)
{
    if (roles.alpha < 0) return;
    const std::size_t channels = roles.color.size();
    for (std::size_t first = 0; first < samples.size(); first += channels) {
        const float alpha = samples[first + static_cast<std::size_t>(roles.alpha)];
        if (alpha <= 0 || alpha == 1) continue;
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
        if (const std::size_t count = scrub(out, roles); count > 0) {
            warnings.push_back(std::to_string(count) + " samples were not finite numbers and were replaced.");
        }
        if (format == ImageFormat::exr && !raw) divideByAlpha(out, roles);
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
        fail(path.string(), "its content is " + std::string(toString(format)) + " although its name ends in \"" +
                                path.extension().string() + "\"");
    }
    return bytes;
}

/// Repeats `from`'s samples in another order of channels; a source of -1 gives `fill`.
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

/// Which stored channel each channel of a texture comes from.
std::vector<int> textureChannels(const StoredPicture& picture)
{
    if (picture.channelNames.empty()) {
        const std::array<std::vector<int>, 4> plain = {{{0}, {0, 0, 0, 1}, {0, 1, 2}, {0, 1, 2, 3}}};
        return plain.at(static_cast<std::size_t>(picture.channels - 1));
    }
    const auto find = [&](const char* name) {
        const auto at = std::find(picture.channelNames.begin(), picture.channelNames.end(), name);
        return at == picture.channelNames.end() ? -1 : static_cast<int>(at - picture.channelNames.begin());
    };
    const int red = find("R");
    const int green = find("G");
    const int blue = find("B");
    const int alpha = find("A");
    if (red < 0 && green < 0 && blue < 0) return {std::max(find("Y"), 0)};
    if (alpha < 0) return {red, green, blue};
    return {red, green, blue, alpha};
}

std::shared_ptr<const Texture> makeTexture(StoredPicture picture, ImageFormat format, const std::string& name,
                                           bool sRgb, bool repeat, bool mipmaps)
{
    auto texture = std::make_shared<Texture>();
    texture->name = name;
    texture->width = picture.width;
    texture->height = picture.height;
    texture->repeat = repeat;
    texture->mipmaps = mipmaps;
    const std::vector<int> sources = textureChannels(picture);
    texture->channels = static_cast<int>(sources.size());
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool keep = sources.size() == channels && std::is_sorted(sources.begin(), sources.end()) &&
                      sources.front() == 0 && sources.back() + 1 == picture.channels;
    if (auto* bytes = std::get_if<0>(&picture.samples)) {
        texture->sRgb = sRgb;
        texture->bytes = keep ? std::move(*bytes) : rearranged<std::uint8_t>(*bytes, channels, sources, 0);
        return texture;
    }
    std::vector<std::string> warnings;
    std::vector<float> floats = floatsOf(picture, format, !sRgb, warnings);
    texture->floats = keep ? std::move(floats) : rearranged(floats, channels, sources, 0.0F);
    return texture;
}

}  // namespace

ImageFormat formatOf(std::string_view bytes, const std::string& name)
{
    const std::optional<ImageFormat> format = sniffImage(bytes);
    if (!format) fail(name, "it is not a PNG, JPEG, TIFF, OpenEXR or HDR picture");
    return *format;
}

StoredPicture decodePicture(std::string_view bytes, ImageFormat format, const std::string& name,
                            const ImageLimits& limits, const std::function<bool()>& canceled)
{
    if (format == ImageFormat::png) return decodePng(bytes, name, limits, canceled);
    if (format == ImageFormat::jpeg && !jpegIsWhole(bytes))
        fail(name, "it is cut short: the file ends within the picture");
    StoredPicture picture;
    if (const std::string why = oiioCodec().decode(bytes, format, limits, canceled, picture); !why.empty())
        fail(name, why);
    return picture;
}

Image readImage(const std::filesystem::path& path, const ReadOptions& options, std::vector<std::string>* warnings)
{
    ImageFormat format{};
    const std::string bytes = readChecked(path, options.limits, format);
    StoredPicture picture = decodePicture(bytes, format, path.string(), options.limits, options.canceled);
    Image image;
    image.width = picture.width;
    image.height = picture.height;
    image.channels = picture.channels;
    image.channelNames = picture.channelNames;
    image.pixels = floatsOf(picture, format, options.raw, picture.warnings);
    if (warnings) warnings->insert(warnings->end(), picture.warnings.begin(), picture.warnings.end());
    return image;
}

std::optional<std::string> embeddedPreset(const std::filesystem::path& path)
{
    ImageFormat format{};
    const std::string bytes = readChecked(path, ImageLimits{}, format);
    if (format == ImageFormat::png) return presetInPng(bytes, path.string());
    if (format != ImageFormat::exr) return std::nullopt;
    std::string text;
    if (const std::string why = oiioCodec().readText(bytes, format, "vitrine:preset", text); !why.empty())
        fail(path.string(), why);
    if (text.empty()) return std::nullopt;
    return text;
}

std::shared_ptr<const Texture> loadTexture(const std::filesystem::path& path, bool sRgb, bool repeat,
                                           const ImageLimits& limits)
{
    ImageFormat format{};
    const std::string bytes = readChecked(path, limits, format);
    // Float pictures are linear: there is nothing to decode, and alpha still has to be divided out.
    const bool linear = sRgb || format == ImageFormat::exr;
    return makeTexture(decodePicture(bytes, format, path.string(), limits), format, path.filename().string(), linear,
                       repeat, true);
}

std::shared_ptr<const Texture> textureFromBytes(std::string_view bytes, const std::string& name, bool sRgb, bool repeat,
                                                bool mipmaps, const ImageLimits& limits)
{
    const ImageFormat format = formatOf(bytes, name);
    if (format != ImageFormat::png && format != ImageFormat::jpeg) {
        fail(name, "it is " + std::string(toString(format)) + ", and only PNG and JPEG are allowed here");
    }
    return makeTexture(decodePicture(bytes, format, name, limits), format, name, sRgb, repeat, mipmaps);
}

}  // namespace vitrine::render
