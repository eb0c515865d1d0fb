#include "tests/support/image_bytes.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace vitrine::test {
namespace {

std::uint32_t crc32(std::string_view bytes)
{
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

constexpr std::string_view base64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string decodeBase64(std::string_view text)
{
    std::string out;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<std::uint32_t>(base64Digits.find(c));
        if ((count += 6) < 8) continue;
        count -= 8;
        out += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
    }
    return out;
}

std::string littleEndian16(std::uint32_t x)
{
    return {static_cast<char>(x & 0xFFU), static_cast<char>(x >> 8U & 0xFFU)};
}

std::string window(const ExrWindow& w)
{
    std::string bytes;
    for (const int x : {w.left, w.top, w.right, w.bottom}) bytes += littleEndian32(static_cast<std::uint32_t>(x));
    return bytes;
}

std::string real32(float x)
{
    return littleEndian32(std::bit_cast<std::uint32_t>(x));
}

/// Encodes a number of an ICC profile: 16 bits before and 16 after the binary point.
std::string fixed16(double x)
{
    return bigEndian32(static_cast<std::uint32_t>(static_cast<std::int32_t>(x * 65536 + (x < 0 ? -0.5 : 0.5))));
}

}  // namespace

std::string littleEndian32(std::uint32_t x)
{
    return littleEndian16(x & 0xFFFFU) + littleEndian16(x >> 16U);
}

std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value)
{
    return name + '\0' + type + '\0' + littleEndian32(static_cast<std::uint32_t>(value.size())) + value;
}

std::string bigEndian32(std::uint32_t x)
{
    std::string bytes = littleEndian32(x);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string pngChunk(const std::string& type, const std::string& data)
{
    return bigEndian32(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian32(crc32(type + data));
}

std::string pngClaiming(std::uint32_t width, std::uint32_t height, int bits, int colorType, const std::string& idat)
{
    const std::string header = bigEndian32(width) + bigEndian32(height) + static_cast<char>(bits) +
                               static_cast<char>(colorType) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", idat) + pngChunk("IEND", "");
}

std::string hdrClaiming(std::uint32_t width, std::uint32_t height, const std::string& rgbe)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) +
           "\n" + rgbe;
}

std::string tiffClaiming(std::uint32_t width, std::uint32_t height, std::uint32_t channels, const std::string& pixels,
                         std::uint32_t orientation)
{
    struct Tag {
        std::uint32_t id, type, count, value;
    };
    constexpr std::uint32_t isShort = 3;
    constexpr std::uint32_t isLong = 4;
    const std::vector<Tag> tags = {{256, isLong, 1, width},
                                   {257, isLong, 1, height},
                                   {258, isShort, 1, 8},
                                   {259, isShort, 1, 1},
                                   {262, isShort, 1, channels == 1 ? 1U : 2U},
                                   {273, isLong, 1, 8},
                                   {274, isShort, 1, orientation},
                                   {277, isShort, 1, channels},
                                   {278, isLong, 1, height},
                                   {279, isLong, 1, static_cast<std::uint32_t>(pixels.size())}};
    std::string padded = pixels;
    if (padded.size() % 2 == 1) padded += '\0';
    std::string bytes =
        std::string("II*\0", 4) + littleEndian32(8 + static_cast<std::uint32_t>(padded.size())) + padded;
    bytes += littleEndian16(static_cast<std::uint32_t>(tags.size()));
    for (const Tag& tag : tags) {
        bytes +=
            littleEndian16(tag.id) + littleEndian16(tag.type) + littleEndian32(tag.count) + littleEndian32(tag.value);
    }
    return bytes + littleEndian32(0);
}

std::string tiledExr(std::uint32_t width, std::uint32_t height, std::uint32_t tile)
{
    const auto real = [](float x) { return littleEndian32(std::bit_cast<std::uint32_t>(x)); };
    const std::string window =
        littleEndian32(0) + littleEndian32(0) + littleEndian32(width - 1) + littleEndian32(height - 1);
    const std::string channel =
        std::string("Y\0", 2) + littleEndian32(2) + std::string(4, '\0') + littleEndian32(1) + littleEndian32(1) + '\0';
    std::string bytes = "\x76\x2f\x31\x01" + littleEndian32(2 | 0x200);
    bytes +=
        exrAttribute("channels", "chlist", channel) + exrAttribute("compression", "compression", std::string(1, '\0'));
    bytes += exrAttribute("dataWindow", "box2i", window) + exrAttribute("displayWindow", "box2i", window);
    bytes += exrAttribute("lineOrder", "lineOrder", std::string(1, '\0')) +
             exrAttribute("pixelAspectRatio", "float", real(1));
    bytes += exrAttribute("screenWindowCenter", "v2f", real(0) + real(0)) +
             exrAttribute("screenWindowWidth", "float", real(1));
    bytes += exrAttribute("tiles", "tiledesc", littleEndian32(tile) + littleEndian32(tile) + '\0') + '\0';

    const std::uint32_t across = (width + tile - 1) / tile;
    const std::uint32_t down = (height + tile - 1) / tile;
    std::string tiles;
    std::string offsets;
    const std::size_t first = bytes.size() + 8UL * across * down;
    for (std::uint32_t ty = 0; ty < down; ++ty) {
        for (std::uint32_t tx = 0; tx < across; ++tx) {
            std::string pixels;
            for (std::uint32_t y = ty * tile; y < std::min(height, (ty + 1) * tile); ++y) {
                for (std::uint32_t x = tx * tile; x < std::min(width, (tx + 1) * tile); ++x)
                    pixels += real(static_cast<float>(x + 100 * y));
            }
            offsets += littleEndian32(static_cast<std::uint32_t>(first + tiles.size())) + littleEndian32(0);
            tiles += littleEndian32(tx) + littleEndian32(ty) + littleEndian32(0) + littleEndian32(0);
            tiles += littleEndian32(static_cast<std::uint32_t>(pixels.size())) + pixels;
        }
    }
    return bytes + offsets + tiles;
}

std::string exrBytes(const std::vector<std::string>& channels, const ExrWindow& data, const ExrWindow& display,
                     const std::string& more)
{
    std::string list;
    for (const std::string& name : channels)
        list += name + '\0' + littleEndian32(2) + std::string(4, '\0') + littleEndian32(1) + littleEndian32(1);
    std::string bytes = "\x76\x2f\x31\x01" + littleEndian32(2);
    bytes += exrAttribute("channels", "chlist", list + '\0');
    bytes += exrAttribute("compression", "compression", std::string(1, '\0'));
    bytes +=
        exrAttribute("dataWindow", "box2i", window(data)) + exrAttribute("displayWindow", "box2i", window(display));
    bytes += exrAttribute("lineOrder", "lineOrder", std::string(1, '\0'));
    bytes += exrAttribute("pixelAspectRatio", "float", real32(1));
    bytes += exrAttribute("screenWindowCenter", "v2f", real32(0) + real32(0));
    bytes += exrAttribute("screenWindowWidth", "float", real32(1)) + more + '\0';

    const auto rows = static_cast<std::size_t>(data.bottom - data.top + 1);
    const std::size_t first = bytes.size() + 8 * rows;
    std::string offsets;
    std::string pixels;
    for (int y = data.top; y <= data.bottom; ++y) {
        std::string row;
        for (std::size_t c = 0; c < channels.size(); ++c)
            for (int x = data.left; x <= data.right; ++x)
                row += real32(static_cast<float>(x + 10 * y) + 100 * static_cast<float>(c));
        offsets += littleEndian32(static_cast<std::uint32_t>(first + pixels.size())) + littleEndian32(0);
        pixels += littleEndian32(static_cast<std::uint32_t>(y)) +
                  littleEndian32(static_cast<std::uint32_t>(row.size())) + row;
    }
    return bytes + offsets + pixels;
}

std::string iccProfile(const std::vector<std::vector<double>>& colorants, double gamma,
                       const std::vector<double>& curve)
{
    const std::vector<std::string> names = {"rXYZ", "gXYZ", "bXYZ", "wtpt", "rTRC", "gTRC", "bTRC"};
    const std::vector<double> white = {0.9642, 1, 0.8249};
    const std::size_t start = 128 + 4 + 12 * names.size();
    std::string table = bigEndian32(static_cast<std::uint32_t>(names.size()));
    std::string values;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string value = i < 4 ? "XYZ " : "curv";
        value += std::string(4, '\0');
        if (i < 4) {
            for (const double x : i < 3 ? colorants[i] : white) value += fixed16(x);
        } else {
            std::vector<std::uint32_t> codes;
            for (const double x : curve) codes.push_back(static_cast<std::uint32_t>(x * 65535 + 0.5));
            if (curve.empty()) codes.push_back(static_cast<std::uint32_t>(gamma * 256 + 0.5));
            value += bigEndian32(static_cast<std::uint32_t>(codes.size()));
            for (const std::uint32_t code : codes) {
                value += static_cast<char>(code >> 8U);
                value += static_cast<char>(code & 0xFFU);
            }
            value.resize((value.size() + 3) / 4 * 4, '\0');
        }
        table += names[i] + bigEndian32(static_cast<std::uint32_t>(start + values.size())) +
                 bigEndian32(static_cast<std::uint32_t>(value.size()));
        values += value;
    }
    std::string head = bigEndian32(static_cast<std::uint32_t>(start + values.size())) + std::string(4, '\0');
    head += bigEndian32(0x02100000) + "mntrRGB XYZ " + std::string(12, '\0') + "acsp" + std::string(28, '\0');
    for (const double x : white) head += fixed16(x);
    head.resize(128, '\0');
    return head + table + values;
}

std::string adobeRgb()
{
    return iccProfile({{0.60974, 0.31111, 0.01947}, {0.20528, 0.62567, 0.06087}, {0.14919, 0.06322, 0.74457}},
                      563.0 / 256);
}

std::string exifBlock(int orientation)
{
    return std::string("II*\0", 4) + littleEndian32(8) + littleEndian16(1) + littleEndian16(0x112) + littleEndian16(3) +
           littleEndian32(1) + littleEndian32(static_cast<std::uint32_t>(orientation)) + littleEndian32(0);
}

std::string unbase64(std::string_view text)
{
    return decodeBase64(text);
}

std::string jpegBytes()
{
    return decodeBase64(
        "/9j/4AAQSkZJRgABAQAAAQABAAD/4QAWRXhpZgAASUkqAAgAAAAAAAAAAAD/2wBDAAEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQ"
        "EBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQH/2wBDAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEBAQEB"
        "AQEBAQEBAQEBAQEBAQEBAQH/wAARCAAIABADAREAAhEBAxEB/8QAHwAAAQUBAQEBAQEAAAAAAAAAAAECAwQFBgcICQoL/8QAtRAAAgEDAwIEAw"
        "UFBAQAAAF9AQIDAAQRBRIhMUEGE1FhByJxFDKBkaEII0KxwRVS0fAkM2JyggkKFhcYGRolJicoKSo0NTY3ODk6Q0RFRkdISUpTVFVWV1hZWmNk"
        "ZWZnaGlqc3R1dnd4eXqDhIWGh4iJipKTlJWWl5iZmqKjpKWmp6ipqrKztLW2t7i5usLDxMXGx8jJytLT1NXW19jZ2uHi4+Tl5ufo6erx8vP09f"
        "b3+Pn6/8QAHwEAAwEBAQEBAQEBAQAAAAAAAAECAwQFBgcICQoL/8QAtREAAgECBAQDBAcFBAQAAQJ3AAECAxEEBSExBhJBUQdhcRMiMoEIFEKR"
        "obHBCSMzUvAVYnLRChYkNOEl8RcYGRomJygpKjU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVmZ2hpanN0dXZ3eHl6goOEhYaHiImKkpOUlZaXmJ"
        "maoqOkpaanqKmqsrO0tba3uLm6wsPExcbHyMnK0tPU1dbX2Nna4uPk5ebn6Onq8vP09fb3+Pn6/9oADAMBAAIRAxEAPwDn6/yvP9sAoA//"
        "2Q==");
}

std::string base64(std::string_view bytes)
{
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : base64Digits[bits >> (18 - 6 * static_cast<unsigned>(k)) & 63U];
    }
    return out;
}

}  // namespace vitrine::test
