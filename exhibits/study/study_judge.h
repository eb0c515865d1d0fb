#pragma once

#include "exhibits/study/study_result.h"
#include "render/measure/pareto.h"

#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// Whether pictures in motion are studied: the reference is then one at rest.
[[nodiscard]] bool studiesMotion(const StudyRequest&);

/// What the pictures and times of a study come to.
class StudyJudge {
public:
    /// Subjects and request must outlive it.
    StudyJudge(Subjects subjects, const StudyRequest& request) : subjects_(subjects), request_(request) {}

    [[nodiscard]] Errors errorsOf(const render::Image& reference, const render::Image& picture) const;
    /// One number for all views: root mean square of RMS errors, largest of maxima, else the mean.
    [[nodiscard]] double pooled(const std::vector<double>& errors) const;
    /// Fills in what follows from the points' shots and the reference's uncertainty; `doublings` is how often the
    /// reference was made twice as exact.
    void judge(StudyResult&, int doublings) const;

private:
    void judgePoint(StudyPoint&, double uncertainty) const;
    [[nodiscard]] bool isPresent(const StudyPoint&) const;
    [[nodiscard]] std::string convergenceSentence(const StudyResult&, std::size_t uncertainErrors, double smallestError,
                                                  int doublings) const;
    /// Why all settings give the same picture: what the table declares, or that nothing depends on them at present.
    [[nodiscard]] std::string samenessSentence() const;
    void judgeCosts(StudyResult&) const;
    void fitLaw(StudyResult&, std::span<const render::CostAndError>) const;

    Subjects subjects_;
    const StudyRequest& request_;
};

}  // namespace vitrine
