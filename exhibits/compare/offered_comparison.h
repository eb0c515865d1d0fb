#pragma once

#include "exhibits/framework/offers_comparisons.h"
#include "exhibits/museum/scene_state.h"

#include <string_view>
#include <vector>

namespace vitrine {

/// What the subject offers to be compared with; empty where it offers nothing.
[[nodiscard]] std::vector<OfferedComparison> offeredComparisons(const Subject&);

/// The one of that name. Throws Failure (Blame::usage) with the names that there are.
[[nodiscard]] OfferedComparison offeredComparison(const Subject&, std::string_view name);

/// B of the comparison: everything as in A but for the offered rows of that subject, which do not move.
[[nodiscard]] SceneState otherSide(const SceneState& a, std::size_t subject, const OfferedComparison&);

}  // namespace vitrine
