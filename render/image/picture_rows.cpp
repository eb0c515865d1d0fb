#include "render/image/picture_rows.h"

#include "render/failure.h"
#include "render/image/picture_formats.h"
#include "render/image/picture_stream.h"

#include <array>
#include <cstring>
#include <fstream>

namespace vitrine::render {

PictureRows::PictureRows(const std::filesystem::path& path) : path_(path)
{
    std::array<char, 16> bytes{};
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Failure(ErrorKind::file, "Cannot read " + path.string() + ": there is no such file.");
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    const std::string_view begin(bytes.data(), static_cast<std::size_t>(file.gcount()));
    const auto format = sniffImage(begin);
    if (format == ImageFormat::png) {
        png_ = std::make_unique<PngRowReader>(path);
        check(png_->begin());
        width_ = png_->width();
        height_ = png_->height();
        bits_ = png_->bits();
        json_ = png_->text(printKey);
    } else if (format == ImageFormat::tiff || isPdf(begin)) {
        check(isPdf(begin) ? oiioCodec().openPdfReader(path.string(), tiff_)
                           : oiioCodec().openRowReader(path.string(), tiff_));
        width_ = tiff_->width;
        height_ = tiff_->height;
        bits_ = tiff_->bits;
        channels_ = static_cast<std::size_t>(tiff_->channels);
        json_ = tiff_->description;
        if (tiff_->isInks) beginInks();
    } else {
        throw Failure(ErrorKind::file, "Cannot read " + path.string() + ": it is neither a TIFF nor a PNG nor a PDF.");
    }
    if (width_ < 1 || height_ < 1) check("it is empty");
    if ((tiff_ ? tiff_->orientation : png_->orientation()) > 1)
        check("it says that it is to be shown turned or mirrored, so that its lenses lie elsewhere; use the file as it "
              "was written");
    stored_.resize(static_cast<std::size_t>(width_) * channels_ * static_cast<std::size_t>(bits_ / 8));
}

void PictureRows::beginInks()
{
    if (profileChannels(tiff_->profile) != 4)
        check("its colors are inks (CMYK) without an ICC profile that says how they look; embed the printer's profile, "
              "or "
              "save it as RGB");
    inks_.emplace(tiff_->profile, srgbProfile(), ConversionSettings{.bits = bits_});
    converted_.resize(static_cast<std::size_t>(width_) * 3 * static_cast<std::size_t>(bits_ / 8));
}

void PictureRows::check(const std::string& why) const
{
    if (!why.empty()) throw Failure(ErrorKind::file, "Cannot read " + path_.string() + ": " + why + ".");
}

void PictureRows::readRow(std::int64_t row, std::uint16_t* out)
{
    if (png_) {
        if (row < next_) {
            check(png_->begin());
            next_ = 0;
        }
        for (; next_ <= row; ++next_) check(png_->read(stored_.data(), 1));
    } else {
        check(tiff_->read(static_cast<int>(row), 1, stored_.data()));
    }
    if (inks_) inks_->apply(stored_.data(), converted_.data(), static_cast<std::size_t>(width_));
    const std::vector<char>& codes = inks_ ? converted_ : stored_;
    const std::size_t channels = inks_ ? 3 : channels_;
    const bool gray = channels < 3;
    for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = x * channels + (gray ? 0 : c);
            std::uint16_t code = 0;
            if (bits_ == 16)
                std::memcpy(&code, codes.data() + at * 2, 2);
            else
                code = static_cast<std::uint16_t>(static_cast<unsigned char>(codes[at]) * 257U);
            *out++ = code;
        }
    }
}

void PictureRows::read(std::int64_t first, std::int64_t count, std::uint16_t* out)
{
    for (std::int64_t row = first; row < first + count; ++row, out += static_cast<std::size_t>(width_) * 3)
        readRow(row, out);
}

}  // namespace vitrine::render
