#pragma once

#include "app/jobs/typed_parameters.h"
#include "app/print/view_options.h"
#include "app/queue/shard.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// What `print` can be told. Parameters of the print table are `typed`, and `views.values` once they are read.
struct PrintOptions {
    ViewOptions views;
    PartOptions part;
    bool isChart = false;  ///< A chart, in place of a print of views.
    std::string out, report, sheet;
    TypedParameters typed;
};

void addPrintOptions(CLI::App&, PrintOptions&);

/// Reads what was typed. Throws Failure (Blame::usage) naming an option that is missing, cannot be, or changes nothing
/// beside the others. Beside a sheet, the LPI that is given is the measured one.
void readPrintOptions(const CLI::App&, PrintOptions&);

}  // namespace vitrine::app
