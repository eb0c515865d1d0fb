#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/printing/chart.h"
#include "exhibits/printing/fitting.h"
#include "exhibits/printing/print_layout.h"
#include "render/image/picture_stream.h"

#include <cstdint>
#include <limits>

namespace vitrine::printing {

/// Origin of the views of a print.
enum class ViewOrigin : std::uint8_t {
    shown,  ///< Rendered from what is shown.
    files,  ///< A folder, or pictures in viewing order from the left.
    quilt,  ///< One picture with a grid of views, the first at the bottom left, rows upwards.
};

enum class LensShape : int { derived, given };
enum class PrintBits : int { eight, sixteen };

/// All parameters of a print made in the window. Lengths are in meters.
struct PrintTable final : Parameters {
    Group viewGroup = group("Views");
    Choice<ViewOrigin> origin = choice("origin", ViewOrigin::shown, {"what is shown", "files", "quilt"},
                                       "Origin of the views: rendered from the picture in the window, read from "
                                       "pictures, or cut from a grid of views.");
    Count views = count("views", 12, Range{1, mostViews, logarithmic}.soft(2, 48),
                        "Number of views to render, or to choose evenly from the files.");
    Count viewWidth = count("viewWidth", 960, Range{64, 8192, logarithmic}.soft(256, 4096),
                            "Width of a rendered view in pixels; more than two pixels per lens are lost in the print.");
    Count samples = count("samples", 16, {1, 256, logarithmic},
                          "Samples per pixel of a rendered view, each view with noise of its own.", quality(256));
    Real baselineScale = real("baselineScale", 1, none, Range{0, 4}.soft(0, 2),
                              "Distance between the cameras of rendered views: 0 is flat, 1 gives true depth at the "
                              "viewing distance, above 1 exaggerates depth.");
    Real convergence = real(
        "convergence", 0, meter, Range{0, 1000}.soft(0, 20),
        "Distance from the camera to the objects that appear in the plane of the print. Auto: the camera's target.",
        reads(0, "auto"));
    Count quiltColumns = count("quiltColumns", 4, {1, 64}, "Number of columns of views in a quilt.");
    Count quiltRows =
        count("quiltRows", 4, {1, 64}, "Number of rows of views in a quilt; the first row is at the bottom.");

    Choice<Fitting> fitting = choice("fitting", Fitting::crop, {"crop", "fit", "stretch"},
                                     "Fitting of pictures whose aspect ratio is not the print's: cropped at two sides "
                                     "(crop), whole between white margins (fit), or distorted (stretch).",
                                     option("fit"));

    // Text in the syntax of `viewPlaces`; the dialog has its own fields to edit it.
    File places =
        file("places", "Pictures turned and moved by hand: number of the picture, degrees clockwise, percent to the "
                       "right and percent down, such as 3:1.5,2,-0.5.");

    Group chartGroup = group("Chart");
    Choice<ChartKind> chart =
        choice("chart", ChartKind::pitch, {"pitch", "phase", "views", "rotation"},
               "Kind of calibration chart: pitch finds the LPI at which printer and sheet match, phase the shift of "
               "the strips, views the number of distinguishable views, rotation whether the sheet is straight.");
    Real chartSpan = real("chartSpan", 0.01, percent, Range{0.0001, 0.2, logarithmic}.soft(0.001, 0.05),
                          "Range of a pitch chart to either side of the LPI: 1 % is coarse, 0.1 % fine.",
                          typedIn(percent), when(chart, ChartKind::pitch));

    Group sheetGroup = group("Sheet");
    Real lensesPerInch = real("lensesPerInch", 60, none, Range{1, 1000, logarithmic}.soft(10, 200),
                              "Nominal number of lenses per inch of the sheet.", option("lpi"));
    Real measuredPerInch = real("measuredPerInch", 0, none, Range{0, 1000}.soft(0, 200),
                                "Lenses per inch as measured with a pitch chart on this printer. Auto: not measured; "
                                "the LPI of the sheet are used.",
                                reads(0, "auto"), option("effective-lpi"));
    Choice<LensShape> lens = choice("lens", LensShape::derived, {"from the zone", "as given"},
                                    "Shape of the lenses: radius and thickness computed from LPI, zone and index so "
                                    "that the lens focuses on the print, or given by numbers.");
    Real zone = real("zone", degrees(30), degree, Range{degrees(0.5), degrees(115)}.soft(degrees(11), degrees(63)),
                     "Viewing angle over which all views are seen once: about 30° for depth, 50° for flips.",
                     typedIn(degree), when(lens, LensShape::derived));
    Real radius = real("radius", 0.000442, micrometer, Range{1e-6, 0.1, logarithmic}.soft(5e-5, 0.005),
                       "Radius of curvature at the top of the lenses.", option("radius-um", micrometer),
                       implies(lens, LensShape::given), when(lens, LensShape::given));
    Real thickness = real("thickness", 0.00123, micrometer, Range{1e-6, 0.1, logarithmic}.soft(1e-4, 0.01),
                          "Thickness of the sheet, from lens top to print.", option("thickness-um", micrometer),
                          implies(lens, LensShape::given), when(lens, LensShape::given));
    Real refractiveIndex =
        real("refractiveIndex", 1.56, none, Range{1, 3}.soft(1.45, 1.65),
             "Refractive index of the plastic: 1.49 acrylic, 1.57 PET, 1.59 polystyrene.", option("index"));
    Real conic = real("conic", 0, none, Range{-4, 4}.soft(-1, 1),
                      "Conic constant of the lenses: 0 is a circle, -1/n² the ellipse without spherical aberration.");

    Group printGroup = group("Print");
    Real width = real("width", 0.148, millimeter, Range{0.0001, 100, logarithmic}.soft(0.02, 2),
                      "Width of the print after trimming.", option("width-mm", millimeter), mustBeGiven());
    Real height = real("height", 0.105, millimeter, Range{0.0001, 100, logarithmic}.soft(0.02, 2),
                       "Height of the print after trimming.", option("height-mm", millimeter), mustBeGiven());
    Real bleed = real("bleed", 0, millimeter, Range{0, 1}.soft(0, 0.02),
                      "Margin beyond the trim on every side, into which lenses and views continue.",
                      option("bleed-mm", millimeter));
    Real border = real("border", 0, millimeter, Range{0, 1}.soft(0, 0.05),
                       "White paper around trim and bleed, on every side.", option("border-mm", millimeter));
    Real dotsPerInch =
        real("dotsPerInch", 720, none, Range{1, 100000, logarithmic}.soft(150, 5760),
             "Printed dots per inch: the native resolution of the printer or a whole fraction of it.", option("dpi"));
    Real dotsDown = real("dotsDown", 0, none, Range{0, 100000}.soft(0, 2880),
                         "Printed dots per inch in vertical direction. Auto: as in horizontal direction.",
                         reads(0, "auto"), option("dpi-y"), labeled("Dots per inch, vertical"));
    Real distance = real(
        "distance", std::numeric_limits<double>::infinity(), centimeter, Range{0.0001, 1000, logarithmic}.soft(0.1, 10),
        "Viewing distance that determines the pitch of the strips. Inf: strips have exactly the pitch of the lenses.",
        reads(std::numeric_limits<double>::infinity(), "inf"), option("distance-mm", millimeter));
    Real visualPerInch = real("visualPerInch", 0, none, Range{0, 1000}.soft(0, 200),
                              "Lenses per inch as read from a pitch chart at the viewing distance. Auto: not measured; "
                              "computed from the viewing distance.",
                              reads(0, "auto"), option("visual-lpi"));
    Real phase = real("phase", 0, none, Range{-1e6, 1e6}.soft(-0.5, 0.5),
                      "Shift of the strips under the lenses, in lens widths, as read from a phase chart.");
    Real direction =
        real("direction", 0.0, degree, {degrees(-90), degrees(90)},
             "Direction of the lenses: vertical for depth, horizontal for flips; angles in between are slanted lenses.",
             reads(0, "vertical"), reads(degrees(90), "horizontal"), typedIn(degree));
    Toggle reverse = toggle("reverse", false,
                            "Whether the order of the views under each lens is reversed. This turns depth inside out, "
                            "or corrects a reversed sequence.");
    Toggle mirror = toggle("mirror", false, "Whether the print is mirrored, for printing on the back of the sheet.");
    Choice<Method> method = choice("method", Method::area, {"nearest", "area", "guard"},
                                   "Method that mixes the views under a printed dot: the one at its center (nearest), "
                                   "all by area, or all by area with blended strip edges (guard).");
    Real inkSpread =
        real("inkSpread", 0, micrometer, Range{0, 0.001}.soft(0, 0.00006),
             "Spread of a printed point (standard deviation), which adds to the crosstalk; 10 to 40 µm are usual.",
             option("ink-um", micrometer));
    Toggle compensate = toggle("compensate", false,
                               "Correct the views in advance for the crosstalk of the sheet, which mixes neighboring "
                               "views; lowers the contrast.",
                               labeled("Compensate cross-talk"), option("crosstalk-compensation"));
    Real guard =
        real("guard", 0.25, percent, {0, 1},
             "Share of a strip's width that is blended with its two neighbors: 0 blends nothing, 100 % all of it.",
             when(method, Method::guard));

    Group outputGroup = group("Output");
    Choice<PrintBits> bits = choice("bits", PrintBits::eight, {"8", "16"}, "Bits per channel.");
    Toggle dither = toggle("dither", false, "Dither to 8 bits: spread the rounding error over neighboring dots.",
                           when(bits, PrintBits::eight));
    Choice<render::StreamCompression> compression =
        choice("compression", render::StreamCompression::none, {"none", "deflate"},
               "Compression of a TIFF: every print shop reads files without it (none). PNG is always compressed.");
    Real tileWidth =
        real("tileWidth", 0, millimeter, Range{0, 100}.soft(0, 1),
             "Width of the files into which the print is divided; the cuts lie between lenses. Auto: one file.",
             reads(0, "auto"), option("tile-mm", millimeter), when(direction, 0.0));
};

/// Returns the table to which all values below belong.
[[nodiscard]] const PrintTable& printTable();

/// Returns whether a parameter has an effect with these values, in a print of views or in a chart.
[[nodiscard]] bool rowActs(const ParameterInfo&, const ParameterValues&, bool chart);
/// Returns whether views read or rendered for one set of values can be used for the other.
[[nodiscard]] bool sameViews(const ParameterValues&, const ParameterValues&);
/// Returns the distance from which the print is viewed, in millimeters; may be infinite.
[[nodiscard]] double viewingDistance(const ParameterValues&);
/// Returns the bits per channel of the file.
[[nodiscard]] int bitsOf(const ParameterValues&);

/// Returns the sheet of the values. Throws Failure (ErrorKind::usage) with the limit if it is impossible.
[[nodiscard]] Sheet sheetOf(const ParameterValues&);
/// Returns the values with this sheet; `lens` is derived if the sheet follows from LPI, zone and index.
[[nodiscard]] ParameterValues withSheet(ParameterValues, const Sheet&);

/// Returns the settings of a print of `views` views. Throws like `sheetOf`; PrintLayout checks the rest.
[[nodiscard]] PrintSettings printSettings(const ParameterValues&, int views);

}  // namespace vitrine::printing
