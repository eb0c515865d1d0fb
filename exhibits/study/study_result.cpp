#include "exhibits/study/study_result.h"

#include "render/measure/distance.h"

#include <algorithm>

namespace vitrine::study {

bool goesByColor(const StudyRequest& request)
{
    return render::metricInfo(request.metric).ofColor;
}

bool isDrawn(const StudyPoint& point)
{
    return std::all_of(point.shots.begin(), point.shots.end(),
                       [](const StudyShot& shot) { return !shot.picture.empty(); });
}

bool StudyResult::costsTheSame(const StudyPoint& a, const StudyPoint& b) const
{
    if (a.counters == b.counters) return true;
    return costName == "ms" && a.time && b.time ? render::indistinguishable(*a.time, *b.time) : a.cost == b.cost;
}

}  // namespace vitrine::study
