#include "app/print/print_options.h"

#include "app/number_option.h"
#include "app/useless_option.h"
#include "exhibits/framework/value_text.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/picture_formats.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

using printing::printTable;

const ParameterInfo& chartRow()
{
    return printTable().rows()[printTable().chart.row];
}

void refuseUselessOptions(const CLI::App& command, const PrintOptions& o)
{
    refuseWithout(command, "--chart-span", o.chart == "pitch", "--chart pitch");
    refuseWithout(command, "--view-format", !o.views.saveViews.empty(), "--save-views");
    refuseOn(command, "--compression", render::lowerExtension(o.out) == ".png", "a PNG, which is always compressed");
    for (const char* option :
         {"--views", "--quilt", "--exhibit", "--crosstalk-compensation", "--fit", "--place", "--every", "--ping-pong"})
        refuseOn(command, option, !o.chart.empty(), "a --chart, which has views of its own");
    for (const char* option : {"--radius-um", "--thickness-um", "--index", "--conic", "--lens", "--zone"})
        refuseOn(command, option, !o.sheet.empty(), "a --sheet, whose lenses are known");
    if (o.values[printTable().border] != 0 && !o.chart.empty())
        throw Failure(Blame::usage, "--border-mm: charts have a border of their own.");
    refuseUselessSceneOptions(command, o.views.scene);
}

}  // namespace

void addPrintOptions(CLI::App& command, PrintOptions& o)
{
    const printing::PrintTable& t = printTable();
    addViewOptions(command, o.views);
    addChoice(command, "--chart", o.chart, {chartRow().choices.begin(), chartRow().choices.end()},
              "Chart to calibrate with, in place of views. " + std::string(chartRow().help));
    addNumber(command, "--chart-span", o.chartPercent, rangeOf(t, t.chartSpan, Unit::percent),
              std::string(t.rows()[t.chartSpan.row].help))
        ->capture_default_str();
    command.add_option("--out", o.out,
                       "Output print: " + render::streamedExtensions() + "; may be left out with --save-views");
    command.add_option("--report", o.report,
                       "Also write the print's description here, as JSON; it always lies beside the print and in it");
    command.add_option("--sheet", o.sheet, "A known sheet, such as 60-3d or 75-flip");
    o.typed.addTo(command, t, [](const ParameterInfo& row) {
        return row.group == "Sheet" || row.group == "Print" || row.group == "Output";
    });
}

void readPrintOptions(const CLI::App& command, PrintOptions& o)
{
    const printing::PrintTable& t = printTable();
    jobs::GivenValues given(t);
    o.typed.read(command, given);
    o.values = given.settled("vitrine print");
    if (!o.chart.empty()) {
        const std::optional<Value> chart = parseValue(chartRow(), o.chart);
        if (chart) o.values.setRow(t.chart.row, *chart);
        o.values.set(t.chartSpan, o.chartPercent / 100);
    }
    refuseUselessOptions(command, o);
    const bool lpiGiven = command.get_option("--lpi")->count() > 0;
    if (!lpiGiven && o.sheet.empty())
        throw Failure(Blame::usage, "--lpi is missing: give the sheet's lenses per inch, or a --sheet.");
    if (o.sheet.empty()) return;
    printing::Sheet sheet = printing::knownSheet(o.sheet);
    if (lpiGiven) sheet.effectiveLpi = o.values[t.lensesPerInch];
    if (o.values[t.measuredPerInch] != 0) sheet.effectiveLpi = o.values[t.measuredPerInch];
    o.values = withSheet(o.values, sheet);
}

}  // namespace vitrine::app
