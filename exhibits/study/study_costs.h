#pragma once

#include "exhibits/study/kept_study.h"
#include "exhibits/study/study_result.h"
#include "render/measure/statistics.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// The cost axis of a chart of errors: milliseconds of a picture, or counted work.
enum class CostAxis : std::uint8_t { time, work };

/// The axis of a study until the user chooses another one: time, if its clock can be trusted.
[[nodiscard]] constexpr CostAxis usualCostAxis(bool clockTrusted)
{
    return clockTrusted ? CostAxis::time : CostAxis::work;
}

/// Cost of one setting; all 0 while it is not measured. Counted work is its own interval, with confidence 1.
struct SettingCost {
    double cost = 0;
    render::Interval interval;
};

/// Costs of the settings of a study along one axis, and what follows from them.
struct StudyCosts {
    CostAxis axis = CostAxis::time;
    std::string name;  ///< "ms" or a counter; empty while no counter is known to tell the settings apart.
    std::vector<SettingCost> settings;
    std::vector<std::size_t> front;  ///< Settings by growing cost.
    std::optional<std::size_t> knee;
    std::optional<render::PowerLaw> law;  ///< Cost over error along the front of one or two parameters, one numeric.
    std::size_t parameters = 1;           ///< Number of parameters that the study varied.

    [[nodiscard]] bool onFront(std::size_t setting) const;
};

[[nodiscard]] StudyCosts costsAlong(CostAxis, const StudyRequest&, const StudyResult&);
[[nodiscard]] StudyCosts costsAlong(CostAxis, const KeptStudy&);

/// Returns the counter that distinguishes the settings best: the first one of work per pixel that differs enough,
/// otherwise the one that differs most. Empty if there is none. Each element contains the counters of one setting.
[[nodiscard]] std::string mostTellingCounter(const std::vector<std::map<std::string, double>>&);

/// Returns the law of cost over error; nothing for fewer than three points with positive error and cost.
[[nodiscard]] std::optional<render::PowerLaw> costLaw(const std::vector<double>& errors,
                                                      const std::vector<double>& costs);

}  // namespace vitrine::study
