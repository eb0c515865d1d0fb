#pragma once

#include "exhibits/framework/table/parameters.h"

#include <variant>

namespace vitrine {

/// Returns whether pictures with these values of the hall may have halos. A halo reaches beyond a part of the picture,
/// so that such a part cannot be drawn by itself.
[[nodiscard]] inline bool mayHaveHalos(const ParameterValues& hall)
{
    const auto row = hall.table().find("glare");
    return row && std::get<double>(hall.row(*row)) > 0;
}

}  // namespace vitrine
