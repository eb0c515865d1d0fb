#pragma once

#include "exhibits/study/study_judge.h"

#include <functional>
#include <vector>

namespace vitrine {

/// How a study of many parameters finds its way: which settings to measure next.
class StudySearch {
public:
    using Add = std::function<void(const Setting&)>;

    /// All must outlive it. `add` makes a point of a setting that is new, to be measured; `judge` brings the result up
    /// to date with what was measured.
    StudySearch(Subjects subjects, const StudyRequest& request, const StudyResult& result, Add add,
                std::function<void()> judge)
        : request_(request), result_(result), errors_(subjects, request), add_(std::move(add)), judge_(std::move(judge))
    {
    }

    /// Adds the next settings. Returns false when the search is over.
    bool advance();

private:
    /// One value of one axis, with all others as they are at present.
    struct Step {
        double error = 0;  ///< From the picture with this axis exact.
        double ratio = 1;  ///< Of its cost to that of the present setting; 1 where the two differ by noise.
        bool operator==(const Step&) const = default;
    };

    [[nodiscard]] std::size_t mostSettings() const;
    [[nodiscard]] bool hasRoom() const;
    /// Each parameter alone: what it gives and what it costs.
    void addEachAlone();
    /// Around the front, as long as it moves and there is room.
    void addAroundFront();
    void measureSteps();
    [[nodiscard]] double presentCost() const;
    /// Of a setting: `present` where it does the same work or differs by noise.
    [[nodiscard]] double searchedCost(const StudyPoint&, double present) const;
    [[nodiscard]] std::vector<Setting> predictedFront() const;
    /// How far this is from what was asked for, as a logarithm; 0 when nothing was.
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

}  // namespace vitrine
