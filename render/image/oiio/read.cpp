#include "render/image/oiio/read.h"

#include "render/image/color_channels.h"
#include "render/image/oiio/memory_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace vitrine::render {
namespace {

using Proxy = OIIO::Filesystem::IOProxy;

/// Returns the bytes as a file. The JPEG reader of 2.4.7 accepts only OpenImageIO's own class. It reads the file
/// sequentially, without any offset, so that is safe.
std::unique_ptr<Proxy> fileOf(std::string_view bytes, ImageFormat format)
{
    if (format == ImageFormat::jpeg) return std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size());
    return std::make_unique<MemoryFile>(bytes);
}

/// Opens `file` with one reader. `file` must outlive the result.
std::unique_ptr<OIIO::ImageInput> openWith(Proxy& file, ImageFormat format, std::string& problem)
{
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(fileFormat(format).plugin);
    if (!input || !input->supports("ioproxy")) {
        problem = "this OpenImageIO cannot read the format from memory";
        return nullptr;
    }
    OIIO::ImageSpec config;
    Proxy* proxy = &file;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input->open(std::string("picture.") + fileFormat(format).plugin, spec, config)) {
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
        return "its size is no multiple of its tiles' size, which the OpenImageIO library that Vitrine uses cannot "
               "read safely (the file is good); save it by scanlines";
    }
    return {};
}

/// Indices and names of the channels that are read.
struct ChannelChoice {
    std::vector<int> numbers{};
    std::vector<std::string> names{};
};

ChannelChoice onlyColor(const ColorChannels& color)
{
    ChannelChoice choice{color.numbers(), {}};
    if (color.gray >= 0) choice.names = {"Y"};
    if (color.red >= 0) choice.names = {"R", "G", "B"};
    if (color.alpha >= 0) choice.names.emplace_back("A");
    return choice;
}

/// Chooses all channels: first those of the color, under their plain names, then the others in their order.
ChannelChoice allChannels(const OIIO::ImageSpec& spec)
{
    ChannelChoice choice = onlyColor(colorChannels(spec.channelnames));
    const std::vector<int> color = choice.numbers;
    for (int c = 0; c < spec.nchannels; ++c) {
        if (std::find(color.begin(), color.end(), c) != color.end()) continue;
        choice.numbers.push_back(c);
        choice.names.push_back(spec.channelnames[static_cast<std::size_t>(c)]);
    }
    return choice;
}

/// Goes to the first part of an OpenEXR file that has color, and chooses its channels. Returns a half sentence if there
/// is none.
std::string chooseColor(OIIO::ImageInput& input, ChannelChoice& choice, std::vector<std::string>& warnings)
{
    std::string problem;
    for (int part = 0; input.seek_subimage(part, 0); ++part) {
        const ColorChannels color = colorChannels(input.spec().channelnames);
        if (color.problem.empty()) {
            choice = onlyColor(color);
            const std::string layer = color.layer.empty() ? "the main layer" : "the layer \"" + color.layer + "\"";
            if (!color.otherLayers.empty())
                warnings.push_back("Only " + layer + " is read; the layer \"" + color.otherLayers.front() +
                                   (color.otherLayers.size() > 1 ? "\" and others are ignored." : "\" is ignored."));
            return {};
        }
        if (problem.empty()) problem = color.problem;
    }
    return problem;
}

template <typename Sample>
std::string readRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                     const std::vector<int>& channels, const std::function<bool()>& canceled, StoredPicture& out)
{
    const auto [low, high] = std::minmax_element(channels.begin(), channels.end());
    const int first = *low;
    const int end = *high + 1;
    const auto stored = static_cast<std::size_t>(end - first);
    const bool inOrder = stored == channels.size() && std::is_sorted(channels.begin(), channels.end());
    constexpr std::size_t mostStored = 64;
    if (stored > mostStored) return "its color channels lie too far apart among its others; save them alone";
    std::vector<Sample>& samples = out.samples.emplace<std::vector<Sample>>(out.sampleCount());
    const int band = spec.tile_height > 0 ? spec.tile_height : 64;
    std::vector<Sample> passing(
        inOrder ? 0 : static_cast<std::size_t>(band) * static_cast<std::size_t>(spec.width) * stored);
    for (int row = 0; row < spec.height; row += band) {
        if (canceled && canceled()) return "reading was canceled";
        const int top = spec.y + row;
        const int bottom = spec.y + std::min(row + band, spec.height);
        Sample* at = samples.data() + static_cast<std::size_t>(row) * out.rowSamples();
        Sample* into = inOrder ? at : passing.data();
        const bool good =
            spec.tile_width > 0
                ? input.read_tiles(input.current_subimage(), 0, spec.x, spec.x + spec.width, top, bottom, spec.z,
                                   spec.z + 1, first, end, type, into)
                : input.read_scanlines(input.current_subimage(), 0, top, bottom, spec.z, first, end, type, into);
        if (!good) return "it is broken (" + input.geterror() + ")";
        if (inOrder) continue;
        const std::size_t pixels = static_cast<std::size_t>(bottom - top) * static_cast<std::size_t>(spec.width);
        for (std::size_t p = 0; p < pixels; ++p)
            for (const int channel : channels) *at++ = passing[p * stored + static_cast<std::size_t>(channel - first)];
    }
    return {};
}

/// Crops the picture to its display window; pixels without data become 0.
void showDisplayWindow(const OIIO::ImageSpec& spec, StoredPicture& picture)
{
    const std::vector<float> data = std::move(std::get<std::vector<float>>(picture.samples));
    const std::size_t dataRow = picture.rowSamples();
    picture.width = spec.full_width;
    picture.height = spec.full_height;
    std::vector<float>& shown = picture.samples.emplace<std::vector<float>>(picture.sampleCount(), 0.0F);
    const int left = std::max(spec.x, spec.full_x);
    const int right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    const int top = std::max(spec.y, spec.full_y);
    const int bottom = std::min(spec.y + spec.height, spec.full_y + spec.full_height);
    if (left >= right) return;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto place = [&](int row, int column, std::size_t rowSamples) {
        return static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * rowSamples +
                                           static_cast<std::size_t>(column) * channels);
    };
    for (int y = top; y < bottom; ++y) {
        const auto from = data.begin() + place(y - spec.y, left - spec.x, dataRow);
        std::copy_n(from, static_cast<std::size_t>(right - left) * channels,
                    shown.begin() + place(y - spec.full_y, left - spec.full_x, picture.rowSamples()));
    }
}

/// Divides color by alpha: OpenImageIO 2.4.7 always premultiplies the colors of WebP, whatever is requested.
void divideCodesByAlpha(StoredPicture& picture)
{
    auto& codes = std::get<std::vector<std::uint8_t>>(picture.samples);
    for (std::size_t pixel = 0; pixel < codes.size(); pixel += 4) {
        const int alpha = codes[pixel + 3];
        if (alpha == 0 || alpha == 255) continue;
        for (std::size_t c = pixel; c < pixel + 3; ++c)
            codes[c] = static_cast<std::uint8_t>(std::min((codes[c] * 255 + alpha / 2) / alpha, 255));
    }
}

bool showsAllItHas(const OIIO::ImageSpec& spec)
{
    return spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
           spec.height == spec.full_height;
}

std::string profileOf(const OIIO::ImageSpec& spec)
{
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (!profile) return {};
    return {static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize())};
}

PictureColor colorOf(const OIIO::ImageSpec& spec)
{
    PictureColor color{.profile = profileOf(spec)};
    const OIIO::ParamValue* given = spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
    if (given)
        std::copy_n(static_cast<const float*>(given->data()), color.chromaticities.size(),
                    color.chromaticities.begin());
    return color;
}

/// Goes to the part that is read, and chooses its channels. Returns a half sentence if there are none.
std::string chooseChannels(OIIO::ImageInput& input, ImageFormat format, bool colorOnly, ChannelChoice& choice,
                           std::vector<std::string>& warnings)
{
    const int parts = input.spec().get_int_attribute("oiio:subimages", 1);
    std::string problem;
    if (format != ImageFormat::exr)
        for (int c = 0; c < input.spec().nchannels; ++c) choice.numbers.push_back(c);
    else if (colorOnly)
        problem = chooseColor(input, choice, warnings);
    else
        choice = allChannels(input.spec());
    if (parts > 1) {
        const std::string count = std::to_string(parts);
        warnings.push_back(format == ImageFormat::exr ? "Only one of its " + count + " parts is read."
                                                      : "Only the first of its " + count + " pages is read.");
    }
    return problem;
}

/// Returns why a picture with this specification and number of channels is refused; empty if it may be decoded.
std::string whyTooMuch(const OIIO::ImageSpec& spec, ImageFormat format, std::uint64_t channels, std::size_t fileBytes,
                       const ImageLimits& limits)
{
    const auto positive = [](int n) { return static_cast<std::uint64_t>(std::max(n, 0)); };
    const std::uint64_t sampleBytes = spec.format == OIIO::TypeDesc::UINT8    ? 1
                                      : spec.format == OIIO::TypeDesc::UINT16 ? 2
                                                                              : 4;
    const DeclaredImage stored{positive(spec.width), positive(spec.height), channels, sampleBytes};
    std::string why = whyTooLarge(stored, format, fileBytes, limits);
    if (!why.empty() || format != ImageFormat::exr) return why;
    // A small region of a large picture compresses well, so the size of the file sets no bound.
    constexpr std::uint64_t anyFile = 1ULL << 62U;
    return whyTooLarge({positive(spec.full_width), positive(spec.full_height), channels, 4}, format, anyFile, limits);
}

/// Reads the samples in the type in which they are kept in memory.
std::string readSamples(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, ImageFormat format,
                        const std::vector<int>& channels, const std::function<bool()>& canceled, StoredPicture& out)
{
    std::string why;
    if (format != ImageFormat::exr && spec.format == OIIO::TypeDesc::UINT8) {
        why = readRows<std::uint8_t>(input, spec, OIIO::TypeDesc::UINT8, channels, canceled, out);
        const bool multiplied = format == ImageFormat::webp && out.channels == 4 &&
                                spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
        if (why.empty() && multiplied) divideCodesByAlpha(out);
        return why;
    }
    if (format != ImageFormat::exr && spec.format == OIIO::TypeDesc::UINT16)
        return readRows<std::uint16_t>(input, spec, OIIO::TypeDesc::UINT16, channels, canceled, out);
    if (spec.format != OIIO::TypeDesc::HALF && spec.format != OIIO::TypeDesc::FLOAT)
        out.warnings.push_back("Its samples were converted to 32-bit float.");
    why = readRows<float>(input, spec, OIIO::TypeDesc::FLOAT, channels, canceled, out);
    if (why.empty() && format == ImageFormat::exr && !showsAllItHas(spec)) showDisplayWindow(spec, out);
    return why;
}

}  // namespace

std::string decodeWithOiio(std::string_view bytes, ImageFormat format, const DecodeRequest& request, StoredPicture& out)
{
    const std::unique_ptr<Proxy> file = fileOf(bytes, format);
    std::string problem;
    const std::unique_ptr<OIIO::ImageInput> input = openWith(*file, format, problem);
    if (!input) return problem;
    ChannelChoice choice;
    std::string why = chooseChannels(*input, format, request.colorOnly, choice, out.warnings);
    if (!why.empty()) return why;
    const OIIO::ImageSpec spec = input->spec();
    if (why = whyUnsupported(spec, format); !why.empty()) return why;
    if (why = whyTooMuch(spec, format, choice.numbers.size(), bytes.size(), request.limits); !why.empty()) return why;
    out.width = spec.width;
    out.height = spec.height;
    out.channels = static_cast<int>(choice.numbers.size());
    out.channelNames = choice.names;
    out.orientation = spec.get_int_attribute("Orientation", 1);
    out.color = colorOf(spec);
    return readSamples(*input, spec, format, choice.numbers, request.canceled, out);
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
    out = profileOf(input->spec());
    return {};
}

}  // namespace vitrine::render
