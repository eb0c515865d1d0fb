#include "render/image/oiio/read.h"

#include "render/image/oiio/memory_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace vitrine::render {
namespace {

using Proxy = OIIO::Filesystem::IOProxy;

/// The bytes as a file. The JPEG reader of 2.4.7 takes OpenImageIO's own kind only, and reads it in one go
/// without any offset.
std::unique_ptr<Proxy> fileOf(std::string_view bytes, ImageFormat format)
{
    if (format == ImageFormat::jpeg) return std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size());
    return std::make_unique<MemoryFile>(bytes);
}

/// Opens `file` with one reader. `file` must outlive the result.
std::unique_ptr<OIIO::ImageInput> openWith(Proxy& file, ImageFormat format, std::string& problem)
{
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(pluginName(format));
    if (!input || !input->supports("ioproxy")) {
        problem = "this OpenImageIO cannot read the format from memory";
        return nullptr;
    }
    OIIO::ImageSpec config;
    Proxy* proxy = &file;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input->open(std::string("picture.") + pluginName(format), spec, config)) {
        problem = "it is broken (" + input->geterror() + ")";
        return nullptr;
    }
    return input;
}

std::string whyUnsupported(const OIIO::ImageSpec& spec, ImageFormat format)
{
    if (spec.deep) return "it is a deep picture; flatten it first";
    if (spec.depth != 1) return "it is a volume";
    // CVE-2026-63422: the OpenEXR plugin writes beyond its buffer for tiles that stick out of the picture.
    const bool partialTiles =
        spec.tile_width > 0 && (spec.width % spec.tile_width != 0 || spec.height % spec.tile_height != 0);
    if (format == ImageFormat::exr && partialTiles) {
        return "its tiles do not fit its size; save it by scanlines";
    }
    return {};
}

template <typename Sample>
std::string readRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                     const std::function<bool()>& canceled, StoredPicture& out)
{
    std::vector<Sample>& samples = out.samples.emplace<std::vector<Sample>>(out.sampleCount());
    const int band = spec.tile_height > 0 ? spec.tile_height : 64;
    for (int row = 0; row < spec.height; row += band) {
        if (canceled && canceled()) return "reading was canceled";
        const int begin = spec.y + row;
        const int end = spec.y + std::min(row + band, spec.height);
        Sample* at = samples.data() + static_cast<std::size_t>(row) * out.rowSamples();
        const bool good = spec.tile_width > 0
                              ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, spec.z, spec.z + 1, 0,
                                                 spec.nchannels, type, at)
                              : input.read_scanlines(0, 0, begin, end, spec.z, 0, spec.nchannels, type, at);
        if (!good) return "it is broken (" + input.geterror() + ")";
    }
    return {};
}

}  // namespace

const char* pluginName(ImageFormat format)
{
    switch (format) {
    case ImageFormat::png: return "png";
    case ImageFormat::jpeg: return "jpeg";
    case ImageFormat::tiff: return "tiff";
    case ImageFormat::exr: return "openexr";
    case ImageFormat::hdr: return "hdr";
    }
    return "";
}

std::string decodeWithOiio(std::string_view bytes, ImageFormat format, const ImageLimits& limits,
                           const std::function<bool()>& canceled, StoredPicture& out)
{
    const std::unique_ptr<Proxy> file = fileOf(bytes, format);
    std::string problem;
    const std::unique_ptr<OIIO::ImageInput> input = openWith(*file, format, problem);
    if (!input) return problem;
    const OIIO::ImageSpec spec = input->spec();
    if (std::string why = whyUnsupported(spec, format); !why.empty()) return why;

    const OIIO::TypeDesc stored = spec.format;
    const bool is8 = stored == OIIO::TypeDesc::UINT8;
    const bool is16 = stored == OIIO::TypeDesc::UINT16;
    const auto positive = [](int n) { return static_cast<std::uint64_t>(std::max(n, 0)); };
    const DeclaredImage declared{positive(spec.width), positive(spec.height), positive(spec.nchannels),
                                 is8    ? 1U
                                 : is16 ? 2U
                                        : 4U};
    if (std::string why = whyTooLarge(declared, format, bytes.size(), limits); !why.empty()) return why;

    out.width = spec.width;
    out.height = spec.height;
    out.channels = spec.nchannels;
    if (format == ImageFormat::exr) {
        out.channelNames = spec.channelnames;
        if (spec.get_int_attribute("oiio:subimages", 1) > 1)
            out.warnings.push_back("Only the first of its parts was read.");
        if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
            spec.height != spec.full_height) {
            out.warnings.push_back("Its data window differs from its display window: the data window was read.");
        }
    }
    const bool isReal = stored == OIIO::TypeDesc::HALF || stored == OIIO::TypeDesc::FLOAT;
    if (!is8 && !is16 && !isReal) out.warnings.push_back("Its samples were converted to 32-bit float.");
    if (is8) return readRows<std::uint8_t>(*input, spec, OIIO::TypeDesc::UINT8, canceled, out);
    if (is16) return readRows<std::uint16_t>(*input, spec, OIIO::TypeDesc::UINT16, canceled, out);
    return readRows<float>(*input, spec, OIIO::TypeDesc::FLOAT, canceled, out);
}

std::string readTextWithOiio(std::string_view bytes, ImageFormat format, const std::string& key, std::string& out)
{
    const std::unique_ptr<Proxy> file = fileOf(bytes, format);
    std::string problem;
    const std::unique_ptr<OIIO::ImageInput> input = openWith(*file, format, problem);
    if (!input) return problem;
    out = input->spec().get_string_attribute(key);
    return {};
}

std::string readProfileWithOiio(std::string_view bytes, ImageFormat format, std::string& out)
{
    const std::unique_ptr<Proxy> file = fileOf(bytes, format);
    std::string problem;
    const std::unique_ptr<OIIO::ImageInput> input = openWith(*file, format, problem);
    if (!input) return problem;
    if (const OIIO::ParamValue* profile = input->spec().find_attribute("ICCProfile")) {
        out.assign(static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize()));
    }
    return {};
}

}  // namespace vitrine::render
