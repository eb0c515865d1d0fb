#include "app/print/print_options.h"

#include "app/number_option.h"
#include "app/useless_option.h"
#include "exhibits/printing/print_table.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/picture_formats.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>

namespace vitrine::app {
namespace {

double directionOf(const std::string& text)
{
    if (text == "vertical") return 0;
    if (text == "horizontal") return 90;
    return readNumber("--direction", text,
                      rangeOf(printing::printTable(), printing::printTable().direction, Unit::degree));
}

/// A named sheet, one measured by the user, or one derived for the LPI with a zone of 30 degrees.
printing::Sheet sheetOf(const PrintOptions& options)
{
    printing::Sheet sheet;
    if (!options.sheet.empty()) {
        sheet = printing::knownSheet(options.sheet);
        if (options.lpi != 0) sheet.effectiveLpi = options.lpi;
    } else if (options.radiusUm != 0 || options.thicknessUm != 0) {
        sheet = {"own",         options.lpi,  0, options.radiusUm / 1000, options.thicknessUm / 1000,
                 options.index, options.conic};
    } else {
        sheet = printing::derivedSheet("derived", options.lpi, 30, options.index);
        sheet.conic = options.conic;
    }
    if (options.effectiveLpi != 0) sheet.effectiveLpi = options.effectiveLpi;
    printing::check(sheet);
    return sheet;
}

}  // namespace

double distanceOf(const std::string& option, const std::string& text)
{
    if (text == "inf") return std::numeric_limits<double>::infinity();
    return readNumber(option, text, rangeOf(printing::printTable(), printing::printTable().distance, Unit::millimeter));
}

render::StreamCompression streamCompression(const std::string& name)
{
    return name == "deflate" ? render::StreamCompression::deflate : render::StreamCompression::none;
}

printing::PrintSettings printSettings(const PrintOptions& options, int views)
{
    if (options.lpi == 0 && options.sheet.empty())
        throw Failure(Blame::usage, "--lpi is missing: give the sheet's lenses per inch, or a --sheet.");
    printing::PrintSettings settings;
    settings.sheet = sheetOf(options);
    settings.dpiX = options.dpi;
    settings.dpiY = options.dpiY == 0 ? options.dpi : options.dpiY;
    settings.width = options.widthMm;
    settings.height = options.heightMm;
    settings.bleed = options.bleedMm;
    settings.distance = distanceOf("--distance-mm", options.distance);
    settings.visualLpi = options.visualLpi;
    settings.phase = options.phase;
    settings.direction = directionOf(options.direction);
    settings.reverse = options.order == "reverse";
    settings.mirror = options.mirror;
    settings.views = views;
    settings.method = options.method == "nearest" ? printing::Method::nearest
                      : options.method == "guard" ? printing::Method::guard
                                                  : printing::Method::area;
    settings.guard = options.guard;
    settings.border = options.borderMm;
    settings.inkSpread = options.inkUm / 1000;
    settings.dither = options.dither;
    settings.compensate = options.compensate;
    if (options.dither && options.bits == "16")
        throw Failure(Blame::usage, "--dither is for 8 bits; 16 bits need none.");
    if (options.borderMm != 0 && !options.chart.empty())
        throw Failure(Blame::usage, "--border-mm: charts have a border of their own.");
    return settings;
}

void refuseUselessOptions(const CLI::App& command, const PrintOptions& o)
{
    refuseWithout(command, "--guard", o.method == "guard", "--method guard");
    refuseWithout(command, "--chart-span", o.chart == "pitch", "--chart pitch");
    refuseWithout(command, "--view-format", !o.views.saveViews.empty(), "--save-views");
    refuseOn(command, "--compression", render::lowerExtension(o.out) == ".png", "a PNG, which is always compressed");
    for (const char* option :
         {"--views", "--quilt", "--exhibit", "--crosstalk-compensation", "--fit", "--place", "--every", "--ping-pong"})
        refuseOn(command, option, !o.chart.empty(), "a --chart, which has views of its own");
    for (const char* option : {"--radius-um", "--thickness-um", "--index", "--conic"})
        refuseOn(command, option, !o.sheet.empty(), "a --sheet, whose lenses are known");
    refuseUselessSceneOptions(command, o.views.scene);
}

void addPrintOptions(CLI::App& command, PrintOptions& o)
{
    const printing::PrintTable& t = printing::printTable();
    const auto add = [&](const char* name, double& value, const auto& row, Unit unit, const char* help) {
        return addNumber(command, name, value, rangeOf(t, row, unit), help);
    };
    addViewOptions(command, o.views);
    addChoice(command, "--chart", o.chart, {"pitch", "phase", "views", "rotation"},
              "Instead of views, a sheet to calibrate with: pitch, phase, views or rotation");
    add("--chart-span", o.chartSpan, t.chartSpan, Unit::percent,
        "Span of a pitch chart, in percent each way: 1 is coarse, 0.1 fine")
        ->capture_default_str();
    command.add_option("--out", o.out,
                       "Output print: " + render::streamedExtensions() + "; may be left out with --save-views");
    command.add_option("--report", o.report,
                       "Also write the print's description here, as JSON; it always lies beside the print and in it");
    add("--lpi", o.lpi, t.lensesPerInch, Unit::none, "Lenses per inch of the sheet");
    add("--effective-lpi", o.effectiveLpi, t.measuredPerInch, Unit::none,
        "Lenses per inch as measured; 0: not measured");
    add("--dpi", o.dpi, t.dotsPerInch, Unit::none, "Printed dots per inch")->capture_default_str();
    add("--dpi-y", o.dpiY, t.dotsDown, Unit::none, "The same along the other side, when it differs");
    add("--width-mm", o.widthMm, t.width, Unit::millimeter, "Trimmed width")->required();
    add("--height-mm", o.heightMm, t.height, Unit::millimeter, "Trimmed height")->required();
    add("--bleed-mm", o.bleedMm, t.bleed, Unit::millimeter, "Margin beyond the trim on every side");
    command.add_option("--distance-mm", o.distance, "Viewing distance, or inf")->capture_default_str();
    add("--visual-lpi", o.visualLpi, t.visualPerInch, Unit::none,
        "Lenses per inch as read from a pitch chart at that distance");
    add("--phase", o.phase, t.phase, Unit::none, "Moves the strips under the lenses, in lenses");
    command
        .add_option("--direction", o.direction,
                    "Direction of the lenses: vertical, horizontal or degrees from vertical")
        ->capture_default_str();
    addChoice(command, "--order", o.order, {"normal", "reverse"}, "normal or reverse")->capture_default_str();
    command.add_flag("--mirror", o.mirror, "For printing on the sheet's back");
    addChoice(command, "--method", o.method, {"nearest", "area", "guard"}, "nearest, area or guard")
        ->capture_default_str();
    add("--guard", o.guard, t.guard, Unit::none, "With --method guard: part of a strip that its blended edges take")
        ->capture_default_str();
    add("--border-mm", o.borderMm, t.border, Unit::millimeter, "White paper around trim and bleed, on every side");
    command.add_flag("--dither", o.dither, "Dither to 8 bits");
    command.add_flag("--crosstalk-compensation", o.compensate,
                     "Change the views so that the sheet's mixing of them shows less");
    add("--ink-um", o.inkUm, t.inkSpread, Unit::micrometer,
        "How far a printed point spreads (standard deviation), for cross-talk");
    addChoice(command, "--bits", o.bits, {"8", "16"}, "Bits per channel")->capture_default_str();
    addChoice(command, "--compression", o.compression, {"none", "deflate"},
              "Compression of a TIFF: none, which every print shop reads, or deflate")
        ->capture_default_str();
    add("--tile-mm", o.tileMm, t.tileWidth, Unit::millimeter, "Cut into files of about this width, between lenses");
    command.add_option("--sheet", o.sheet, "A known sheet, such as 60-3d or 75-flip");
    add("--radius-um", o.radiusUm, t.radius, Unit::micrometer, "Radius of the lenses, in micrometers");
    add("--thickness-um", o.thicknessUm, t.thickness, Unit::micrometer,
        "Thickness of the sheet, from lens top to print");
    add("--index", o.index, t.refractiveIndex, Unit::none, "Refractive index")->capture_default_str();
    add("--conic", o.conic, t.conic, Unit::none, "Conic constant of the lenses; 0 is a circle")->capture_default_str();
}

}  // namespace vitrine::app
