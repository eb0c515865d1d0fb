#pragma once

#include <array>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace vitrine::printing {

constexpr double mmPerInch = 25.4;
constexpr double radiansPerDegree = std::numbers::pi / 180;

/// Returns six significant digits, such as "0.3175", for messages and labels.
[[nodiscard]] inline std::string shortText(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

/// Sheet of cylindrical lenses. Lengths are in millimeters; the print is `thickness` below the lens tops.
///
/// Radius and thickness are independent: wide-angle sheets are thinner than their focal length.
struct Sheet {
    std::string name{};
    double nominalLpi = 0;    ///< Lenses per inch as sold.
    double effectiveLpi = 0;  ///< Lenses per inch as measured; 0: not measured, the nominal value counts.
    double radius = 0;        ///< Radius of curvature at the lens top.
    double thickness = 0;     ///< Distance from lens top to print.
    double index = 1.56;      ///< Refractive index.
    double conic = 0;         ///< 0 is a circle, -1/index^2 the ellipse without spherical aberration.

    [[nodiscard]] double lpi() const { return effectiveLpi > 0 ? effectiveLpi : nominalLpi; }
    [[nodiscard]] double pitch() const { return 25.4 / lpi(); }  ///< Millimeters per lens.
};

/// Throws Failure (ErrorKind::usage) that names an impossible value and its limit. Lengths and LPI must be positive and
/// finite, and the index above 1. The curve must reach the cusp, and the print must be below it.
void check(const Sheet&);

/// Returns whether two sheets have the same numbers except for rounding; names do not count.
[[nodiscard]] bool sameLens(const Sheet&, const Sheet&);

/// Returns a sheet focused on its back that shows its views over `zoneDegrees`. By the paraxial focus, t = n p / (2
/// tan(V/2)) and r = t (n-1)/n. Throws Failure if that zone needs a lens wider than a circle.
[[nodiscard]] Sheet derivedSheet(const std::string& name, double lpi, double zoneDegrees, double index = 1.56);

/// Returns sheets to start from. "20-3d" (zone of 30 degrees) and "20-flip" (50 degrees) exist for the usual LPI, and
/// are derived from LPI, angle and index. "75-measured" was measured. Manufacturers differ: edit and calibrate.
[[nodiscard]] const std::vector<Sheet>& knownSheets();

/// Returns the known sheet of that name. Throws Failure (ErrorKind::usage) that lists the names.
[[nodiscard]] const Sheet& knownSheet(const std::string& name);

}  // namespace vitrine::printing
