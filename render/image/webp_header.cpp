#include "render/image/webp_header.h"

#include "render/image/orientation.h"

#include <cstdint>

namespace vitrine::render {
namespace {

std::uint32_t bits(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::uint32_t x = 0;
    if (at + count > bytes.size()) return 0;
    for (std::size_t i = count; i > 0; --i) x = x << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
    return x;
}

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
        const std::string_view data = bytes.substr(at + frame, bits(bytes, at + 4, 4));
        if (type == "VP8X") {
            header.animated = (bits(data, 0, 1) & 0x02U) != 0;
            header.size = sized(bits(data, 4, 3) + 1, bits(data, 7, 3) + 1);
        } else if (type == "VP8L" && header.size.width == 0) {
            const std::uint32_t both = bits(data, 1, 4);
            header.size = sized((both & fourteenBits) + 1, (both >> 14U & fourteenBits) + 1);
        } else if (type == "VP8 " && header.size.width == 0) {
            header.size = sized(bits(data, 6, 2) & fourteenBits, bits(data, 8, 2) & fourteenBits);
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
