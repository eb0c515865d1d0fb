#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::jobs {

enum class Separator : int { comma, semicolon, tabulator };

/// Parameters of a table of measurements.
struct MeasurementsTable final : Parameters {
    Group fileGroup = group("File");
    Choice<Separator> separator =
        choice("separator", Separator::comma, {"comma", "semicolon", "tab"},
               "Character between two columns. Spreadsheets of countries with a decimal comma expect a semicolon.");
    Count lines =
        count("lines", 0, Range{1, 1000000, logarithmic}.soft(1, 1000),
              "Number of lines that are measured, from the first one. All: the whole table.", reads(0, "all"));
};

}  // namespace vitrine::jobs
