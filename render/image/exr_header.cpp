#include "render/image/exr_header.h"

#include "render/files/little_endian.h"
#include "render/image/color_channels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::render {
namespace {

const std::string cutShort = "it is broken: its header claims more than the file holds";

/// Reader of the header's bytes, from front to back.
class ExrBytes {
public:
    explicit ExrBytes(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] std::size_t left() const { return rest_.size(); }
    [[nodiscard]] std::optional<std::string_view> take(std::size_t count)
    {
        if (count > rest_.size()) return std::nullopt;
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    /// Reads the characters up to a zero byte, which is skipped.
    [[nodiscard]] std::optional<std::string_view> text()
    {
        constexpr std::size_t longest = 256;
        const std::size_t end = rest_.substr(0, longest).find('\0');
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view taken = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return taken;
    }

private:
    std::string_view rest_;
};

std::int64_t int32At(std::string_view bytes, std::size_t at)
{
    return static_cast<std::int32_t>(littleEndian(bytes, at));
}

/// Header of one part of the file.
struct ExrPart {
    std::int64_t width = 1, height = 1;
    std::int64_t tileWidth = 0, tileHeight = 0;
    std::int64_t rowsPerChunk = 1;
    std::vector<std::string> names{};
    bool subsampled = false;
    bool farOff = false;  ///< A data or display window is so far away that sums of its coordinates and sides overflow.
};

/// Returns the rows per chunk for the number of a compression; the largest number for an unknown one.
std::int64_t rowsPerChunk(std::string_view compression)
{
    if (compression.empty()) return 256;
    switch (compression.front()) {
    case 0:             // None.
    case 1:             // RLE.
    case 2: return 1;   // ZIPS.
    case 3:             // ZIP.
    case 5: return 16;  // PXR24.
    case 4:             // PIZ.
    case 6:             // B44.
    case 7:             // B44A.
    case 8: return 32;  // DWAA.
    default: return 256;
    }
}

/// Reads the channel list of a part; false where the list does not end with its attribute.
bool readChannels(std::string_view list, ExrPart& part)
{
    ExrBytes bytes(list);
    while (true) {
        const auto name = bytes.text();
        if (!name) return false;
        if (name->empty()) return bytes.left() == 0;
        const auto rest = bytes.take(16);  // Type, pLinear with three unused bytes, xSampling, ySampling.
        if (!rest) return false;
        part.names.emplace_back(*name);
        part.subsampled = part.subsampled || int32At(*rest, 8) != 1 || int32At(*rest, 12) != 1;
    }
}

/// True if a list of texts, each behind its length of 4 bytes, ends with its attribute.
bool isTextList(std::string_view list)
{
    ExrBytes bytes(list);
    while (bytes.left() > 0) {
        const auto length = bytes.take(4);
        if (!length) return false;
        const std::int64_t size = int32At(*length, 0);
        if (size < 0 || !bytes.take(static_cast<std::size_t>(size))) return false;
    }
    return true;
}

/// Bytes of a preview of 8-bit RGBA pixels behind its width and height; unset where the attribute is too short for
/// both.
std::optional<std::uint64_t> previewBytes(std::string_view value)
{
    if (value.size() < 8) return std::nullopt;
    const std::uint64_t width = littleEndian(value, 0), height = littleEndian(value, 4);
    if (width > value.size() || height > value.size()) return std::nullopt;  // Their product could overflow.
    return 8 + 4 * width * height;
}

/// True if the value has as many bytes as OpenEXR reads for its type. OpenEXR does not hold a value's stated length
/// against its type, so a wrong one would make it read the rest of the header from the wrong place, with lengths that
/// nothing checked. Source of the sizes: openexr.com/en/latest/OpenEXRFileLayout.html, "Predefined Attribute Types".
bool fitsType(std::string_view type, std::string_view value)
{
    struct TypeSize {
        std::string_view type;
        std::size_t bytes;
    };
    static constexpr std::array sizes{
        TypeSize{"box2f", 16},      TypeSize{"box2i", 16},   TypeSize{"chromaticities", 32},
        TypeSize{"compression", 1}, TypeSize{"double", 8},   TypeSize{"envmap", 1},
        TypeSize{"float", 4},       TypeSize{"int", 4},      TypeSize{"keycode", 28},
        TypeSize{"lineOrder", 1},   TypeSize{"m33d", 72},    TypeSize{"m33f", 36},
        TypeSize{"m44d", 128},      TypeSize{"m44f", 64},    TypeSize{"rational", 8},
        TypeSize{"tiledesc", 9},    TypeSize{"timecode", 8}, TypeSize{"v2d", 16},
        TypeSize{"v2f", 8},         TypeSize{"v2i", 8},      TypeSize{"v3d", 24},
        TypeSize{"v3f", 12},        TypeSize{"v3i", 12},     TypeSize{"deepImageState", 1},
    };
    if (type == "stringvector") return isTextList(value);
    if (type == "preview") return previewBytes(value) == value.size();
    const auto* found =
        std::find_if(sizes.begin(), sizes.end(), [&](const TypeSize& size) { return size.type == type; });
    return found == sizes.end() || found->bytes == value.size();
}

bool isFarOff(std::string_view window)
{
    constexpr std::int64_t most = 1 << 28;
    for (std::size_t at = 0; at < 16; at += 4)
        if (std::abs(int32At(window, at)) > most) return true;
    return false;
}

/// Keeps what an attribute claims about its part; false where the value has not the form of its name or type.
bool keep(std::string_view name, std::string_view type, std::string_view value, ExrPart& part)
{
    static constexpr std::array types{std::pair{"dataWindow", "box2i"}, std::pair{"displayWindow", "box2i"},
                                      std::pair{"tiles", "tiledesc"}, std::pair{"compression", "compression"},
                                      std::pair{"channels", "chlist"}};
    for (const auto& [attribute, expected] : types)
        if (name == attribute && type != expected) return false;
    if (!fitsType(type, value)) return false;
    if (name == "dataWindow" || name == "displayWindow") part.farOff = part.farOff || isFarOff(value);
    if (name == "dataWindow") {
        part.width = int32At(value, 8) - int32At(value, 0) + 1;
        part.height = int32At(value, 12) - int32At(value, 4) + 1;
    } else if (name == "tiles") {
        part.tileWidth = std::max<std::int64_t>(int32At(value, 0), 1);
        part.tileHeight = std::max<std::int64_t>(int32At(value, 4), 1);
    } else if (name == "compression") {
        part.rowsPerChunk = rowsPerChunk(value);
    } else if (type == "chlist") {
        return readChannels(value, part);
    }
    return true;
}

std::string whyPartRefused(const ExrPart& part, std::size_t fileBytes, const ImageLimits& limits)
{
    if (part.width < 1 || part.height < 1) return "it has no pixels";
    const auto width = static_cast<std::uint64_t>(part.width);
    const auto height = static_cast<std::uint64_t>(part.height);
    const DeclaredImage size{width, height, 1, 0};
    if (std::string why = whyTooLarge(size, ImageFormat::exr, fileBytes, limits); !why.empty()) return why;
    if (part.farOff) return "its windows lie too far from the origin";
    // OpenEXR allocates a whole chunk when it opens the file, and several for its threads.
    constexpr std::int64_t mostChunkBytes = 512LL << 20U;
    const auto channels = static_cast<std::int64_t>(part.names.size());
    const std::int64_t chunkPixels =
        part.tileWidth > 0 ? part.tileWidth * part.tileHeight : part.width * std::min(part.rowsPerChunk, part.height);
    if (chunkPixels > mostChunkBytes / 4 / std::max<std::int64_t>(channels, 1))
        return "it is packed in pieces of more than 512 MiB; save it in smaller ones";
    // Each chunk of pixels has an entry of 8 bytes in a table.
    const auto parts = [](std::int64_t whole, std::int64_t part_) { return (whole + part_ - 1) / part_; };
    const std::int64_t chunks = part.tileWidth > 0
                                    ? parts(part.width, part.tileWidth) * parts(part.height, part.tileHeight)
                                    : parts(part.height, part.rowsPerChunk);
    if (static_cast<std::uint64_t>(chunks) * 8 > fileBytes) return cutShort;
    // OpenImageIO 2.5 fails to read chroma, even at the full resolution.
    const ColorChannels colors = colorChannels(part.names);
    if (colors.isLuminanceChroma) return colors.problem;
    if (!part.subsampled) return {};
    if (!colors.problem.empty()) return colors.problem;
    return "some of its channels are stored at a lower resolution, which is not read; save all at the full one";
}

}  // namespace

std::string whyExrRefused(std::string_view bytes, const ImageLimits& limits)
{
    constexpr std::uint32_t multipart = 0x1000;
    ExrBytes header(bytes);
    const auto start = header.take(8);
    if (!start) return "it is broken: it ends within its header";
    const bool several = (static_cast<std::uint32_t>(int32At(*start, 4)) & multipart) != 0;
    do {
        ExrPart part;
        bool any = false;
        while (true) {
            const auto name = header.text();
            if (!name) return cutShort;
            if (name->empty()) break;
            const auto type = header.text();
            const auto length = header.take(4);
            if (!type || !length) return cutShort;
            const std::int64_t size = int32At(*length, 0);
            if (size < 0 || static_cast<std::uint64_t>(size) > header.left())
                return "it is broken: its attribute \"" + std::string(*name) + "\" claims " +
                       std::to_string(static_cast<std::uint32_t>(size)) + " bytes, and the file has " +
                       std::to_string(header.left()) + " left";
            any = true;
            if (!keep(*name, *type, *header.take(static_cast<std::size_t>(size)), part))
                return "it is broken: its attribute \"" + std::string(*name) + "\" does not have the size of its type";
        }
        if (!any) return several ? std::string() : cutShort;  // An empty header ends the list.
        if (std::string why = whyPartRefused(part, bytes.size(), limits); !why.empty()) return why;
    } while (several);
    return {};
}

}  // namespace vitrine::render
