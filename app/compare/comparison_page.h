#pragma once

#include "app/compare/comparison_folder.h"

#include <string>

namespace vitrine::app {

/// Returns an HTML page with both pictures (wipe, side by side, flicker, differences), the costs pass by pass, and the
/// differing parameters. It needs the folder pictures/ beside it, and no network.
[[nodiscard]] std::string comparisonPage(Subjects, const Comparison&, const ComparisonText&);

}  // namespace vitrine::app
