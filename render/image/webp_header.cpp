#include "render/image/webp_header.h"

#include "render/files/little_endian.h"
#include "render/image/orientation.h"

#include <cstdint>

namespace vitrine::render {
namespace {

DeclaredImage sized(std::uint32_t width, std::uint32_t height)
{
    return {width, height, 4, 1};
}

}  // namespace

WebpHeader webpHeader(std::string_view bytes)
{
    constexpr std::size_t first = 12;
    constexpr std::size_t frame = 8;
    constexpr std::uint32_t fourteenBits = 0x3FFF;
    WebpHeader header;
    for (std::size_t at = first; at + frame <= bytes.size();) {
        const std::string_view type = bytes.substr(at, 4);
        const std::string_view data = bytes.substr(at + frame, littleEndian(bytes, at + 4, 4));
        if (type == "VP8X") {
            header.animated = (littleEndian(data, 0, 1) & 0x02U) != 0;
            header.size = sized(littleEndian(data, 4, 3) + 1, littleEndian(data, 7, 3) + 1);
        } else if (type == "VP8L" && header.size.width == 0) {
            const std::uint32_t both = littleEndian(data, 1, 4);
            header.size = sized((both & fourteenBits) + 1, (both >> 14U & fourteenBits) + 1);
        } else if (type == "VP8 " && header.size.width == 0) {
            header.size = sized(littleEndian(data, 6, 2) & fourteenBits, littleEndian(data, 8, 2) & fourteenBits);
        } else if (type == "EXIF") {
            header.orientation = exifOrientation(data);
        } else if (type == "ICCP") {
            header.profile = std::string(data);
        }
        at += frame + data.size() + data.size() % 2;
    }
    return header;
}

}  // namespace vitrine::render
