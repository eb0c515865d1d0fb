#include "render/image/orientation.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vitrine::render {
namespace {

/// Exif block; its first bytes give its byte order.
class ExifBlock {
public:
    explicit ExifBlock(std::string_view bytes) : bytes_(bytes), bigEndian_(bytes.starts_with("MM")) {}
    /// Returns the number of `size` bytes at offset `at`; 0 beyond the end.
    [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t size) const
    {
        if (at > bytes_.size() || size > bytes_.size() - at) return 0;
        std::uint32_t x = 0;
        for (std::size_t i = 0; i < size; ++i)
            x = x << 8U | static_cast<unsigned char>(bytes_[at + (bigEndian_ ? i : size - 1 - i)]);
        return x;
    }

private:
    std::string_view bytes_;
    bool bigEndian_;
};

/// Position of a visible pixel in the stored picture.
struct StoredPlace {
    std::size_t x, y;
};

StoredPlace storedPlace(int orientation, std::size_t x, std::size_t y, std::size_t width, std::size_t height)
{
    const std::size_t right = width - 1 - x;
    const std::size_t below = height - 1 - y;
    switch (orientation) {
    case 2: return {right, y};
    case 3: return {right, below};
    case 4: return {x, below};
    case 5: return {y, x};
    case 6: return {y, right};
    case 7: return {below, right};
    case 8: return {below, x};
    default: return {x, y};
    }
}

}  // namespace

int exifOrientation(std::string_view block)
{
    constexpr std::uint32_t tag = 0x0112;
    constexpr std::uint32_t isShort = 3;
    constexpr std::size_t entryBytes = 12;
    if (block.starts_with(std::string_view("Exif\0\0", 6))) block.remove_prefix(6);
    if (!block.starts_with("II") && !block.starts_with("MM")) return 1;
    const ExifBlock exif(block);
    if (exif.number(2, 2) != 42) return 1;
    const std::size_t directory = exif.number(4, 4);
    const std::size_t count = exif.number(directory, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + 2 + i * entryBytes;
        if (exif.number(entry, 2) != tag) continue;
        const std::uint32_t value = exif.number(entry + 8, exif.number(entry + 2, 2) == isShort ? 2 : 4);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

int hdrOrientation(std::string_view file)
{
    const std::size_t empty = file.find("\n\n");
    if (empty == std::string_view::npos) return 1;
    const std::string_view line = file.substr(empty + 2, 80);
    if (line.size() < 2) return 1;
    const std::size_t second = line.find_first_of("+-", 2);
    if (second == std::string_view::npos || second + 2 > line.size()) return 1;
    struct Row {
        std::string_view first, second;
        int orientation;
    };
    constexpr std::array<Row, 8> rows = {{{"-Y", "+X", 1},
                                          {"-Y", "-X", 2},
                                          {"+Y", "-X", 3},
                                          {"+Y", "+X", 4},
                                          {"+X", "-Y", 5},
                                          {"-X", "-Y", 6},
                                          {"-X", "+Y", 7},
                                          {"+X", "+Y", 8}}};
    for (const Row& row : rows)
        if (line.substr(0, 2) == row.first && line.substr(second, 2) == row.second) return row.orientation;
    return 1;
}

void orient(StoredPicture& picture, int orientation)
{
    if (orientation <= 1 || orientation > 8) return;
    const auto storedWidth = static_cast<std::size_t>(picture.width);
    const auto channels = static_cast<std::size_t>(picture.channels);
    if (orientation >= 5) std::swap(picture.width, picture.height);
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    std::visit(
        [&](auto& samples) {
            auto turned = samples;
            auto out = turned.begin();
            for (std::size_t y = 0; y < height; ++y) {
                for (std::size_t x = 0; x < width; ++x) {
                    const StoredPlace at = storedPlace(orientation, x, y, width, height);
                    const auto from =
                        samples.begin() + static_cast<std::ptrdiff_t>((at.y * storedWidth + at.x) * channels);
                    out = std::copy_n(from, channels, out);
                }
            }
            samples = std::move(turned);
        },
        picture.samples);
}

}  // namespace vitrine::render
