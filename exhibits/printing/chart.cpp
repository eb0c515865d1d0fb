#include "exhibits/printing/chart.h"

#include "exhibits/printing/sheet.h"
#include "render/failure.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace vitrine::printing {
namespace {

struct Letter {
    char name;
    std::array<unsigned char, 7> rows;  ///< Five cells per row, the left one in bit 4.
};

constexpr std::array<Letter, 41> letters{{
    {'0', {0x0E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}}, {'1', {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E}},
    {'2', {0x0E, 0x11, 0x01, 0x06, 0x08, 0x10, 0x1F}}, {'3', {0x1E, 0x01, 0x01, 0x0E, 0x01, 0x01, 0x1E}},
    {'4', {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02}}, {'5', {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E}},
    {'6', {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E}}, {'7', {0x1F, 0x01, 0x02, 0x02, 0x04, 0x04, 0x04}},
    {'8', {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E}}, {'9', {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C}},
    {'A', {0x04, 0x0A, 0x11, 0x11, 0x1F, 0x11, 0x11}}, {'B', {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E}},
    {'C', {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E}}, {'D', {0x1E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1E}},
    {'E', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F}}, {'F', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x10}},
    {'G', {0x0E, 0x11, 0x10, 0x13, 0x11, 0x11, 0x0F}}, {'H', {0x11, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}},
    {'I', {0x0E, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E}}, {'J', {0x07, 0x02, 0x02, 0x02, 0x02, 0x12, 0x0C}},
    {'K', {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}}, {'L', {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1F}},
    {'M', {0x11, 0x1B, 0x15, 0x15, 0x11, 0x11, 0x11}}, {'N', {0x11, 0x19, 0x15, 0x15, 0x13, 0x11, 0x11}},
    {'O', {0x0E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}}, {'P', {0x1E, 0x11, 0x11, 0x1E, 0x10, 0x10, 0x10}},
    {'Q', {0x0E, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0D}}, {'R', {0x1E, 0x11, 0x11, 0x1E, 0x14, 0x12, 0x11}},
    {'S', {0x0F, 0x10, 0x10, 0x0E, 0x01, 0x01, 0x1E}}, {'T', {0x1F, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
    {'U', {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}}, {'V', {0x11, 0x11, 0x11, 0x11, 0x0A, 0x0A, 0x04}},
    {'W', {0x11, 0x11, 0x11, 0x15, 0x15, 0x1B, 0x11}}, {'X', {0x11, 0x11, 0x0A, 0x04, 0x0A, 0x11, 0x11}},
    {'Y', {0x11, 0x11, 0x0A, 0x04, 0x04, 0x04, 0x04}}, {'Z', {0x1F, 0x01, 0x02, 0x04, 0x08, 0x10, 0x1F}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0C, 0x0C}}, {'-', {0x00, 0x00, 0x00, 0x1F, 0x00, 0x00, 0x00}},
    {'/', {0x01, 0x02, 0x02, 0x04, 0x08, 0x08, 0x10}}, {':', {0x00, 0x0C, 0x0C, 0x00, 0x0C, 0x0C, 0x00}},
    {'%', {0x18, 0x19, 0x02, 0x04, 0x08, 0x13, 0x03}},
}};

}  // namespace

bool textCell(const std::string& text, int column, int row)
{
    if (column < 0 || row < 0 || row >= 7 || column % 6 == 5) return false;
    const auto at = static_cast<std::size_t>(column / 6);
    if (at >= text.size()) return false;
    for (const Letter& letter : letters)
        if (letter.name == text[at]) return ((letter.rows[static_cast<std::size_t>(row)] >> (4 - column % 6)) & 1) != 0;
    return false;
}

namespace {

constexpr double margin = 10;     ///< Millimeters of paper around the bands, for ruler, title and marks.
constexpr double bandHeight = 8;  ///< Millimeters, of which `gap` is paper with the band's value.
constexpr double gap = 3;
constexpr double cell = 0.25;  ///< Size of a letter's cell, millimeters; letters are 1.75 mm high.
constexpr int pitchBands = 11;

std::string fixed(double value, int digits)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    return text.data();
}

PrintLayout changed(const PrintLayout& layout, double lpi, double phase, int views)
{
    PrintSettings s = layout.settings();
    s.visualLpi = lpi;
    s.phase = phase;
    s.views = views;
    if (s.method == Method::nearest) s.method = Method::area;  // A chart must not have jumping edges.
    return PrintLayout(s);
}

/// Returns the ink of a text whose top left corner is at (0, 0), in millimeters.
bool textInk(const std::string& text, double x, double y)
{
    return textCell(text, static_cast<int>(std::floor(x / cell)), static_cast<int>(std::floor(y / cell)));
}

/// Returns the ink of a ruler with ticks of 1, 5 and 10 mm; `depth` is the distance from the paper's edge.
bool rulerInk(double at, double depth)
{
    const double nearest = std::round(at);
    if (nearest < 0 || std::abs(at - nearest) > 0.06) return false;
    const auto millimeter = static_cast<long long>(nearest);
    return depth > 1 && depth < (millimeter % 10 == 0 ? 5 : millimeter % 5 == 0 ? 4 : 3);
}

}  // namespace

Chart::Chart(const PrintLayout& layout, ChartKind kind, double span) : layout_(layout)
{
    const PrintSettings& s = layout.settings();
    upright_ = std::abs(s.direction) <= 45;
    along_ = upright_ ? s.height + 2 * s.bleed : s.width + 2 * s.bleed;
    across_ = upright_ ? s.width + 2 * s.bleed : s.height + 2 * s.bleed;
    if (!(span > 0 && span < 0.5))
        throw Failure(ErrorKind::usage, "The span of a pitch chart must lie between 0 and 50 %.");
    const double room = along_ - 2 * margin;
    const int fit = static_cast<int>(room / bandHeight);
    if (fit < 3 || across_ < 4 * margin)
        throw Failure(ErrorKind::usage, "A chart needs at least 40 mm across the lenses and 44 mm along them.");
    const auto add = [&](double from, double to, PrintLayout own, std::vector<double> levels, std::string label) {
        bands_.push_back({margin + from, margin + to, std::move(own), std::move(levels), std::move(label)});
    };
    if (kind == ChartKind::rotation) {
        std::vector<double> levels(static_cast<std::size_t>(std::max(3, s.views)), 1.0);
        levels[levels.size() / 2] = 0;
        add(0, room, changed(layout, layout.printLpi(), s.phase, static_cast<int>(levels.size())), levels, "ROTATION");
    } else {
        int count = std::min(fit, kind == ChartKind::pitch   ? pitchBands
                                  : kind == ChartKind::phase ? 16
                                                             : std::max(s.views, 2) - 1);
        if (kind == ChartKind::pitch && count % 2 == 0) --count;  // One band has the sheet's own pitch.
        for (int i = 0; i < count; ++i) {
            const double from = i * bandHeight + gap;
            const double to = (i + 1) * bandHeight;
            const double part = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
            if (kind == ChartKind::pitch) {
                const double lpi = layout.printLpi() * (1 + span * (2 * part - 1));
                add(from, to, changed(layout, lpi, s.phase, 2), {0, 1}, fixed(lpi, 4) + " LPI");
            } else if (kind == ChartKind::phase) {
                const double phase = static_cast<double>(i) / count;
                add(from, to, changed(layout, layout.printLpi(), phase, 2), {0, 1}, "PHASE " + fixed(phase, 4));
            } else {
                std::vector<double> levels(static_cast<std::size_t>(i + 2), 0.0);
                levels[levels.size() / 2] = 1;
                add(from, to, changed(layout, layout.printLpi(), s.phase, i + 2), levels,
                    std::to_string(i + 2) + " VIEWS");
            }
        }
    }
    title_ = fixed(layout.printLpi(), 4) + " LPI  " + fixed(s.dpiX, 2) + " X " + fixed(s.dpiY, 2) + " DPI";
}

bool Chart::inked(double along, double across) const
{
    // Marks to square the sheet by: straight lines along the lenses at both ends, 1 mm apart, not at lens pitch.
    const double end = std::min(across, across_ - across);
    if (end > 6 && end < 9 && along > margin && along < along_ - margin) return std::abs(end - std::round(end)) < 0.05;
    if (rulerInk(across - margin, along) && across < across_ - margin) return true;
    if (rulerInk(along - margin, across) && along < along_ - margin) return true;
    if (textInk(title_, across - margin, along - (along_ - 8))) return true;
    if (textInk(upright_ ? "LENSES UP - FEED: TOP / SIDE" : "LENSES ACROSS - FEED: TOP / SIDE", across - margin,
                along - (along_ - 5)))
        return true;
    for (const Band& band : bands_) {
        const double y = along - (band.from - gap + 0.6);
        if (y < 0 || y > 7 * cell) continue;
        const double wide = static_cast<double>(band.label.size()) * 6 * cell;
        for (const double x : {margin, (across_ - wide) / 2, across_ - margin - wide})
            if (textInk(band.label, across - x, y)) return true;
    }
    return false;
}

double Chart::level(double x, double y, std::vector<ViewWeight>& taps) const
{
    const PrintSettings& s = layout_.settings();
    const double mmX = x / s.dpiX * mmPerInch;
    const double mmY = y / s.dpiY * mmPerInch;
    // Letters are upright for vertical lenses. For horizontal ones everything is rotated, so it reads along the ruler.
    const double along = upright_ ? mmY : mmX;
    const double across = upright_ ? mmX : mmY;
    if (across >= margin && across < across_ - margin) {
        for (const Band& band : bands_) {
            if (along < band.from || along >= band.to) continue;
            viewWeightsAt(band.layout, x, y, taps);
            double sum = 0;
            for (const ViewWeight& tap : taps) sum += tap.weight * band.views[static_cast<std::size_t>(tap.view)];
            return sum;
        }
    }
    return inked(along, across) ? 0 : 1;
}

template <typename Code> void Chart::fillCodes(const Region& region, Code* out) const
{
    std::vector<ViewWeight> taps;
    for (std::int64_t y = region.y0; y < region.y1; ++y) {
        for (std::int64_t x = region.x0; x < region.x1; ++x, out += 3) {
            const std::int64_t front = layout_.settings().mirror ? layout_.width() - 1 - x : x;
            const auto linear =
                static_cast<float>(level(static_cast<double>(front) + 0.5, static_cast<double>(y) + 0.5, taps));
            if constexpr (sizeof(Code) == 1)
                out[0] = out[1] = out[2] = render::srgb8FromLinear(linear);
            else
                out[0] = out[1] = out[2] = render::srgb16FromLinear(linear);
        }
    }
}

void Chart::fill(const Region& region, std::uint8_t* out) const
{
    fillCodes(region, out);
}
void Chart::fill(const Region& region, std::uint16_t* out) const
{
    fillCodes(region, out);
}

}  // namespace vitrine::printing
