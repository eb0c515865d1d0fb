#include "exhibits/study/study_result.h"

namespace vitrine {

bool goesByColor(const StudyRequest& request)
{
    return request.metric != render::Metric::normal && request.metric != render::Metric::depth;
}

bool StudyResult::costsTheSame(const StudyPoint& a, const StudyPoint& b) const
{
    if (a.counters == b.counters) return true;
    return costName == "ms" && a.time && b.time ? render::indistinguishable(*a.time, *b.time) : a.cost == b.cost;
}

}  // namespace vitrine
