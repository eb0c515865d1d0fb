#pragma once

#include "exhibits/study/study_result.h"
#include "render/measure/statistics.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vitrine::study {

/// Returns the time of one picture in milliseconds: the mean of the views in each run that is complete. Nothing before
/// the first.
[[nodiscard]] std::optional<render::Summary> timeOf(const StudyPoint&);

/// Returns whether more runs would not change which points take longer than this one: the interval of its median has a
/// confidence of 95 % (six runs), and its times are farther from those of every other point that has some than the
/// times of either are from each other.
[[nodiscard]] bool isRanked(const std::vector<StudyPoint>&, std::size_t point);

}  // namespace vitrine::study
