#include "render/image/picture_stream.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/decode.h"
#include "render/image/picture_formats.h"
#include "render/image/picture_rows.h"
#include "render/image/png_file.h"
#include "render/image/webp_header.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

constexpr std::int64_t tiffSide = 1 << 20;  // OpenImageIO does not read larger TIFF files.
constexpr std::int64_t keptRows = 16;

bool is(ImageFormat wanted, const std::filesystem::path& path)
{
    const PictureFileFormat* format = formatNamed(path);
    return format && format->format == wanted;
}

bool isPng(const std::filesystem::path& path)
{
    return is(ImageFormat::png, path);
}

const char* nameOf(StreamCompression compression)
{
    switch (compression) {
    case StreamCompression::none: return "none";
    case StreamCompression::deflate: return "zip";
    }
    return "none";
}

}  // namespace

void requireStream(const std::filesystem::path& path, const StreamShape& shape)
{
    if (isPng(path) && shape.channels != 3)
        throw Failure(ErrorKind::usage, "Cannot write " + path.string() +
                                            ": a PNG cannot hold inks (CMYK); give a name that ends in .tif or .pdf.");
    // OpenImageIO writes inks with 8 bits only.
    if (is(ImageFormat::tiff, path) && shape.channels == 4 && shape.bits != 8)
        throw Failure(ErrorKind::usage, "Cannot write " + path.string() +
                                            ": a TIFF of inks (CMYK) has 8 bits per channel; choose 8 bits, or give a "
                                            "name that ends in .pdf.");
    const std::int64_t most = isPng(path) ? 2147483647 : tiffSide;
    if (shape.width > most || shape.height > most) {
        throw Failure(ErrorKind::usage, "Cannot write " + path.string() + ": " + std::to_string(shape.width) + " x " +
                                            std::to_string(shape.height) +
                                            " pixels are too many for this format, which ends at " +
                                            std::to_string(most) + " per side; print it in parts.");
    }
}

std::uint64_t streamBytes(const std::filesystem::path& path, const StreamSpec& spec)
{
    constexpr double most = 1e19;  // The largest 16-bit PNG has more bytes than 64 bits can count.
    const double bytes =
        static_cast<double>(spec.width) * static_cast<double>(spec.height) * spec.channels * (spec.bits / 8);
    const bool packed = isPng(path) || is(ImageFormat::pdf, path) || spec.compression != StreamCompression::none;
    return static_cast<std::uint64_t>(std::min(packed ? bytes / 4 : bytes, most));
}

PictureStream::PictureStream(const std::filesystem::path& path, const StreamSpec& spec, FileOps& ops)
    : path_(path), spec_(spec), part_(std::make_unique<PartFile>(path, ops))
{
    if (const PictureFileFormat* format = formatNamed(path); !format || !format->isStreamed)
        throw Failure(ErrorKind::usage,
                      "Cannot write " + path.string() + ": give a name that ends in " + streamedExtensions() + '.');
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        throw Failure(ErrorKind::file, "Cannot write " + path.string() + ": there is no folder " + folder.string() +
                                           "; create it first.");
    requireStream(path, {spec.width, spec.height, spec.channels, spec.bits});
    requireSpace(path, streamBytes(path, spec), ops);
    if (isPng(path)) {
        pngRows_ = std::make_unique<PngRows>(PngRowTarget{part_->path().string(), spec.width, spec.height, spec.bits,
                                                          spec.dpiX, spec.dpiY, spec.likeRowAbove, printKey, spec.json,
                                                          spec.profile, spec.threads},
                                             ops);
        if (const std::string why = pngRows_->begin(); !why.empty()) refuse(why);
        return;
    }
    tiff_ = {part_->path().string(),
             static_cast<int>(spec.width),
             static_cast<int>(spec.height),
             spec.bits,
             spec.channels,
             nameOf(spec.compression),
             spec.dpiX,
             spec.dpiY,
             asciiJson(spec.json),
             spec.profile,
             spec.trim,
             spec.bleed};
    const std::string why =
        is(ImageFormat::pdf, path) ? oiioCodec().openPdfRows(tiff_, tiffRows_) : oiioCodec().openRows(tiff_, tiffRows_);
    if (!why.empty()) refuse(why);
}

void PictureStream::refuse(const std::string& why) const
{
    throw Failure(ErrorKind::file, "Cannot write " + path_.string() + ": " + why +
                                       "; the old content is untouched; free some space or choose another disk.");
}

void PictureStream::write(const void* rows, std::int64_t count)
{
    const std::string why = pngRows_ ? pngRows_->write(rows, count)
                                     : tiffRows_->write(rows, static_cast<int>(done_), static_cast<int>(count));
    if (!why.empty()) refuse(why);
    if (is(ImageFormat::tiff, path_)) {
        // Rows spread over the picture, including the last one: on a full disk the end is missing.
        const std::size_t stride =
            static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(spec_.channels * spec_.bits / 8);
        const std::int64_t step = spec_.height / keptRows + 1;
        for (std::int64_t y = 0; y < count; ++y) {
            const std::int64_t row = done_ + y;
            if (row % step != 0 && row != spec_.height - 1) continue;
            kept_.push_back(
                {static_cast<int>(row),
                 std::string(static_cast<const char*>(rows) + static_cast<std::size_t>(y) * stride, stride)});
        }
    }
    done_ += count;
}

void PictureStream::finish()
{
    if (std::string why = pngRows_ ? pngRows_->close() : tiffRows_->close(); !why.empty()) refuse(why);
    if (!is(ImageFormat::tiff, path_)) return;
    if (const std::string why = oiioCodec().checkRows(tiff_, kept_); !why.empty()) refuse(why);
}

double storedDpi(const std::filesystem::path& path, double dpi)
{
    if (isPng(path)) return std::round(dpi / 0.0254) * 0.0254;
    if (is(ImageFormat::pdf, path)) return dpi;
    return static_cast<double>(static_cast<float>(dpi));
}

std::optional<std::string> embeddedPrint(const std::filesystem::path& path)
{
    std::string text;
    std::error_code error;
    if (const std::uint64_t size = std::filesystem::file_size(path, error); !error && size > ImageLimits{}.fileBytes) {
        text = PictureRows(path).json();
    } else {
        const std::string bytes = readFile(path, ImageLimits{}.fileBytes);
        if (isPdf(bytes)) return PictureRows(path).json();
        const ImageFormat format = formatOf(bytes, path.string());
        if (format == ImageFormat::png) return textInPng(bytes, printKey, path.string());
        if (format != ImageFormat::tiff) return std::nullopt;
        if (const std::string why = oiioCodec().readText(bytes, format, "ImageDescription", text); !why.empty())
            throw Failure(ErrorKind::file, "Cannot read " + path.string() + ": " + why + ".");
    }
    if (text.empty()) return std::nullopt;
    return text;
}

std::string embeddedProfile(const std::filesystem::path& path)
{
    const std::string bytes = readFile(path, ImageLimits{}.fileBytes);
    const ImageFormat format = formatOf(bytes, path.string());
    if (format == ImageFormat::png) return profileInPng(bytes, path.string());
    if (format == ImageFormat::webp) return webpHeader(bytes).profile;
    if (format == ImageFormat::bmp || format == ImageFormat::gif) return {};
    std::string profile;
    if (const std::string why = oiioCodec().readProfile(bytes, format, profile); !why.empty())
        throw Failure(ErrorKind::file, "Cannot read " + path.string() + ": " + why + ".");
    return profile;
}

}  // namespace vitrine::render
