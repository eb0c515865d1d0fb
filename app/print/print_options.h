#pragma once

#include "app/jobs/typed_parameters.h"
#include "app/print/view_options.h"
#include "app/queue/shard.h"
#include "exhibits/printing/print_table.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// What `print` can be told, as typed. Sheet, print and output are parameters of the print table.
struct PrintOptions {
    ViewOptions views;
    PartOptions part;
    std::string chart;        ///< Name of a choice of `PrintTable::chart`; empty: a print of views.
    double chartPercent = 1;  ///< Span of a pitch chart, each way.
    std::string out, report, sheet;
    TypedParameters typed;
    ParameterValues values{printing::printTable()};  ///< Of `typed`, chart and sheet, once they are read.
};

void addPrintOptions(CLI::App&, PrintOptions&);

/// Reads what was typed. Throws Failure (Blame::usage) naming an option that is missing, cannot be, or changes nothing
/// beside the others. Beside a sheet, the LPI that is given is the measured one.
void readPrintOptions(const CLI::App&, PrintOptions&);

}  // namespace vitrine::app
