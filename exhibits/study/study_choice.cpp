#include "exhibits/study/study_choice.h"

#include <algorithm>
#include <utility>

namespace vitrine::study {

std::vector<std::size_t> choiceCandidates(const StudyRequest& request, const StudyResult& result)
{
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const StudyPoint& point = result.points[i];
        if (!point.time) continue;
        const bool keeps = request.maxError ? point.worstError <= *request.maxError
                                            : point.time->interval.high <= *request.maxMilliseconds;
        if (keeps) candidates.push_back(i);
    }
    if (candidates.empty()) return candidates;
    const auto badness = [&](std::size_t i) {
        const StudyPoint& p = result.points[i];
        return request.maxError ? std::pair(p.cost, p.worstError) : std::pair(p.worstError, p.cost);
    };
    // Sorted so that the best is last, by median time or by worst error, and then by the other.
    std::sort(candidates.begin(), candidates.end(),
              [&](std::size_t a, std::size_t b) { return badness(a) > badness(b); });
    if (!result.present) return candidates;
    // Among points indistinguishable from the best, the one that changes the fewest parameters comes last, then the
    // most exact.
    const StudyPoint& best = result.points[candidates.back()];
    const auto asGood = std::stable_partition(candidates.begin(), candidates.end(), [&](std::size_t i) {
        const StudyPoint& p = result.points[i];
        return request.maxError ? !result.costsTheSame(p, best) : p.worstError > best.worstError;
    });
    const Setting& present = result.points[*result.present].setting;
    const auto changes = [&](std::size_t i) {
        std::size_t count = 0;
        for (std::size_t a = 0; a < present.size(); ++a) count += result.points[i].setting[a] != present[a] ? 1 : 0;
        return count;
    };
    std::stable_sort(asGood, candidates.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(changes(a), result.points[a].worstError) > std::pair(changes(b), result.points[b].worstError);
    });
    return candidates;
}

}  // namespace vitrine::study
