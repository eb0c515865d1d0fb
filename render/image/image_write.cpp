#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/image/oiio_codec.h"
#include "render/image/png_file.h"
#include "render/image/srgb.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace vitrine::render {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why)
{
    throw Failure(ErrorKind::file, "Cannot write " + path.string() + ": " + why + ".");
}

constexpr std::size_t mostJpegComment = 65532;  ///< Bytes: the longest marker segment, without the final zero.

bool isExr(PictureFormat format)
{
    return fileFormat(format).format == ImageFormat::exr;
}

StoredPicture emptyLike(const Image& image)
{
    StoredPicture picture;
    picture.width = image.width;
    picture.height = image.height;
    picture.channels = image.channels;
    return picture;
}

template <typename Code> StoredPicture encoded(const Image& image, Code (*color)(float), Code (*alpha)(float))
{
    StoredPicture picture = emptyLike(image);
    std::vector<Code> codes(image.pixels.size());
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t alphaAt = image.channels == 2 || image.channels == 4 ? channels - 1 : channels;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        codes[i] = i % channels == alphaAt ? alpha(image.pixels[i]) : color(image.pixels[i]);
    }
    picture.samples = std::move(codes);
    return picture;
}

/// Blends a picture over white; returns RGB or gray without alpha.
Image overWhite(const Image& image)
{
    if (image.channels == 1 || image.channels == 3) return image;
    Image opaque(image.width, image.height, image.channels - 1);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < opaque.pixels.size(); ++i) {
        const std::size_t pixel = i / (channels - 1) * channels;
        const float alpha = std::clamp(image.pixels[pixel + channels - 1], 0.0F, 1.0F);
        opaque.pixels[i] = image.pixels[pixel + i % (channels - 1)] * alpha + (1 - alpha);
    }
    return opaque;
}

StoredPicture forExr(const Image& image, bool halfColor)
{
    StoredPicture picture = emptyLike(image);
    const std::array<std::vector<std::string>, 4> plain = {{{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}};
    picture.channelNames =
        image.channelNames.empty() ? plain.at(static_cast<std::size_t>(image.channels - 1)) : image.channelNames;
    std::vector<float> samples = image.pixels;
    const std::size_t channels = picture.channelNames.size();
    std::vector<bool> isColor(channels);
    std::size_t alphaAt = channels;
    for (std::size_t c = 0; c < channels; ++c) {
        const std::string& name = picture.channelNames[c];
        isColor[c] = name == "R" || name == "G" || name == "B" || name == "Y";
        if (name == "A") alphaAt = c;
    }
    constexpr float largestHalf = 65504;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t c = i % channels;
        if (isColor[c] && alphaAt < channels) samples[i] *= image.pixels[i - c + alphaAt];
        if (halfColor && (isColor[c] || c == alphaAt)) samples[i] = std::clamp(samples[i], -largestHalf, largestHalf);
    }
    picture.samples = std::move(samples);
    return picture;
}

void check(const std::filesystem::path& path, const Image& image, PictureFormat format)
{
    const int most = isExr(format) ? static_cast<int>(ImageLimits{}.exrChannels) : 4;
    if (image.width < 1 || image.height < 1 || image.channels < 1) refuse(path, "the picture is empty");
    if (image.channels > most) {
        refuse(path, "the picture has " + std::to_string(image.channels) + " channels and this format holds " +
                         std::to_string(most) + "; choose OpenEXR");
    }
    const bool misnamed =
        !image.channelNames.empty() && image.channelNames.size() != static_cast<std::size_t>(image.channels);
    if (misnamed || (isExr(format) && image.channels > 4 && image.channelNames.empty())) {
        refuse(path, "the channels of the picture have no names");
    }
    const PictureFileFormat& stored = fileFormat(format);
    if (!extensionAllows(path, stored.format)) {
        refuse(path, "a name that ends in \"" + path.extension().string() + "\" does not fit the format " +
                         std::string(stored.name));
    }
}

StoredPicture prepared(const Image& image, PictureFormat format)
{
    switch (format) {
    case PictureFormat::png8:
    case PictureFormat::tiff8: return encoded<std::uint8_t>(image, srgb8FromLinear, code8);
    case PictureFormat::png16:
    case PictureFormat::tiff16: return encoded<std::uint16_t>(image, srgb16FromLinear, code16);
    case PictureFormat::jpeg: return encoded<std::uint8_t>(overWhite(image), srgb8FromLinear, code8);
    case PictureFormat::exr: return forExr(image, false);
    case PictureFormat::exrHalf: return forExr(image, true);
    }
    return {};
}

}  // namespace

std::string encodedPicture(const std::filesystem::path& path, const Image& image, PictureFormat format,
                           const PictureMetadata& metadata)
{
    assert(fileFormat(format).format == ImageFormat::png);
    check(path, image, format);
    constexpr double inchesPerMeter = 1 / 0.0254;
    return encodePng(prepared(image, format),
                     {metadata.preset, metadata.description, metadata.pixelsPerInch * inchesPerMeter}, path.string());
}

void writePicture(const std::filesystem::path& path, const Image& image, PictureFormat format,
                  const PictureMetadata& metadata, FileOps& ops)
{
    stagedPicture(path, image, format, metadata, ops)->publish();
}

std::unique_ptr<PartFile> stagedPicture(const std::filesystem::path& path, const Image& image, PictureFormat format,
                                        const PictureMetadata& metadata, FileOps& ops)
{
    if (fileFormat(format).format == ImageFormat::png) {
        const std::string bytes = encodedPicture(path, image, format, metadata);
        requireSpace(path, bytes.size(), ops);
        return stagedFile(path, bytes, ops);
    }

    check(path, image, format);
    const StoredPicture picture = prepared(image, format);
    OiioTarget target;
    target.format = fileFormat(format).format;
    target.halfColor = format == PictureFormat::exrHalf;
    target.pixelsPerInch = metadata.pixelsPerInch;
    if (isExr(format)) {
        target.texts = metadata.texts;
        target.texts.emplace_back("software", std::string("Vitrine ").append(programVersion()));
        if (metadata.camera)
            target.matrices = {{"worldToCamera", metadata.camera->worldToCamera},
                               {"worldToNDC", metadata.camera->worldToNdc}};
        if (!metadata.preset.empty()) target.texts.emplace_back("vitrine:preset", metadata.preset);
        if (!metadata.description.empty()) target.texts.emplace_back("ImageDescription", metadata.description);
    } else if (!metadata.preset.empty()) {
        std::string text = asciiJson(metadata.preset);  // TIFF text must be ASCII.
        if (format == PictureFormat::jpeg && text.size() > mostJpegComment)
            refuse(path, "its settings are " + std::to_string(text.size()) + " bytes and a JPEG holds " +
                             std::to_string(mostJpegComment) + "; choose PNG");
        target.texts.emplace_back("ImageDescription", std::move(text));
    } else if (!metadata.description.empty()) {
        target.texts.emplace_back("ImageDescription", metadata.description);
    }

    const std::size_t sampleBytes = isExr(format) ? 4 : static_cast<std::size_t>(bitsOf(format)) / 8;
    requireSpace(path, picture.sampleCount() * sampleBytes, ops);
    auto part = std::make_unique<PartFile>(path, ops);
    target.path = part->path().string();
    if (const std::string why = oiioCodec().write(picture, target); !why.empty()) {
        refuse(path, why + "; the old content is untouched; free some space or choose another disk");
    }
    return part;
}

}  // namespace vitrine::render
