#include "exhibits/printing/eye_lines.h"

#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr int previewParts = 32;
constexpr int sights = 512;  ///< Number of directions between the two edges of the print.

/// Table of what lenses show, for directions from one edge of the print to the other.
class SightTable {
public:
    SightTable(const Sheet& sheet, double from, double to, double beta)
        : from_(from), perAngle_(to > from ? (sights - 1) / (to - from) : 0)
    {
        const int count = to > from ? sights : 1;
        for (int i = 0; i < count; ++i) {
            std::vector<SeenPoint> points;
            const double theta = count == 1 ? from : from + (to - from) * i / (count - 1);
            for (const Aperture::Part& part : aperture(sheet, theta, beta, previewParts).parts)
                points.push_back({(part.from + part.to) / 2, static_cast<float>(part.share)});
            table_.push_back(std::move(points));
        }
    }
    [[nodiscard]] const std::vector<SeenPoint>& at(double theta) const
    {
        const double i = std::round((theta - from_) * perAngle_);
        return table_[static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(table_.size() - 1)))];
    }

private:
    double from_, perAngle_;
    std::vector<std::vector<SeenPoint>> table_;
};

/// Position of an eye relative to a print whose center is the origin, x to the right and y down, millimeters.
struct SightLine {
    double towardsX = 0, towardsY = 0;  ///< Tangents of the eye's angles, from the center.
    double distance = 0;                ///< Millimeters.
    double cosine = 1, sine = 0;        ///< Direction across the lenses.

    /// Returns the tangent of the line of sight, across the lenses.
    [[nodiscard]] double slope(double x, double y) const
    {
        return (towardsX - x / distance) * cosine + (towardsY - y / distance) * sine;
    }
};

SightTable sightTable(const Sheet& sheet, const SightLine& sight, double width, double height)
{
    double from = 2;
    double to = -2;
    for (const double x : {-width / 2, width / 2}) {
        for (const double y : {-height / 2, height / 2}) {
            from = std::min(from, std::atan(sight.slope(x, y)));
            to = std::max(to, std::atan(sight.slope(x, y)));
        }
    }
    const double along = sight.towardsY * sight.cosine - sight.towardsX * sight.sine;
    const double middle = sight.slope(0, 0);
    return {sheet, from, to, std::asin(along / std::sqrt(1 + middle * middle + along * along))};
}

const std::array<float, 256>& linearOfCode()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = static_cast<float>(render::linearFromSrgb(static_cast<double>(i) / 255.0));
        return made;
    }();
    return table;
}

}  // namespace

EyeLines::EyeLines(const PrintLayout& layout, const Interlacer& interlacer, int lines)
    : layout_(layout), upright_(std::abs(layout.settings().direction) <= 45),
      lines_(static_cast<int>(std::clamp<std::int64_t>(lines, 1, upright_ ? layout.height() : layout.width())))
{
    const std::size_t line = static_cast<std::size_t>(acrossPixels()) * 3;
    codes_.resize(line * static_cast<std::size_t>(lines_));
    for (int i = 0; i < lines_; ++i) {
        std::int64_t at =
            (2 * static_cast<std::int64_t>(i) + 1) * alongPixels() / (2 * static_cast<std::int64_t>(lines_));
        // Lines are stored as seen from the front.
        if (!upright_ && layout.settings().mirror) at = layout.width() - 1 - at;
        const Region region = upright_ ? Region{0, at, layout.width(), at + 1} : Region{at, 0, at + 1, layout.height()};
        interlacer.fill(region, codes_.data() + line * static_cast<std::size_t>(i));
    }
}

CodedPicture EyeLines::seen(const Eye& eye, int side) const
{
    const PrintSettings& s = layout_.settings();
    const double width = static_cast<double>(layout_.width()) / s.dpiX * mmPerInch;
    const double height = static_cast<double>(layout_.height()) / s.dpiY * mmPerInch;
    const double perPixel = std::max(width, height) / std::max(side, 1);
    CodedPicture picture;
    picture.width = std::max(1, static_cast<int>(std::lround(width / perPixel)));
    picture.height = std::max(1, static_cast<int>(std::lround(height / perPixel)));
    picture.rgb.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);

    const SightLine sight{std::tan(upright_ ? eye.angle : eye.angleAlong),
                          upright_ ? -std::tan(eye.angleAlong) : std::tan(eye.angle), eye.distance, layout_.cosine(),
                          layout_.sine()};
    const SightTable table = sightTable(s.sheet, sight, width, height);
    const double pitch = s.sheet.pitch();
    const double perMm = (upright_ ? s.dpiX : s.dpiY) / mmPerInch;
    const double middlePixel = 0.5 * static_cast<double>(acrossPixels());
    std::uint8_t* out = picture.rgb.data();
    for (int row = 0; row < picture.height; ++row) {
        const double y = ((row + 0.5) / picture.height - 0.5) * height;
        for (int column = 0; column < picture.width; ++column, out += 3) {
            const double x = ((column + 0.5) / picture.width - 0.5) * width;
            const double across = x * sight.cosine + y * sight.sine;
            const double off = std::floor(across / pitch + 0.5) * pitch - across;
            const double start = (upright_ ? x : y) * perMm + middlePixel;
            const double along = upright_ ? (row + 0.5) / picture.height : (column + 0.5) / picture.width;
            const std::array<float, 3> color = under(table.at(std::atan(sight.slope(x, y))), start, off, along);
            for (std::size_t c = 0; c < 3; ++c) out[c] = render::srgb8FromLinear(color[c]);
        }
    }
    return picture;
}

std::array<float, 3> EyeLines::under(const std::vector<SeenPoint>& points, double start, double off, double along) const
{
    const PrintSettings& s = layout_.settings();
    const double perMm = (upright_ ? s.dpiX : s.dpiY) / mmPerInch;
    const double perAcross = perMm / (upright_ ? layout_.cosine() : layout_.sine());  // Pixels per mm along a line.
    const bool flip = s.mirror && upright_;
    const auto line = std::min(static_cast<std::size_t>(along * lines_), static_cast<std::size_t>(lines_ - 1));
    const std::uint8_t* codes = codes_.data() + line * static_cast<std::size_t>(acrossPixels()) * 3;
    const std::array<float, 256>& linear = linearOfCode();
    std::array<float, 3> sum{};
    for (const SeenPoint& point : points) {
        const double at = start + (off + point.across) * perAcross;
        if (!(at >= 0 && at < static_cast<double>(acrossPixels()))) {
            for (float& channel : sum) channel += point.share;  // White paper beyond the print.
            continue;
        }
        const auto pixel = flip ? acrossPixels() - 1 - static_cast<std::int64_t>(at) : static_cast<std::int64_t>(at);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += point.share * linear[codes[pixel * 3 + static_cast<std::int64_t>(c)]];
    }
    return sum;
}

}  // namespace vitrine::printing
