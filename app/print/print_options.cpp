#include "app/print/print_options.h"

#include "app/kit/useless_option.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/picture_formats.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

using printing::printTable;

/// Returns whether the command has an option for the parameter. The others have options of their own, or none.
bool isOption(const ParameterInfo& row)
{
    return row.group != "Views" || row.name == "fitting" || row.name == "convergence";
}

void refuseUselessOptions(const CLI::App& command, const PrintOptions& o)
{
    const ParameterValues& values = o.views.values;
    refuseWithout(command, "--chart-span", o.isChart && values[printTable().chart] == printing::ChartKind::pitch,
                  "--chart pitch");
    refuseWithout(command, "--convergence", !o.views.scene.subject.empty(), "--exhibit");
    refuseWithout(command, "--view-format", !o.views.saveViews.empty(), "--save-views");
    refuseOn(command, "--compression", render::lowerExtension(o.out) == ".png", "a PNG, which is always compressed");
    for (const char* option :
         {"--views", "--quilt", "--exhibit", "--crosstalk-compensation", "--fit", "--place", "--every", "--ping-pong"})
        refuseOn(command, option, o.isChart, "a --chart, which has views of its own");
    for (const char* option : {"--radius-um", "--thickness-um", "--index", "--conic", "--lens", "--zone"})
        refuseOn(command, option, !o.sheet.empty(), "a --sheet, whose lenses are known");
    if (values[printTable().border] != 0 && o.isChart)
        throw Failure(ErrorKind::usage, "--border-mm: charts have a border of their own.");
    refuseUselessSceneOptions(command, o.views.scene);
}

}  // namespace

void addPrintOptions(CLI::App& command, PrintOptions& o)
{
    o.typed.addTo(command, printTable(), isOption);
    CLI::Option* chart = command.get_option("--chart");
    chart->description("Calibration chart to print in place of views. " + chart->get_description())->default_str("");
    addViewOptions(command, o.views);
    command.add_option("--out", o.out,
                       "Output file of the print: " + render::streamedExtensions() + "; optional with --save-views");
    command.add_option(
        "--report", o.report,
        "Additional file for the print's description, as JSON; it is always written beside the print and into it");
    command.add_option("--sheet", o.sheet,
                       "Lenticular sheet by its name, such as 60-3d or 75-flip, in place of its single numbers");
}

void readPrintOptions(const CLI::App& command, PrintOptions& o)
{
    const printing::PrintTable& t = printTable();
    ParameterValues& values = o.views.values;
    jobs::GivenValues given(t);
    o.typed.read(command, given);
    values = given.settled("vitrine print");
    o.isChart = command.get_option("--chart")->count() > 0;
    refuseUselessOptions(command, o);
    const bool lpiGiven = command.get_option("--lpi")->count() > 0;
    if (!lpiGiven && o.sheet.empty())
        throw Failure(ErrorKind::usage, "--lpi is missing: give the sheet's lenses per inch, or a --sheet.");
    if (o.sheet.empty()) return;
    printing::Sheet sheet = printing::knownSheet(o.sheet);
    if (lpiGiven) sheet.effectiveLpi = values[t.lensesPerInch];
    if (values[t.measuredPerInch] != 0) sheet.effectiveLpi = values[t.measuredPerInch];
    values = withSheet(values, sheet);
}

}  // namespace vitrine::app
