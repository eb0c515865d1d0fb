#include "render/image/picture_formats.h"

#include "render/files/extension.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cassert>

namespace vitrine::render {
namespace {

const WrittenDepth* depthOf(const PictureFileFormat& format, std::optional<int> bits)
{
    const auto fits = [&](const WrittenDepth& depth) { return !bits || depth.bits == *bits; };
    const auto found = std::find_if(format.written.begin(), format.written.end(), fits);
    return found == format.written.end() ? nullptr : &*found;
}

template <typename Is> std::string usualExtensions(const Is& is)
{
    std::vector<std::string_view> extensions;
    for (const PictureFileFormat& format : pictureFormats())
        if (is(format)) extensions.push_back(format.extensions.front());
    return alternatives(extensions);
}

template <typename Is> std::string allEndings(const Is& is)
{
    std::string text;
    for (const PictureFileFormat& format : pictureFormats()) {
        if (!is(format)) continue;
        for (const std::string_view extension : format.extensions)
            (text += text.empty() ? "" : " ") += extension.substr(1);
    }
    return text;
}

}  // namespace

const std::vector<PictureFileFormat>& pictureFormats()
{
    using F = PictureFormat;
    static const std::vector<PictureFileFormat> formats{
        {ImageFormat::png, "PNG", {".png"}, "png", {{8, F::png8}, {16, F::png16}}, "image/png", false, true},
        {ImageFormat::jpeg, "JPEG", {".jpg", ".jpeg"}, "jpeg", {{8, F::jpeg}}, "image/jpeg"},
        {ImageFormat::tiff, "TIFF", {".tif", ".tiff"}, "tiff", {{8, F::tiff8}, {16, F::tiff16}}, "", false, true},
        {ImageFormat::exr, "OpenEXR", {".exr"}, "openexr", {{32, F::exr}, {16, F::exrHalf}}, "", true},
        {ImageFormat::hdr, "HDR", {".hdr", ".rgbe"}, "hdr", {}, "", true},
        {ImageFormat::webp, "WebP", {".webp"}, "webp", {}, "image/webp"},
        {ImageFormat::bmp, "BMP", {".bmp"}, "", {}, "image/bmp"},
        {ImageFormat::gif, "GIF", {".gif"}, "", {}, "image/gif"},
        {ImageFormat::pdf, "PDF", {".pdf"}, "", {}, "", false, true, false},
    };
    return formats;
}

const PictureFileFormat& fileFormat(ImageFormat format)
{
    const auto& all = pictureFormats();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& row) { return row.format == format; });
    assert(found != all.end());
    return *found;
}

const PictureFileFormat& fileFormat(PictureFormat format)
{
    const auto writes = [&](const PictureFileFormat& row) {
        const auto is = [&](const WrittenDepth& depth) { return depth.format == format; };
        return std::any_of(row.written.begin(), row.written.end(), is);
    };
    const auto& all = pictureFormats();
    const auto found = std::find_if(all.begin(), all.end(), writes);
    assert(found != all.end());
    return *found;
}

const PictureFileFormat* formatNamed(const std::filesystem::path& path)
{
    const std::string extension = lowerExtension(path);
    for (const PictureFileFormat& format : pictureFormats())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
            return &format;
    return nullptr;
}

std::optional<ImageFormat> sniffImage(std::string_view bytes)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return ImageFormat::png;
    if (bytes.starts_with("\xff\xd8\xff"sv)) return ImageFormat::jpeg;
    if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return ImageFormat::tiff;
    if (bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv)) return ImageFormat::tiff;  // BigTIFF.
    if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return ImageFormat::exr;
    if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return ImageFormat::hdr;
    if (bytes.size() >= 12 && bytes.starts_with("RIFF"sv) && bytes.substr(8, 4) == "WEBP"sv) return ImageFormat::webp;
    if (bytes.starts_with("GIF87a"sv) || bytes.starts_with("GIF89a"sv)) return ImageFormat::gif;
    if (bytes.starts_with("BM"sv)) return ImageFormat::bmp;
    return std::nullopt;
}

bool isPdf(std::string_view bytes)
{
    return bytes.substr(0, 5) == "%PDF-";
}

bool extensionAllows(const std::filesystem::path& path, ImageFormat format)
{
    if (path.extension().empty()) return true;
    const PictureFileFormat* named = formatNamed(path);
    return named && named->format == format;
}

int bitsOf(PictureFormat format)
{
    const std::vector<WrittenDepth>& written = fileFormat(format).written;
    const auto is = [&](const WrittenDepth& depth) { return depth.format == format; };
    return std::find_if(written.begin(), written.end(), is)->bits;
}

std::optional<PictureFormat> writtenFormat(const std::filesystem::path& path, std::optional<int> bits)
{
    const PictureFileFormat* named = formatNamed(path);
    const WrittenDepth* depth = named ? depthOf(*named, bits) : nullptr;
    return depth ? std::optional(depth->format) : std::nullopt;
}

std::vector<std::string_view> writtenEndings(std::optional<int> bits)
{
    std::vector<std::string_view> endings;
    for (const PictureFileFormat& format : pictureFormats())
        if (depthOf(format, bits)) endings.push_back(format.extensions.front().substr(1));
    return endings;
}

std::string writtenExtensions(std::optional<int> bits)
{
    return usualExtensions([&](const PictureFileFormat& format) { return depthOf(format, bits) != nullptr; });
}

std::string streamedExtensions()
{
    return usualExtensions([](const PictureFileFormat& format) { return format.isStreamed; });
}

std::string_view streamedEndings()
{
    static const std::string endings = allEndings([](const PictureFileFormat& format) { return format.isStreamed; });
    return endings;
}

std::string_view settingsEndings()
{
    static const std::string endings =
        allEndings([](const PictureFileFormat& format) { return !format.written.empty(); });
    return endings;
}

std::string_view readEndings()
{
    static const std::string endings = allEndings([](const PictureFileFormat& format) { return format.isRead; });
    return endings;
}

const std::string& readFormats()
{
    static const std::string names = [] {
        std::vector<std::string_view> read;
        for (const PictureFileFormat& format : pictureFormats())
            if (format.isRead) read.push_back(format.name);
        return alternatives(read);
    }();
    return names;
}

}  // namespace vitrine::render
