#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::ui {

/// Parameters behind the sliders of the exploration.
struct ExploreParameters final : Parameters {
    Real strength = real(
        "strength", 0.4, percent, {0, 1},
        "Amount by which the variations differ from the current settings: 100 % uses the full range of the sliders.");
};
[[nodiscard]] inline const ExploreParameters& exploreParameters()
{
    static const ExploreParameters rows;
    return rows;
}

}  // namespace vitrine::ui
