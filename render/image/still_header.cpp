#include "render/image/still_header.h"

#include "render/files/little_endian.h"

#include <cstdint>
#include <cstdlib>

namespace vitrine::render {
namespace {

DeclaredImage sizeOf(std::int64_t width, std::int64_t height)
{
    if (width < 1 || height < 1) return {0, 0, 4, 1};
    return {static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), 4, 1};
}

/// Returns the bytes of the color table that the flags of a screen or of a picture announce.
std::size_t colorTable(std::uint32_t flags)
{
    return (flags & 0x80U) != 0 ? std::size_t{3} << ((flags & 7U) + 1) : 0;
}

/// Skips blocks of at most 255 bytes and the empty block after them. Returns false if the file ends before.
bool skipBlocks(std::string_view bytes, std::size_t& at)
{
    while (at < bytes.size()) {
        const auto count = static_cast<unsigned char>(bytes[at]);
        at += 1U + count;
        if (count == 0) return true;
    }
    return false;
}

}  // namespace

StillHeader bmpHeader(std::string_view bytes)
{
    constexpr std::uint32_t ofOs2 = 12;
    if (littleEndian(bytes, 14, 4) == ofOs2)
        return {.size = sizeOf(littleEndian(bytes, 18, 2), littleEndian(bytes, 20, 2))};
    // The height is negative if the rows are stored from the top down.
    const std::int64_t height = static_cast<std::int32_t>(littleEndian(bytes, 22, 4));
    return {.size = sizeOf(static_cast<std::int32_t>(littleEndian(bytes, 18, 4)), std::abs(height))};
}

StillHeader gifHeader(std::string_view bytes)
{
    constexpr char picture = '\x2C', extension = '\x21';
    StillHeader header{.size = sizeOf(littleEndian(bytes, 6, 2), littleEndian(bytes, 8, 2)), .pictures = 0};
    std::size_t at = 13 + colorTable(littleEndian(bytes, 10, 1));
    while (at < bytes.size() && (bytes[at] == picture || bytes[at] == extension)) {
        if (bytes[at] == picture) {
            ++header.pictures;
            at += 11 + colorTable(littleEndian(bytes, at + 9, 1));  // Includes the byte with the size of the codes.
        } else {
            at += 2;
        }
        header.whole = skipBlocks(bytes, at);
    }
    return header;
}

}  // namespace vitrine::render
