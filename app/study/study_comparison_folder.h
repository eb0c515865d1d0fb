#pragma once

#include "exhibits/study/study_comparison.h"

#include <filesystem>
#include <vector>

namespace vitrine::app {

/// Throws Failure (Blame::usage) when the folder is there and holds anything but such a comparison.
void requireStudyComparisonFolder(const std::filesystem::path&);

/// Writes study-comparison.json, study-comparison.csv, chart.svg, chart.png and index.html, all or nothing, as
/// `writeStudyFolder`. The first comparison is what the files hold; the page shows the same studies by the cost of any
/// of them, one at a time. Throws Failure (Blame::file).
void writeStudyComparisonFolder(const std::filesystem::path&, const std::vector<KeptStudy>&,
                                const std::vector<StudyComparison>&);

}  // namespace vitrine::app
