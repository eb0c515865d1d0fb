#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/printing/chart.h"
#include "exhibits/printing/fitting.h"
#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_place.h"
#include "render/image/picture_formats.h"
#include "render/image/picture_stream.h"
#include "render/image/profile_conversion.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Values of the baseline scale that are words: "auto" and "fit".
inline constexpr double baselineByMotion = -1, baselineThatFits = -2;

/// Origin of the views of a print.
enum class ViewOrigin : std::uint8_t {
    shown,  ///< Rendered from a scene: what the window shows, or `--exhibit`.
    files,  ///< A folder, or pictures in viewing order from the left.
    quilt,  ///< One picture with a grid of views.
    chart,  ///< A calibration chart, which has views of its own.
};

enum class LensShape : int { derived, given };
enum class PrintBits : int { eight, sixteen };

/// Bits per channel of saved views.
inline constexpr int viewBits = 8;
/// Returns the possible extensions of saved views, the usual one first: "png", "jpg".
[[nodiscard]] const std::vector<std::string>& viewFormats();

/// All parameters of a print. Lengths are in meters.
struct PrintTable final : Parameters {
    Group viewGroup = group("Views");
    Choice<ViewOrigin> origin =
        choice("origin", ViewOrigin::shown, {"what is shown", "files", "quilt", "chart"},
               "Origin of the views: rendered from what is shown, read from pictures, or cut from a grid of views; or "
               "a calibration chart.");
    File files = file("files",
                      "Views to print: a folder of pictures, the picture files in order from left to right, or a "
                      "video, whose frames are the views. Unrelated pictures make a flip.",
                      several(), option("views"), implies(origin, ViewOrigin::files));
    Count quiltColumns = count("quiltColumns", 8, Range{1, 1000, logarithmic}.soft(1, 64),
                               "Picture with a grid of views: number of columns and rows, and the file. If its size is "
                               "not divisible, the size of a view is rounded down and the remainder is cut off.",
                               tuple("quilt", 'x'), implies(origin, ViewOrigin::quilt));
    Count quiltRows = count("quiltRows", 6, Range{1, 1000, logarithmic}.soft(1, 64),
                            "Number of rows of views in a quilt.", tuple("quilt", 'x'));
    File quilt =
        file("quiltFile", "Picture with a grid of views.", extensions(render::readEndings()), tuple("quilt", 'x'));
    Choice<QuiltOrder> quiltOrder =
        choice("quiltOrder", QuiltOrder::bottomLeft, {"bottom-left", "top-left"},
               "Position of the first view in the quilt: bottom-left (next to the right, rows upwards, as for Looking "
               "Glass) or top-left (next to the right, rows downwards).");
    // Text in the syntax of `viewPlaces`; the dialog has its own fields to edit it.
    Text places =
        text("places",
             "Turn and shift of single pictures, as PICTURE:TURN,RIGHT,DOWN: the picture's number in viewing order, "
             "degrees clockwise, and percent of the view's width and height, such as 3:1.5,2,-0.5.",
             several(), option("place"));
    Choice<Fitting> fitting = choice("fitting", Fitting::crop, {"crop", "fit", "stretch"},
                                     "Fitting of pictures whose aspect ratio is not the print's: cropped at two sides "
                                     "(crop), whole between white margins (fit), or distorted (stretch).",
                                     option("fit"));
    Count every = count("every", 1, Range{1, 1e6, logarithmic}.soft(1, 100),
                        "Interval at which pictures are taken: 3 takes every third, for example of a video's frames.",
                        labeled("Interval of pictures"));
    Toggle pingPong =
        toggle("pingPong", false,
               "Append the pictures in reverse order (1 2 3 4 3 2), so that the views repeat without a jump.");
    Count views = count("views", 0, Range{1, mostViews, logarithmic}.soft(2, 48),
                        "Number of views to render, or to choose evenly from the pictures. Auto: all pictures, or as "
                        "many rendered views as are distinguishable in the print, at most 24.",
                        reads(0, "auto"), option("count"));
    Count viewWidth = count("viewWidth", 0, Range{1, 8192, logarithmic}.soft(256, 4096),
                            "Size of a rendered view in pixels; more than two pixels per lens are lost in the print. "
                            "Auto: the print's aspect ratio, at most 1200 on a side.",
                            reads(0, "auto"), tuple("viewSize", 'x'));
    Count viewHeight = count("viewHeight", 0, Range{1, 8192, logarithmic}.soft(256, 4096),
                             "Height of a rendered view in pixels. Auto: by the print's aspect ratio.",
                             reads(0, "auto"), tuple("viewSize", 'x'));
    Count samples = count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 256),
                          "Samples per pixel of a rendered view, each view with noise of its own. Auto: as in the "
                          "picture whose settings are used, else the hall's supersamples if they are set, else 4; "
                          "in the window 16.",
                          reads(0, "auto"), quality(256));
    Real baselineScale = real("baselineScale", baselineByMotion, none, Range{0, 4}.soft(0, 2),
                              "Distance between the cameras of rendered views: 0 is flat, 1 gives true depth at the "
                              "viewing distance, above 1 exaggerates depth. Auto: 1, or 0 if something turns or "
                              "changes. Fit: the largest without doubled contours.",
                              reads(baselineByMotion, "auto"), reads(baselineThatFits, "fit"));
    Real convergence = real(
        "convergence", 0, meter, Range{0, 1000}.soft(0, 20),
        "Distance from the camera to the objects that appear in the plane of the print. Auto: the camera's target.",
        reads(0, "auto"));
    Real turn = real("turn", 0, degree, Range{degrees(-36000), degrees(36000)}.soft(degrees(-360), degrees(360)),
                     "Angle by which the exhibit turns from the first to the last view, as seen when walking around it "
                     "to the right; 360° repeats without a jump.",
                     typedIn(degree));
    Text sweeps = text("sweeps",
                       "Parameter that changes from the first to the last view, as NAME=FROM..TO, such as morph=0..1, "
                       "or time=0..2 in seconds.",
                       several(), option("sweep"));
    File saveViews = file("saveViews", "Folder into which the views are written, too: view_00.png, view_01.png, ...");
    Choice<int> viewFormat =
        choice("viewFormat", 0, viewFormats(), "Format of the files of saved views.", whenGiven(saveViews));

    Group chartGroup = group("Chart");
    Choice<ChartKind> chart =
        choice("chart", ChartKind::pitch, {"pitch", "phase", "views", "rotation"},
               "Calibration chart to print in place of views: pitch finds the LPI at which printer and sheet match, "
               "phase the shift of the strips, views the number of distinguishable views, rotation whether the sheet "
               "is straight.",
               implies(origin, ViewOrigin::chart));
    Real chartSpan = real("chartSpan", 0.01, percent, Range{0.0001, 0.2, logarithmic}.soft(0.001, 0.05),
                          "Range of a pitch chart to either side of the LPI: 1 % is coarse, 0.1 % fine.",
                          typedIn(percent), when(chart, ChartKind::pitch));

    Group sheetGroup = group("Sheet");
    Text sheet =
        text("sheet", "Lenticular sheet by its name, such as 60-3d or 75-flip, in place of its single numbers.");
    Real lensesPerInch =
        real("lensesPerInch", 60, none, Range{1, 1000, logarithmic}.soft(10, 200),
             "Nominal number of lenses per inch of the sheet; beside a sheet's name, the measured one.", option("lpi"));
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
    Toggle cropMarks =
        toggle("cropMarks", false,
               "Crop marks: lines in the border at the corners of the trim, for the cutter. They need 5 mm "
               "of border, as all marks do.");
    Toggle registrationMarks =
        toggle("registrationMarks", false, "Crosses in circles in the border at the middle of each side.");
    Toggle colorBar = toggle("colorBar", false, "Bar of the inks, their mixtures and grays in the border below.");
    Toggle pitchStrip = toggle("pitchStrip", false,
                               "Strip of lines at the pitch of the lenses in the border: under the sheet it is evenly "
                               "gray or black where the lenses lie right.");
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
    File outputProfile = file(
        "outputProfile",
        "ICC profile of the printer or of a color space into which the print is converted: of red, green and blue, "
        "or of four inks (CMYK), which TIFF and PDF can hold. Without it, prints are in sRGB, or in the profile "
        "of their pictures.",
        extensions("icc icm"), option("profile"));
    Choice<render::RenderingIntent> intent =
        choice("intent", render::RenderingIntent::relative, {"perceptual", "relative", "saturation", "absolute"},
               "Treatment of colors that the printer cannot show: all move closer together (perceptual), only those "
               "change (relative), vividness is kept (saturation), or the tint of the paper is imitated (absolute).",
               whenGiven(outputProfile));
    Toggle blackPoint =
        toggle("blackPoint", true, "Match the darkest color of the printer to black, so that shadows keep their steps.",
               whenGiven(outputProfile), labeled("Black point compensation"));
    Real tileWidth =
        real("tileWidth", 0, millimeter, Range{0, 100}.soft(0, 1),
             "Width of the files into which the print is divided; the cuts lie between lenses. Auto: one file.",
             reads(0, "auto"), option("tile-mm", millimeter), when(direction, 0.0));
    Real tileOverlap = real("tileOverlap", 0, millimeter, Range{0, 10}.soft(0, 0.05),
                            "Width of the strip at the left of these files that the file before it has, too, so that "
                            "sheets can be laid over each other. It is enlarged to whole lenses.",
                            option("tile-overlap-mm", millimeter), when(direction, 0.0) && whenAbove(tileWidth, 0));
};

/// Returns the table to which all values below belong.
[[nodiscard]] const PrintTable& printTable();

/// Returns whether a parameter has an effect with these values, in a print of views or in a chart.
[[nodiscard]] bool parameterActs(const ParameterInfo&, const ParameterValues&, bool chart);
/// Returns whether views read or rendered for one set of values can be used for the other.
[[nodiscard]] bool sameViews(const ParameterValues&, const ParameterValues&);
/// Returns the pictures that the views are read from: those of `files`, or the quilt.
[[nodiscard]] std::vector<std::string> picturesOf(const ParameterValues&);
/// Returns the values with other pictures of the same origin, and with the grid that the name of a quilt tells
/// (`quiltNamed`).
[[nodiscard]] ParameterValues withPictures(ParameterValues, const std::vector<std::string>&);
/// Returns the number of views, with "auto" as the number for rendered views, or for a chart. Throws like `sheetOf`.
[[nodiscard]] int viewCount(const ParameterValues&);
/// Returns the scale of the cameras' distance; nullopt: the largest that fits.
[[nodiscard]] std::optional<double> strengthOf(const ParameterValues&);
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
