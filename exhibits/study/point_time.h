#pragma once

#include "exhibits/study/study_result.h"
#include "render/measure/statistics.h"

#include <optional>

namespace vitrine::study {

/// Returns the time of one picture in milliseconds: the mean of the views in each run that is complete. Nothing before
/// the first.
[[nodiscard]] std::optional<render::Summary> timeOf(const StudyPoint&);

}  // namespace vitrine::study
