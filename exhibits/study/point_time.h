#pragma once

#include "exhibits/study/study_result.h"
#include "render/measure/statistics.h"

#include <optional>

namespace vitrine {

/// Milliseconds of one picture: the mean of the views in each run that all of them have. Nothing before the first.
[[nodiscard]] std::optional<render::Summary> timeOf(const StudyPoint&);

}  // namespace vitrine
