#pragma once

#include "exhibits/framework/scene/offers_comparisons.h"
#include "exhibits/museum/scene_state.h"

#include <string_view>
#include <vector>

namespace vitrine::compare {

/// Returns the comparisons that the subject offers; empty if none.
[[nodiscard]] std::vector<OfferedComparison> offeredComparisons(const SceneObject&);

/// Returns the comparison of that name. Throws Failure (ErrorKind::usage) that lists the names.
[[nodiscard]] OfferedComparison offeredComparison(const SceneObject&, std::string_view name);

/// Returns B of the comparison: A with the offered values of that subject, without their motions.
[[nodiscard]] SceneState otherSide(const SceneState& a, std::size_t subject, const OfferedComparison&);

}  // namespace vitrine::compare
