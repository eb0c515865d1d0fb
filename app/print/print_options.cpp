#include "app/print/print_options.h"

#include "render/failure.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <limits>

namespace vitrine::app {
namespace {

double numberOf(const std::string& option, const std::string& text, const char* advice)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw Failure(Blame::usage, option + " " + text + ": give " + advice + ".");
    return value;
}

double directionOf(const std::string& text)
{
    if (text == "vertical") return 0;
    if (text == "horizontal") return 90;
    return numberOf("--direction", text, "vertical, horizontal or degrees from vertical, -90 to 90");
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
    return numberOf(option, text, "millimeters, or inf");
}

render::StreamCompression streamCompression(const std::string& name)
{
    if (name == "deflate") return render::StreamCompression::deflate;
    return name == "zstd" ? render::StreamCompression::zstd : render::StreamCompression::none;
}

printing::PrintSettings printSettings(const PrintOptions& options, int views)
{
    if (options.lpi == 0 && options.sheet.empty())
        throw Failure(Blame::usage, "--lpi is 0: give the sheet's lenses per inch, or a --sheet.");
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
    if (options.dither && options.bits == 16) throw Failure(Blame::usage, "--dither is for 8 bits; 16 bits need none.");
    if (options.borderMm != 0 && !options.chart.empty())
        throw Failure(Blame::usage, "--border-mm: charts have a border of their own.");
    return settings;
}

void addPrintOptions(CLI::App& command, PrintOptions& o)
{
    addViewOptions(command, o.views);
    command
        .add_option("--chart", o.chart, "Instead of views, a sheet to calibrate with: pitch, phase, views or rotation")
        ->check(CLI::IsMember({"pitch", "phase", "views", "rotation"}));
    command.add_option("--chart-span", o.chartSpan, "Of a pitch chart, in percent each way: 1 is coarse, 0.1 fine")
        ->capture_default_str();
    command.add_option("--out", o.out, "The print: .tif or .png; may be left out with --save-views");
    command.add_option("--report", o.report,
                       "Also write the print's description here, as JSON; it always lies beside the print and in it");
    command.add_option("--lpi", o.lpi, "Lenses per inch of the sheet");
    command.add_option("--effective-lpi", o.effectiveLpi, "Lenses per inch as measured");
    command.add_option("--dpi", o.dpi, "Printed dots per inch")->capture_default_str();
    command.add_option("--dpi-y", o.dpiY, "The same along the other side, when it differs");
    command.add_option("--width-mm", o.widthMm, "Trimmed width")->required();
    command.add_option("--height-mm", o.heightMm, "Trimmed height")->required();
    command.add_option("--bleed-mm", o.bleedMm, "Beyond the trim on every side");
    command.add_option("--distance-mm", o.distance, "From which it is looked at, or inf")->capture_default_str();
    command.add_option("--visual-lpi", o.visualLpi, "Lenses per inch as read from a pitch chart at that distance");
    command.add_option("--phase", o.phase, "Moves the strips under the lenses, in lenses");
    command.add_option("--direction", o.direction, "Of the lenses: vertical, horizontal or degrees from vertical")
        ->capture_default_str();
    command.add_option("--order", o.order, "normal or reverse")
        ->capture_default_str()
        ->check(CLI::IsMember({"normal", "reverse"}));
    command.add_flag("--mirror", o.mirror, "For printing on the sheet's back");
    command.add_option("--method", o.method, "nearest, area or guard")
        ->capture_default_str()
        ->check(CLI::IsMember({"nearest", "area", "guard"}));
    command.add_option("--guard", o.guard, "With --method guard: part of a strip that its blended edges take")
        ->capture_default_str();
    command.add_option("--border-mm", o.borderMm, "White paper around trim and bleed, on every side");
    command.add_flag("--dither", o.dither, "Spread what 8 bits cannot say over neighboring pixels");
    command.add_flag("--crosstalk-compensation", o.compensate,
                     "Change the views so that the sheet's mixing of them shows less");
    command.add_option("--ink-um", o.inkUm, "How far a printed point spreads (standard deviation), for cross-talk");
    command.add_option("--bits", o.bits, "8 or 16")->capture_default_str()->check(CLI::IsMember({8, 16}));
    command.add_option("--compression", o.compression, "Of TIFF: none, deflate or zstd")
        ->capture_default_str()
        ->check(CLI::IsMember({"none", "deflate", "zstd"}));
    command.add_option("--tile-mm", o.tileMm, "Cut into files of about this width, between lenses");
    command.add_option("--sheet", o.sheet, "A known sheet, such as 60-3d or 75-flip");
    command.add_option("--radius-um", o.radiusUm, "Of the lenses, in micrometers");
    command.add_option("--thickness-um", o.thicknessUm, "Of the sheet, from lens top to print");
    command.add_option("--index", o.index, "Of refraction")->capture_default_str();
    command.add_option("--conic", o.conic, "Conic constant of the lenses; 0 is a circle")->capture_default_str();
}

}  // namespace vitrine::app
