#pragma once

#include "render/measure/metrics.h"

#include <string>

namespace vitrine::app {

/// The metric of that name. Throws Failure (Blame::usage) naming the option and all metrics.
[[nodiscard]] render::Metric metricOption(const std::string& option, const std::string& name);

}  // namespace vitrine::app
