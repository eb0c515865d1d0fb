#pragma once

#include <string>
#include <vector>

namespace vitrine {

/// One line of a chart: a value of y for each of x, which rises.
struct ChartCurve {
    std::string name;
    std::vector<double> x, y;
};

/// Curves over the same axes.
struct Chart {
    std::string title;
    std::string xTitle, yTitle;  ///< With the unit, where there is one.
    bool logarithmic = false;    ///< Both axes; values that are not above 0 are left out.
    std::vector<ChartCurve> curves;
};

}  // namespace vitrine
