#include "render/image/oiio/write.h"

#include "render/image/oiio/read.h"

#include <OpenImageIO/half.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace vitrine::render {
namespace {

constexpr int bandRows = 64;

bool isColor(const std::string& name)
{
    return name == "R" || name == "G" || name == "B" || name == "A";
}

OIIO::ImageSpec specFor(const StoredPicture& picture, const OiioTarget& target)
{
    const std::array<OIIO::TypeDesc, 3> types = {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::FLOAT};
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, types.at(picture.samples.index()));
    if (!picture.channelNames.empty()) spec.channelnames = picture.channelNames;
    if (target.halfColor) {
        for (const std::string& name : picture.channelNames) {
            spec.channelformats.push_back(isColor(name) ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
        }
    }
    if (target.format == ImageFormat::exr) {
        spec.attribute("compression", "zip");
        constexpr std::array<float, 8> rec709{0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), rec709.data());
        for (const auto& [key, matrix] : target.matrices) spec.attribute(key, OIIO::TypeMatrix, matrix.data());
    } else if (target.format == ImageFormat::jpeg) {
        spec.attribute("compression", "jpeg:92");
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else {
        // LZW with a horizontal predictor: lossless, and readable by the software of every print shop.
        spec.attribute("compression", "lzw");
        spec.attribute("tiff:predictor", 2);
        spec.attribute("oiio:ColorSpace", "sRGB");
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    if (target.pixelsPerInch > 0) {
        spec.attribute("XResolution", static_cast<float>(target.pixelsPerInch));
        spec.attribute("YResolution", static_cast<float>(target.pixelsPerInch));
        spec.attribute("ResolutionUnit", "in");
    }
    spec.attribute("DateTime", timelessDate);
    for (const auto& [key, text] : target.texts) spec.attribute(key, text);
    return spec;
}

template <typename Sample>
std::string writeRows(OIIO::ImageOutput& output, const StoredPicture& picture, const std::vector<Sample>& samples)
{
    const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Sample>::value;
    for (int row = 0; row < picture.height; row += bandRows) {
        const Sample* at = samples.data() + static_cast<std::size_t>(row) * picture.rowSamples();
        const bool good = output.write_scanlines(row, std::min(row + bandRows, picture.height), 0, type, at);
        // The writers of 2.4.7 may return true even if the disk is full.
        if (!good || output.has_error()) return "writing failed (" + output.geterror() + ")";
    }
    return {};
}

bool same(std::uint8_t a, std::uint8_t b)
{
    return a == b;
}
bool same(std::uint16_t a, std::uint16_t b)
{
    return a == b;
}
bool same(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}

/// Returns the index of each channel of `picture` in a file with the channels `names`; empty if one is missing.
std::vector<std::size_t> channelMap(const StoredPicture& picture, const std::vector<std::string>& names)
{
    std::vector<std::size_t> map(static_cast<std::size_t>(picture.channels));
    for (std::size_t c = 0; c < map.size(); ++c) {
        map[c] = c;
        if (picture.channelNames.empty()) continue;
        const auto found = std::find(names.begin(), names.end(), picture.channelNames[c]);
        if (found == names.end()) return {};
        map[c] = static_cast<std::size_t>(found - names.begin());
    }
    return map;
}

/// Compares within a tolerance: JPEG returns similar codes, but the rows of a truncated file are gray.
std::string compareLossy(OIIO::ImageInput& input, const StoredPicture& picture)
{
    const auto& written = std::get<std::vector<std::uint8_t>>(picture.samples);
    std::vector<std::uint8_t> rows(written.size());
    if (!input.read_image(0, 0, 0, picture.channels, OIIO::TypeDesc::UINT8, rows.data()))
        return "reading it back failed (" + input.geterror() + ")";
    double sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) sum += std::abs(rows[i] - written[i]);
    constexpr double mostMean = 8;  // In codes: white noise at quality 92 stays below 5.
    return sum > mostMean * static_cast<double>(rows.size()) ? "reading it back gave other pixels" : "";
}

template <typename Sample>
std::string compareParameters(OIIO::ImageInput& input, const StoredPicture& picture, const std::vector<Sample>& written,
                              bool halfColor)
{
    const std::vector<std::size_t> map = channelMap(picture, input.spec().channelnames);
    if (map.empty()) return "the file lost a channel";
    const std::size_t channels = map.size();
    std::vector<Sample> row(picture.rowSamples());
    // 256 rows spread over the picture, including the last one: on a full disk the end is missing.
    const int step = std::max(1, (picture.height + 254) / 255);
    for (int y = 0;; y = std::min(y + step, picture.height - 1)) {
        if (!input.read_scanline(y, 0, OIIO::BaseTypeFromC<Sample>::value, row.data())) {
            return "reading it back failed (" + input.geterror() + ")";
        }
        const Sample* expected = written.data() + static_cast<std::size_t>(y) * picture.rowSamples();
        for (std::size_t i = 0; i < row.size(); ++i) {
            Sample want = expected[i];
            if constexpr (std::is_same_v<Sample, float>) {
                if (halfColor && isColor(picture.channelNames[i % channels])) want = static_cast<float>(half(want));
            }
            if (!same(want, row[i / channels * channels + map[i % channels]])) {
                return "reading it back gave other pixels in row " + std::to_string(y);
            }
        }
        if (y == picture.height - 1) return {};
    }
}

std::string verify(const StoredPicture& picture, const OiioTarget& target)
{
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(fileFormat(target.format).plugin);
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input || !input->open(target.path, spec, config)) {
        return "the written file cannot be opened (" + (input ? input->geterror() : std::string()) + ")";
    }
    if (spec.width != picture.width || spec.height != picture.height || spec.nchannels != picture.channels) {
        return "the written file has another size";
    }
    if (target.format == ImageFormat::jpeg) return compareLossy(*input, picture);
    return std::visit(
        [&](const auto& samples) { return compareParameters(*input, picture, samples, target.halfColor); },
        picture.samples);
}

}  // namespace

std::string writeWithOiio(const StoredPicture& picture, const OiioTarget& target)
{
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(fileFormat(target.format).plugin);
    if (!output) return "this OpenImageIO cannot write the format";
    if (!output->open(target.path, specFor(picture, target))) return "creating it failed (" + output->geterror() + ")";
    std::string problem =
        std::visit([&](const auto& samples) { return writeRows(*output, picture, samples); }, picture.samples);
    const bool closed = output->close();
    if (!problem.empty()) return problem;
    if (!closed || output->has_error()) return "closing it failed (" + output->geterror() + ")";
    return verify(picture, target);
}

}  // namespace vitrine::render
