#pragma once

#include "exhibits/jobs/comparison/comparison_json.h"

#include <string>

namespace vitrine::jobs {

/// Returns an HTML page with both pictures (wipe, side by side, flicker, differences), the costs pass by pass, and the
/// differing parameters. It needs the folder pictures/ beside it, and no network.
[[nodiscard]] std::string comparisonPage(Subjects, const compare::Comparison&, const ComparisonText&);

}  // namespace vitrine::jobs
