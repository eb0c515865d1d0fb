#pragma once

#include "exhibits/framework/parameters.h"

namespace vitrine::ui {

/// Parameters behind the sliders of the exploration.
struct ExploreRows final : Parameters {
    Real strength = real("strength", 0.4, percent, {0, 1},
                         "How far the variations go from the look that they vary: at 100 % anywhere within the "
                         "comfortable ranges.");
};
[[nodiscard]] inline const ExploreRows& exploreRows()
{
    static const ExploreRows rows;
    return rows;
}

}  // namespace vitrine::ui
