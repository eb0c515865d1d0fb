#include "render/image/oiio/rows.h"

#include "render/image/oiio/guarded.h"
#include "render/image/oiio/unlimited.h"
#include "render/image/oiio/write.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstring>

namespace vitrine::render {
namespace {

OIIO::TypeDesc typeOf(const OiioRowTarget& target)
{
    return target.bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
}

/// Returns the pixel aspect. OpenImageIO 2.4.7 changes the vertical resolution unless it equals the aspect times the
/// horizontal one to the last bit.
float aspectFor(float dpiX, float dpiY)
{
    const float aspect = dpiY / dpiX;
    if (aspect * dpiX == dpiY) return aspect;
    for (const float near : {std::nextafter(aspect, 0.0F), std::nextafter(aspect, 2 * aspect)})
        if (near * dpiX == dpiY) return near;
    return aspect;
}

class Rows final : public OiioRows {
public:
    Rows(std::unique_ptr<OIIO::ImageOutput> output, OIIO::TypeDesc type) : output_(std::move(output)), type_(type) {}

    std::string write(const void* rows, int first, int count) noexcept override
    {
        return guarded([&]() -> std::string {
            const bool good = output_->write_scanlines(first, first + count, 0, type_, rows);
            // The writers of 2.4.7 may return true even if the disk is full.
            if (!good || output_->has_error()) return "writing failed (" + output_->geterror() + ")";
            return {};
        });
    }
    std::string close() noexcept override
    {
        return guarded([&]() -> std::string {
            const bool closed = output_->close();
            if (!closed || output_->has_error()) return "closing it failed (" + output_->geterror() + ")";
            return {};
        });
    }

private:
    std::unique_ptr<OIIO::ImageOutput> output_;
    OIIO::TypeDesc type_;
};

}  // namespace

std::string openRowsWithOiio(const OiioRowTarget& target, std::unique_ptr<OiioRows>& out)
{
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("tiff");
    if (!output) return "this OpenImageIO cannot write TIFF";
    OIIO::ImageSpec spec(target.width, target.height, target.channels, typeOf(target));
    if (target.channels == 4) {
        spec.attribute("tiff:ColorSpace", "CMYK");
        spec.channelnames = {"C", "M", "Y", "K"};
        spec.alpha_channel = -1;
    }
    spec.attribute("compression", target.compression);
    if (target.compression != "none") spec.attribute("tiff:predictor", 2);
    if (target.channels == 3)
        spec.attribute("oiio:ColorSpace", "sRGB");
    else
        spec.attribute("Exif:ColorSpace", 0xFFFF);  // Not sRGB. Without an Exif tag, 2.4.7 cannot close the file.
    spec.attribute("XResolution", static_cast<float>(target.dpiX));
    spec.attribute("YResolution", static_cast<float>(target.dpiY));
    spec.attribute("ResolutionUnit", "in");
    spec.attribute("DateTime", timelessDate);
    spec.attribute("PixelAspectRatio", aspectFor(static_cast<float>(target.dpiX), static_cast<float>(target.dpiY)));
    if (!target.description.empty()) spec.attribute("ImageDescription", target.description);
    if (!target.profile.empty()) {
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(target.profile.size())),
                       target.profile.data());
    }
    if (!output->open(target.path, spec)) return "creating it failed (" + output->geterror() + ")";
    out = std::make_unique<Rows>(std::move(output), typeOf(target));
    return {};
}

std::string checkRowsWithOiio(const OiioRowTarget& target, const std::vector<WrittenRow>& rows)
{
    const Unlimited unlimited;
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("tiff");
    OIIO::ImageSpec spec, config;
    config.attribute("oiio:RawColor", 1);  // Inks stay inks.
    if (!input || !input->open(target.path, spec, config)) {
        return "the written file cannot be opened (" + (input ? input->geterror() : std::string()) + ")";
    }
    if (spec.width != target.width || spec.height != target.height || spec.nchannels != target.channels ||
        spec.format != typeOf(target)) {
        return "the written file has another size";
    }
    const auto stored = [&](const char* key) { return static_cast<double>(spec.get_float_attribute(key)); };
    if (std::abs(stored("XResolution") / target.dpiX - 1) > 1e-6 ||
        std::abs(stored("YResolution") / target.dpiY - 1) > 1e-6) {
        return "the written file has another resolution";
    }
    std::string row(spec.scanline_bytes(), '\0');
    for (const WrittenRow& written : rows) {
        if (!input->read_scanline(written.row, 0, typeOf(target), row.data()))
            return "reading it back failed (" + input->geterror() + ")";
        if (row != written.bytes) return "reading it back gave other pixels in row " + std::to_string(written.row);
    }
    return {};
}

}  // namespace vitrine::render
