#pragma once

#include "exhibits/study/study_result.h"
#include "render/measure/pareto.h"

#include <span>
#include <string>
#include <vector>

namespace vitrine::study {

/// Returns whether pictures in motion are studied; the reference is then a converged picture.
[[nodiscard]] bool studiesMotion(const StudyRequest&);

/// Evaluation of the pictures and times of a study.
class StudyJudge {
public:
    /// Subjects and request must outlive it.
    StudyJudge(Subjects subjects, const StudyRequest& request) : subjects_(subjects), request_(request) {}

    [[nodiscard]] Errors errorsOf(const render::Image& reference, const render::Image& picture) const;
    /// The same by the request's metric alone; 0 if the pictures lack its channels.
    [[nodiscard]] double errorOf(const render::Image& reference, const render::Image& picture) const;
    /// Returns one error for all views: the root mean square of RMS errors, the largest of maxima, otherwise the mean.
    [[nodiscard]] double pooled(const std::vector<double>& errors) const;
    /// Computes everything that follows from the points' shots and the reference's uncertainty. `doublings` is how
    /// often the reference was made twice as exact.
    void judge(StudyResult&, int doublings) const;

private:
    void judgePoint(StudyPoint&, double uncertainty) const;
    [[nodiscard]] bool isPresent(const StudyPoint&) const;
    [[nodiscard]] std::string convergenceSentence(const StudyResult&, std::size_t uncertainErrors, double smallestError,
                                                  int doublings) const;
    /// Returns why all settings give the same picture: the declared reason, or that nothing depends on them at present.
    [[nodiscard]] std::string samenessSentence() const;
    void judgeCosts(StudyResult&) const;
    void fitLaw(StudyResult&, std::span<const render::CostAndError>) const;

    Subjects subjects_;
    const StudyRequest& request_;
};

}  // namespace vitrine::study
