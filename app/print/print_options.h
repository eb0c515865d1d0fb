#pragma once

#include "app/jobs/typed_parameters.h"
#include "app/print/view_options.h"
#include "app/queue/shard.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Options of `print`. `typed` holds the parameters of the print table as typed; `views.values` holds their values
/// after `readPrintOptions`.
struct PrintOptions {
    ViewOptions views;
    PartOptions part;
    bool isChart = false;  ///< A chart, in place of a print of views.
    std::string out, report, sheet;
    TypedParameters typed;
};

void addPrintOptions(CLI::App&, PrintOptions&);

/// Reads the typed options. Throws Failure (ErrorKind::usage) naming an option that is missing, impossible, or without
/// effect together with the others. If a sheet is given, --lpi is its measured value.
void readPrintOptions(const CLI::App&, PrintOptions&);

}  // namespace vitrine::app
