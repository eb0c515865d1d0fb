#pragma once

#include "exhibits/study/study_judge.h"

#include <functional>
#include <vector>

namespace vitrine::study {

/// Search of a study with many parameters: decides which settings to measure next.
class StudySearch {
public:
    using Add = std::function<void(const Setting&)>;

    /// Arguments must outlive it. `add` adds a point for a new setting, to be measured; `judge` updates the result with
    /// what was measured.
    StudySearch(Subjects subjects, const StudyRequest& request, const StudyResult& result, Add add,
                std::function<void()> judge)
        : request_(request), result_(result), errors_(subjects, request), add_(std::move(add)), judge_(std::move(judge))
    {
    }

    /// Adds the next settings. Returns false when the search is over.
    bool advance();

private:
    /// One value of one axis, with all others at present values.
    struct Step {
        double error = 0;  ///< Difference from the picture with this axis exact.
        double ratio = 1;  ///< Ratio of its cost to that of the present setting; 1 if they differ by noise only.
        bool operator==(const Step&) const = default;
    };

    [[nodiscard]] std::size_t mostSettings() const;
    [[nodiscard]] bool hasRoom() const;
    /// Adds settings that change one parameter alone, which shows its effect and cost.
    void addEachAlone();
    /// Adds settings around the front, while it moves and settings are left.
    void addAroundFront();
    void measureSteps();
    [[nodiscard]] double presentCost() const;
    /// Returns the cost of a setting: `present` if it does the same work or differs by noise only.
    [[nodiscard]] double searchedCost(const StudyPoint&, double present) const;
    [[nodiscard]] std::vector<Setting> predictedFront() const;
    /// Returns the distance from the requested limit, as a logarithm; 0 without a limit.
    [[nodiscard]] double fromLimit(double error, double cost) const;
    [[nodiscard]] std::vector<std::size_t> searchedFront();

    const StudyRequest& request_;
    const StudyResult& result_;
    StudyJudge errors_;
    Add add_;
    std::function<void()> judge_;
    int generation_ = 0;
    std::vector<std::vector<Step>> steps_;  ///< By axis and value.
};

}  // namespace vitrine::study
