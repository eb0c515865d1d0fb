#pragma once

#include "exhibits/study/study_result.h"

#include <vector>

namespace vitrine {

/// The timed points that keep the request's limit in every view, best last: the cheapest or the most exact, and of
/// those that cannot be told from it the one that changes the fewest parameters.
[[nodiscard]] std::vector<std::size_t> choiceCandidates(const StudyRequest&, const StudyResult&);

}  // namespace vitrine
