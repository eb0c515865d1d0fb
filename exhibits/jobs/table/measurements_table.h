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
};

}  // namespace vitrine::jobs
