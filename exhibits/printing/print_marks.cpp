#include "exhibits/printing/print_marks.h"

#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::printing {
namespace {

// Lengths in millimeters.
constexpr double markLine = 0.1;      // Width of the lines of marks.
constexpr double markGap = 1;         // Distance of marks from the bleed.
constexpr double markLongest = 6;     // Farthest end of a crop mark from the bleed.
constexpr double markMiddle = 5;      // Half of what registration marks keep free around the middle of a side.
constexpr double patchSide = 4;       // Side of a patch of the color bar.
constexpr double narrowestPatch = 1;  // Least side of a patch.
constexpr double stripDepth = 1.5;

/// Colors of the bar: the inks, their overprints, black and grays.
constexpr std::array<std::array<double, 3>, 11> barColors{{{0, 1, 1},
                                                           {1, 0, 1},
                                                           {1, 1, 0},
                                                           {0, 0, 0},
                                                           {1, 0, 0},
                                                           {0, 1, 0},
                                                           {0, 0, 1},
                                                           {0.25, 0.25, 0.25},
                                                           {0.5, 0.5, 0.5},
                                                           {0.75, 0.75, 0.75},
                                                           {1, 1, 1}}};

Region commonPart(const Region& a, const Region& b)
{
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// Calls `put` with each pixel of a part of the region, and where its three codes are.
template <typename Code, typename Put>
void forEachPixel(const Region& part, const Region& region, Code* rgb, const Put& put)
{
    for (std::int64_t y = part.y0; y < part.y1; ++y)
        for (std::int64_t x = part.x0; x < part.x1; ++x)
            put(x, y, rgb + 3 * ((y - region.y0) * (region.x1 - region.x0) + x - region.x0));
}

template <typename Code> Code codeOf(double value)
{
    return static_cast<Code>(std::lround(value * std::numeric_limits<Code>::max()));
}

}  // namespace

PrintMarks::PrintMarks(const PrintLayout& layout, const std::vector<std::int64_t>& cuts)
    : layout_(layout), perMmX_(layout.settings().dpiX / mmPerInch), perMmY_(layout.settings().dpiY / mmPerInch),
      borderX_(static_cast<double>(layout.borderX())), borderY_(static_cast<double>(layout.borderY()))
{
    const MarkSettings& marks = layout.settings().marks;
    const auto width = static_cast<double>(layout.width()), height = static_cast<double>(layout.height());
    if (marks.crop) addCropMarks(cuts);
    if (marks.registration) {
        addRegistration(width / 2, borderY_ / 2);
        addRegistration(width / 2, height - borderY_ / 2);
        addRegistration(borderX_ / 2, height / 2);
        addRegistration(width - borderX_ / 2, height / 2);
    }
    if (marks.colorBar) addColorBar();
    if (marks.pitchStrip) addPitchStrip();
}

void PrintMarks::addBox(double x0, double y0, double x1, double y1, const Color& color)
{
    const auto whole = [](double from, double to) {
        const std::int64_t first = std::llround(from), last = std::llround(to);
        return std::pair{first, std::max(last, first + 1)};  // A pixel at least.
    };
    const auto [left, right] = whole(x0, x1);
    const auto [top, bottom] = whole(y0, y1);
    boxes_.push_back({{left, top, right, bottom}, color});
}

void PrintMarks::addCropMarks(const std::vector<std::int64_t>& cuts)
{
    const auto width = static_cast<double>(layout_.width()), height = static_cast<double>(layout_.height());
    const auto [left, top, right, bottom] = layout_.trimBox();
    const double thickX = markLine / 2 * perMmX_, thickY = markLine / 2 * perMmY_;
    const double nearX = borderX_ - markGap * perMmX_, farX = std::max(0.0, borderX_ - markLongest * perMmX_);
    const double nearY = borderY_ - markGap * perMmY_, farY = std::max(0.0, borderY_ - markLongest * perMmY_);
    std::vector<double> columns{left, right};
    // The first and the last are the edges of the print.
    for (std::size_t i = 1; i + 1 < cuts.size(); ++i) columns.push_back(static_cast<double>(cuts[i]));
    for (const double x : columns) {
        addBox(x - thickX, farY, x + thickX, nearY);
        addBox(x - thickX, height - nearY, x + thickX, height - farY);
    }
    for (const double y : {top, bottom}) {
        addBox(farX, y - thickY, nearX, y + thickY);
        addBox(width - nearX, y - thickY, width - farX, y + thickY);
    }
}

void PrintMarks::addRegistration(double x, double y)
{
    const double half = std::min({borderX_ / perMmX_, borderY_ / perMmY_, markLongest}) / 2 - markGap / 2;
    const double thickX = markLine / 2 * perMmX_, thickY = markLine / 2 * perMmY_;
    addBox(x - half * perMmX_, y - thickY, x + half * perMmX_, y + thickY);
    addBox(x - thickX, y - half * perMmY_, x + thickX, y + half * perMmY_);
    rings_.push_back({x, y, half * 0.6, std::max(markLine, 1 / std::min(perMmX_, perMmY_))});
}

void PrintMarks::addColorBar()
{
    const double from = layout_.trimBox()[0] + markGap * perMmX_;
    const double room = static_cast<double>(layout_.width()) / 2 - from - markMiddle * perMmX_;
    const double side = std::min(patchSide * perMmX_, room / static_cast<double>(barColors.size()));
    if (side < narrowestPatch * perMmX_)
        throw Failure(ErrorKind::usage, "The print is too narrow for a bar of colors; leave out the bar, or make the "
                                        "print at least " +
                                            std::to_string(2 * (static_cast<int>(barColors.size()) + 6)) + " mm wide.");
    const double y = static_cast<double>(layout_.height()) - borderY_ / 2;
    const double half = (std::min(patchSide, borderY_ / perMmY_ - 2 * markGap)) / 2 * perMmY_;
    for (std::size_t i = 0; i < barColors.size(); ++i)
        addBox(from + side * static_cast<double>(i), y - half, from + side * static_cast<double>(i + 1), y + half,
               barColors.at(i));
}

void PrintMarks::addPitchStrip()
{
    const bool upright = std::abs(layout_.settings().direction) <= 45;
    const auto along = static_cast<double>(upright ? layout_.width() : layout_.height());
    const double depth = upright ? borderY_ : borderX_;
    const double perMm = upright ? perMmX_ : perMmY_, perMmDeep = upright ? perMmY_ : perMmX_;
    const std::int64_t deep0 = std::llround(depth / 2 - stripDepth / 2 * perMmDeep);
    const std::int64_t deep1 = std::llround(depth / 2 + stripDepth / 2 * perMmDeep);
    // Beside the crop marks, and around the registration mark.
    const double first = layout_.trimBox().at(upright ? 0 : 1) + markGap * perMm;
    const std::array<std::pair<double, double>, 2> parts{
        {{first, along / 2 - markMiddle * perMm}, {along / 2 + markMiddle * perMm, along - first}}};
    for (const auto& [from, to] : parts) {
        const std::int64_t begin = std::llround(from), end = std::llround(to);
        if (begin < end)
            lensLines_.push_back(upright ? Region{begin, deep0, end, deep1} : Region{deep0, begin, deep1, end});
    }
}

template <typename Code> void PrintMarks::drawRing(const Ring& ring, const Region& region, Code* rgb) const
{
    const double reach = ring.radius + ring.width;
    const Region around{std::llround(ring.x - reach * perMmX_), std::llround(ring.y - reach * perMmY_),
                        std::llround(ring.x + reach * perMmX_) + 1, std::llround(ring.y + reach * perMmY_) + 1};
    forEachPixel(commonPart(around, region), region, rgb, [&](std::int64_t x, std::int64_t y, Code* codes) {
        const double distance = std::hypot((static_cast<double>(x) + 0.5 - ring.x) / perMmX_,
                                           (static_cast<double>(y) + 0.5 - ring.y) / perMmY_);
        if (std::abs(distance - ring.radius) <= ring.width / 2) std::fill_n(codes, 3, Code{0});
    });
}

template <typename Code> void PrintMarks::drawCodes(const Region& region, Code* rgb) const
{
    for (const Box& box : boxes_)
        forEachPixel(commonPart(box.at, region), region, rgb, [&](std::int64_t, std::int64_t, Code* codes) {
            for (std::size_t c = 0; c < 3; ++c) codes[c] = codeOf<Code>(box.color.at(c));
        });
    for (const Ring& ring : rings_) drawRing(ring, region, rgb);
    const bool mirror = layout_.settings().mirror;
    for (const Region& lines : lensLines_)
        forEachPixel(commonPart(lines, region), region, rgb, [&](std::int64_t x, std::int64_t y, Code* codes) {
            const double center = static_cast<double>(x) + 0.5;
            const double at = layout_.lensAt(mirror ? static_cast<double>(layout_.width()) - center : center,
                                             static_cast<double>(y) + 0.5);
            if (std::abs(at - std::floor(at) - 0.5) <= 0.25) std::fill_n(codes, 3, Code{0});
        });
}

void PrintMarks::draw(const Region& region, std::uint8_t* rgb) const
{
    drawCodes(region, rgb);
}

void PrintMarks::draw(const Region& region, std::uint16_t* rgb) const
{
    drawCodes(region, rgb);
}

}  // namespace vitrine::printing
