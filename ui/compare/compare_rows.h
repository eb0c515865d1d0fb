#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::ui {

/// Parameters behind the sliders of the comparison.
struct CompareRows final : Parameters {
    Real towardsB = real("towardsB", 0, percent, {0, 1},
                         "How far A is led towards B: numbers evenly or by factors, colors as they look, angles the "
                         "shorter way; what has nothing between is switched in the middle. One drag is one undo step.");
    Count gain = count("gain", 8, {1, 64, logarithmic}, "What differences are multiplied by, 1 to 64.");
};
[[nodiscard]] inline const CompareRows& compareRows()
{
    static const CompareRows rows;
    return rows;
}

}  // namespace vitrine::ui
