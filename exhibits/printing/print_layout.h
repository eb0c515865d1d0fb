#pragma once

#include "exhibits/printing/sheet.h"

#include <array>
#include <cstdint>
#include <limits>

namespace vitrine::printing {

/// Selection of a printed pixel among the views under it.
enum class Method : std::uint8_t {
    nearest,  ///< The view under its center; strip edges jump by up to half a pixel.
    area,     ///< All views, weighted by the covered share of the pixel, in linear light.
    guard,    ///< As area, but the edges of strips are the mean of the two adjacent views.
};

[[nodiscard]] const char* toString(Method);

/// Marks for the press in the border of a print.
struct MarkSettings {
    bool crop = false;          ///< At the corners of the trim.
    bool registration = false;  ///< At the middle of each side.
    bool colorBar = false;      ///< Below the print.
    bool pitchStrip = false;    ///< Lines at lens pitch, beside the edge that crosses the lenses.

    [[nodiscard]] bool any() const { return crop || registration || colorBar || pitchStrip; }
};

/// Everything that determines a print. Lengths are in millimeters.
struct PrintSettings {
    Sheet sheet{};
    double dpiX = 600, dpiY = 600;
    double width = 100, height = 100;  ///< After trimming.
    double bleed = 0;                  ///< Margin beyond the trim on every side, with lenses and views.
    double distance = std::numeric_limits<double>::infinity();  ///< Distance from the lens tops to the eye.
    double visualLpi = 0;  ///< Lenses per inch read from a pitch chart at that distance; 0: derived from the distance.
    double phase = 0;      ///< Shift of the strips under the lenses, in lenses.
    double direction = 0;  ///< Direction of the lenses in degrees: 0 vertical, 90 horizontal, others slanted.
    bool reverse = false;  ///< The first view is on the left under each lens instead of on the right.
    bool mirror = false;   ///< Mirrored, for printing on the back of the sheet.
    int views = 1;
    Method method = Method::area;
    double guard = 0.25;      ///< Share of a strip for its two blended edges (method guard).
    double border = 0;        ///< White paper around trim and bleed, on every side.
    MarkSettings marks{};     ///< Drawn into the border.
    bool dither = false;      ///< For 8-bit prints; 16 bits need none.
    bool compensate = false;  ///< Compensates the cross-talk of the sheet, see `compensation`.
    double inkSpread = 0;     ///< Standard deviation of a printed point, for cross-talk.
};

constexpr int mostViews = 256;
constexpr double leastMarkBorder = 5;  ///< Millimeters of border that marks need.

/// Raster of a print, and position of its lenses.
///
/// Positions are absolute, in double, from the center of the raster. Nothing is accumulated along a row and no pixel
/// count per lens is rounded, so the last column is as exact as the first.
class PrintLayout {
public:
    /// Throws Failure (ErrorKind::usage) that names an impossible setting with its limit.
    explicit PrintLayout(const PrintSettings&);

    [[nodiscard]] const PrintSettings& settings() const { return settings_; }
    [[nodiscard]] std::int64_t width() const { return width_; }  ///< Pixels, including bleed and border.
    [[nodiscard]] std::int64_t height() const { return height_; }
    [[nodiscard]] std::int64_t borderX() const { return borderX_; }  ///< White pixels on the left, and on the right.
    [[nodiscard]] std::int64_t borderY() const { return borderY_; }
    /// Returns the print without its border: its pixel (x, y) is (x + borderX, y + borderY) of this one.
    [[nodiscard]] PrintLayout withoutBorder() const;
    /// Returns the part within the trim in pixels from the top left corner: left, top, right, bottom.
    [[nodiscard]] std::array<double, 4> trimBox() const;
    /// The same for the part within the bleed, without the border.
    [[nodiscard]] std::array<double, 4> bleedBox() const;
    [[nodiscard]] double printPitch() const { return pitch_; }  ///< Millimeters between strips of the same view.
    [[nodiscard]] double printLpi() const { return 25.4 / pitch_; }
    [[nodiscard]] double pixelsPerLens() const;  ///< Along the row or column, whichever crosses more lenses.
    /// Returns the number of whole dots under a lens, which is the most views that it can tell apart. Resolutions of
    /// files are rounded (PNG stores whole pixels per meter), so that 12 pixels may be 11.9999: a ten-thousandth short
    /// of a pixel counts as the pixel.
    [[nodiscard]] double wholePixelsPerLens() const;

    /// Returns the position in lenses of a place on the raster, in pixels from its top left corner. The integer part
    /// counts lenses; the fraction is the position under the lens, 0.5 on its axis. A lens axis passes through the
    /// center of the print.
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

    /// Returns the view in strip `strip`, counted over all lenses: strip s of lens j is j * views + s. Lenses exchange
    /// left and right, so the last view is on the left unless `reverse`.
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

/// Returns the pitch of the strips that an eye at `distance` sees through lenses of the sheet's pitch p. It is p (D +
/// t) / (D + r), by the ray through each lens's center of curvature, and p at infinity.
[[nodiscard]] double printPitch(const Sheet&, double distance);

}  // namespace vitrine::printing
