#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::ui {

/// Parameters behind the sliders of the comparison.
struct CompareParameters final : Parameters {
    Real towardsB = real("towardsB", 0, percent, {0, 1},
                         "Position between settings A (0 %) and B (100 %). Numbers change evenly or by factors, colors "
                         "evenly to the eye, angles the shorter way; settings without values between switch in the "
                         "middle. One drag is one undo step.");
    Count gain = count("gain", 8, {1, 64, logarithmic}, "Factor by which differences are multiplied, 1 to 64.");
};
[[nodiscard]] inline const CompareParameters& compareParameters()
{
    static const CompareParameters rows;
    return rows;
}

}  // namespace vitrine::ui
