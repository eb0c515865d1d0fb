#include "render/image/oiio/row_reader.h"

#include "render/image/oiio/guarded.h"
#include "render/image/oiio/unlimited.h"

#include <algorithm>

namespace vitrine::render {
namespace {

/// Limit for a strip of the file, which is decoded as a whole.
constexpr std::uint64_t mostStripBytes = 256U << 20U;

class Reader final : public OiioRowReader {
public:
    explicit Reader(std::unique_ptr<OIIO::ImageInput> input) : input_(std::move(input)) {}

    std::string read(int first, int count, void* rows) noexcept override
    {
        return guarded([&]() -> std::string {
            const OIIO::ImageSpec& spec = input_->spec();
            if (!input_->read_scanlines(0, 0, spec.y + first, spec.y + first + count, spec.z, 0, spec.nchannels,
                                        spec.format, rows))
                return "it is broken (" + input_->geterror() + ")";
            return {};
        });
    }

private:
    std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace

std::string openRowReaderWithOiio(const std::string& path, std::unique_ptr<OiioRowReader>& out)
{
    const Unlimited unlimited;
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("tiff");
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    config.attribute("oiio:RawColor", 1);  // Inks stay inks; their profile knows their colors.
    OIIO::ImageSpec spec;
    if (!input || !input->open(path, spec, config))
        return "it is broken (" + (input ? input->geterror() : std::string()) + ")";
    if (spec.deep || spec.depth != 1 || spec.tile_width > 0)
        return "its pixels do not lie in rows; save it as a plain TIFF";
    if (spec.format != OIIO::TypeDesc::UINT8 && spec.format != OIIO::TypeDesc::UINT16)
        return "its samples are neither of 8 nor of 16 bits";
    if (spec.nchannels < 1 || spec.nchannels > 4) return "it has " + std::to_string(spec.nchannels) + " channels";
    const int strip = spec.get_int_attribute("tiff:RowsPerStrip", 1);
    const std::uint64_t rows = static_cast<std::uint64_t>(std::clamp(strip, 1, std::max(spec.height, 1)));
    if (spec.get_string_attribute("compression") != "none" && rows * spec.scanline_bytes() > mostStripBytes)
        return "its rows are packed into strips that are too large";
    auto reader = std::make_unique<Reader>(std::move(input));
    reader->width = spec.width;
    reader->height = spec.height;
    reader->channels = spec.nchannels;
    reader->isInks = spec.get_string_attribute("tiff:ColorSpace") == "CMYK";
    reader->bits = spec.format == OIIO::TypeDesc::UINT8 ? 8 : 16;
    if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile"))
        reader->profile.assign(static_cast<const char*>(profile->data()),
                               static_cast<std::size_t>(profile->datasize()));
    reader->orientation = spec.get_int_attribute("Orientation", 1);
    reader->description = spec.get_string_attribute("ImageDescription");
    out = std::move(reader);
    return {};
}

}  // namespace vitrine::render
