#pragma once

#include <string>
#include <vector>

namespace vitrine {

/// Curve of a chart: a value of y for each of the increasing x.
struct ChartCurve {
    std::string name;
    std::vector<double> x, y;
};

/// Curves over the same axes.
struct Chart {
    std::string title;
    std::string xTitle, yTitle;  ///< Titles with units, if there are any.
    bool logarithmic = false;    ///< Both axes; values of 0 or less are left out.
    std::vector<ChartCurve> curves;
};

}  // namespace vitrine
