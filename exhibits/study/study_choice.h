#pragma once

#include "exhibits/study/study_result.h"

#include <vector>

namespace vitrine::study {

/// Returns the timed points within the request's limit in every view, best last: the cheapest or the most exact. Among
/// points indistinguishable from it, the one that changes the fewest parameters is best.
[[nodiscard]] std::vector<std::size_t> choiceCandidates(const StudyRequest&, const StudyResult&);

}  // namespace vitrine::study
