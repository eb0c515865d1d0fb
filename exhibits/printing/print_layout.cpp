#include "exhibits/printing/print_layout.h"

#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vitrine::printing {
namespace {

constexpr double mostPixels = 2147483647;  // Per side; PNG and TIFF end there.

[[noreturn]] void refuse(const std::string& why)
{
    throw Failure(ErrorKind::usage, "This print cannot be made: " + why + ".");
}

void requirePositive(double value, const char* what)
{
    if (!(value > 0) || !std::isfinite(value))
        refuse(std::string(what) + " is " + shortText(value) + "; give a positive number");
}

std::int64_t pixels(double mm, double dpi, const char* what)
{
    const double count = std::round(mm / mmPerInch * dpi);
    if (count < 1) refuse(std::string("the ") + what + " is less than a pixel");
    if (count > mostPixels)
        refuse(std::string("the ") + what + " is " + shortText(count) + " pixels; picture files end at 2147483647");
    return static_cast<std::int64_t>(count);
}

void checkSettings(const PrintSettings& s)
{
    if (s.views < 1) refuse("there are no views");
    if (s.views > mostViews)
        refuse("there are " + std::to_string(s.views) + " views, and at most " + std::to_string(mostViews) +
               " are possible");
    check(s.sheet);
    requirePositive(s.dpiX, "dpi");
    requirePositive(s.dpiY, "dpi-y");
    requirePositive(s.width, "the width");
    requirePositive(s.height, "the height");
    if (!(s.bleed >= 0) || !std::isfinite(s.bleed)) refuse("the bleed is " + shortText(s.bleed) + "; give 0 or more");
    if (!(s.border >= 0) || !std::isfinite(s.border))
        refuse("the border is " + shortText(s.border) + "; give 0 or more");
    if (s.marks.any() && s.border < leastMarkBorder)
        refuse("its marks need a border of at least " + shortText(leastMarkBorder) + " mm, and it has " +
               shortText(s.border) + " mm; give a wider border, or leave the marks out");
    if (!(s.inkSpread >= 0) || !std::isfinite(s.inkSpread))
        refuse("the ink's spread is " + shortText(s.inkSpread) + "; give 0 or more");
    if (std::isnan(s.distance) || s.distance <= s.sheet.thickness) {
        refuse("the viewing distance is " + shortText(s.distance) +
               " mm; the eye must be farther away than the sheet is thick, " + shortText(s.sheet.thickness) + " mm");
    }
    if (!(s.visualLpi >= 0) || !std::isfinite(s.visualLpi))
        refuse("the visual LPI is " + shortText(s.visualLpi) +
               "; give lenses per inch, or 0 to let the viewing distance decide");
    if (!std::isfinite(s.phase) || std::abs(s.phase) > 1e6)
        refuse("the phase is " + shortText(s.phase) + "; give a part of a lens, 0 to 1");
    if (!(std::abs(s.direction) <= 90))
        refuse("the direction is " + shortText(s.direction) + " degrees; give -90 to 90");
    if (!(s.guard >= 0 && s.guard <= 1))
        refuse("the guard is " + shortText(s.guard) + "; give a part of a strip, 0 to 1");
}

}  // namespace

const char* toString(Method method)
{
    switch (method) {
    case Method::nearest: return "nearest";
    case Method::area: return "area";
    case Method::guard: return "guard";
    }
    return "";
}

double printPitch(const Sheet& sheet, double distance)
{
    if (std::isinf(distance)) return sheet.pitch();
    return sheet.pitch() * (distance + sheet.thickness) / (distance + sheet.radius);
}

PrintLayout::PrintLayout(const PrintSettings& settings) : settings_(settings)
{
    checkSettings(settings_);
    width_ = pixels(settings_.width + 2 * settings_.bleed, settings_.dpiX, "width");
    height_ = pixels(settings_.height + 2 * settings_.bleed, settings_.dpiY, "height");
    // Whole pixels on both sides, so the position of the lenses does not depend on the border.
    borderX_ = std::llround(std::min(settings_.border / mmPerInch * settings_.dpiX, mostPixels));
    borderY_ = std::llround(std::min(settings_.border / mmPerInch * settings_.dpiY, mostPixels));
    width_ += 2 * borderX_;
    height_ += 2 * borderY_;
    if (static_cast<double>(std::max(width_, height_)) > mostPixels)
        refuse("with its border it has more than 2147483647 pixels on a side");
    pitch_ = settings_.visualLpi > 0 ? mmPerInch / settings_.visualLpi
                                     : vitrine::printing::printPitch(settings_.sheet, settings_.distance);
    // The two most frequent directions are exact, without 6e-17 instead of 0.
    const bool horizontal = std::abs(settings_.direction) == 90;
    cos_ = horizontal ? 0 : std::cos(settings_.direction * radiansPerDegree);
    sin_ = horizontal ? 1 : std::sin(settings_.direction * radiansPerDegree);
    perX_ = cos_ * mmPerInch / (settings_.dpiX * pitch_);
    perY_ = sin_ * mmPerInch / (settings_.dpiY * pitch_);
    if (!(pixelsPerLens() > 1)) {
        refuse(shortText(printLpi()) + " LPI at " + shortText(perX_ != 0 ? settings_.dpiX : settings_.dpiY) +
               " dpi leaves no more than one pixel for a lens; choose a finer printer or a coarser sheet");
    }
}

std::array<double, 4> PrintLayout::trimBox() const
{
    const auto [left, top, right, bottom] = bleedBox();
    const double x = settings_.bleed / mmPerInch * settings_.dpiX, y = settings_.bleed / mmPerInch * settings_.dpiY;
    return {left + x, top + y, right - x, bottom - y};
}

std::array<double, 4> PrintLayout::bleedBox() const
{
    return {static_cast<double>(borderX_), static_cast<double>(borderY_), static_cast<double>(width_ - borderX_),
            static_cast<double>(height_ - borderY_)};
}

PrintLayout PrintLayout::withoutBorder() const
{
    PrintSettings inner = settings_;
    inner.border = 0;
    inner.marks = {};
    return PrintLayout(inner);
}

double PrintLayout::wholePixelsPerLens() const
{
    return std::floor(pixelsPerLens() * (1 + 1e-4));
}

double PrintLayout::pixelsPerLens() const
{
    return 1 / std::max(std::abs(perX_), std::abs(perY_));
}

int PrintLayout::viewOfStrip(std::int64_t strip) const
{
    const std::int64_t views = settings_.views;
    const auto within = static_cast<int>(((strip % views) + views) % views);
    return settings_.reverse ? within : settings_.views - 1 - within;
}

}  // namespace vitrine::printing
