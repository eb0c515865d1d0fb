#pragma once

#include "exhibits/printing/sheet.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vitrine::printing {

/// How a printed pixel chooses among the views under it.
enum class Method : std::uint8_t {
    nearest,  ///< The view under its center: nothing is mixed, strip edges jump by up to half a pixel.
    area,     ///< Every view by the share of the pixel it covers, in linear light.
    guard,    ///< As area, and the edges of strips are the mean of the two views that meet there.
};

[[nodiscard]] const char* toString(Method);

/// Everything that decides what a print looks like. Lengths in millimeters.
struct PrintSettings {
    Sheet sheet{};
    double dpiX = 600, dpiY = 600;
    double width = 100, height = 100;  ///< After trimming.
    double bleed = 0;                  ///< Beyond the trim on every side; lenses and views go on there.
    double distance = std::numeric_limits<double>::infinity();  ///< From the lens tops to the eye.
    double visualLpi = 0;  ///< Lenses per inch read from a pitch chart at that distance; 0: follows from the distance.
    double phase = 0;      ///< Of the strips under the lenses, in lenses.
    double direction = 0;  ///< Of the lenses: 0 vertical, 90 horizontal, between them slanted, in degrees.
    bool reverse = false;  ///< The first view on the left under each lens instead of on the right.
    bool mirror = false;   ///< For printing on the sheet's back.
    int views = 1;
    Method method = Method::area;
    double guard = 0.25;      ///< Share of a strip that its two blended edges take (method guard).
    double border = 0;        ///< White paper around trim and bleed, on every side.
    bool dither = false;      ///< Of 8-bit prints; 16 bits need none.
    bool compensate = false;  ///< For the cross-talk of the sheet, see `compensation`.
    double inkSpread = 0;     ///< Standard deviation of a printed point, for cross-talk.
};

constexpr int mostViews = 256;

/// A print's raster and where its lenses lie on it.
///
/// Positions are absolute, in double, from the middle of the raster: nothing is added up along a row and no
/// pixel count per lens is rounded, so that the last column is as exact as the first.
class PrintLayout {
public:
    /// Throws Failure (Blame::usage) naming the setting that cannot be, with its limit.
    explicit PrintLayout(const PrintSettings&);

    [[nodiscard]] const PrintSettings& settings() const { return settings_; }
    [[nodiscard]] std::int64_t width() const { return width_; }  ///< Pixels, bleed and border included.
    [[nodiscard]] std::int64_t height() const { return height_; }
    [[nodiscard]] std::int64_t borderX() const { return borderX_; }  ///< Pixels of white on the left, and on the right.
    [[nodiscard]] std::int64_t borderY() const { return borderY_; }
    /// The same print, cut along its border: its pixel (x, y) is (x + borderX, y + borderY) of this one.
    [[nodiscard]] PrintLayout withoutBorder() const;
    [[nodiscard]] double printPitch() const { return pitch_; }  ///< Millimeters between strips of the same view.
    [[nodiscard]] double printLpi() const { return 25.4 / pitch_; }
    [[nodiscard]] double pixelsPerLens() const;  ///< Along the row or column, whichever crosses more lenses.

    /// Lenses at a place on the raster, in pixels from its top left corner: the integer part counts lenses, the
    /// fraction says where under the lens, 0.5 on its axis. A lens axis runs through the middle of the print.
    [[nodiscard]] double lensAt(double x, double y) const
    {
        return (x - 0.5 * static_cast<double>(width_)) * perX_ + (y - 0.5 * static_cast<double>(height_)) * perY_ +
               0.5 + settings_.phase;
    }
    [[nodiscard]] double lensesPerPixelX() const { return perX_; }  ///< Exactly 0 for horizontal lenses.
    [[nodiscard]] double lensesPerPixelY() const { return perY_; }  ///< Exactly 0 for vertical lenses.
    [[nodiscard]] double cosine() const { return cos_; }
    [[nodiscard]] double sine() const { return sin_; }
    [[nodiscard]] bool vertical() const { return perY_ == 0; }

    /// The view printed in strip `strip`, counted over all lenses: strip s of lens j is j * views + s. Lenses
    /// turn left and right round, so the last view lies on the left, unless `reverse`.
    [[nodiscard]] int viewOfStrip(std::int64_t strip) const;

private:
    PrintSettings settings_;
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    std::int64_t borderX_ = 0;
    std::int64_t borderY_ = 0;
    double pitch_ = 0;
    double perX_ = 0, perY_ = 0;
    double cos_ = 1, sin_ = 0;
};

/// The pitch of the strips that an eye at `distance` sees through lenses of the sheet's pitch:
/// p (D + t) / (D + r), by the ray through each lens's center of curvature; the sheet's own at infinity.
[[nodiscard]] double printPitch(const Sheet&, double distance);

/// What a printer and a visitor want to know.
struct PrintNumbers {
    double pixelsPerLens = 0;
    double effectiveLpi = 0;       ///< Of the strips, with the dpi that the file stores.
    double effectiveViews = 0;     ///< No more than pixels per lens.
    double zoneDegrees = 0;        ///< Exact, by the mean over the lens.
    double depthBudget = 0;        ///< Millimeters before and behind the print without doubled contours, together.
    std::vector<double> ownShare;  ///< Per view, at its own angle: the rest is cross-talk. Optics, pixels and ink.
};
/// `storedDpi` is the resolution along the row as the file will say it.
[[nodiscard]] PrintNumbers numbersOf(const PrintLayout&, double storedDpi);

/// Full sentences on what will disappoint.
[[nodiscard]] std::vector<std::string> warningsOf(const PrintLayout&);

}  // namespace vitrine::printing
