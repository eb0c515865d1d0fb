#pragma once

#include "exhibits/study/study_comparison.h"

#include <filesystem>
#include <vector>

namespace vitrine::app {

/// Throws Failure (ErrorKind::usage) if the folder exists and contains anything but such a comparison.
void requireStudyComparisonFolder(const std::filesystem::path&);

/// Writes study-comparison.json, study-comparison.csv, chart.svg, chart.png and index.html, all or nothing, like
/// `writeStudyFolder`. The files contain the first comparison. The page shows all of them, one at a time. Throws
/// Failure (ErrorKind::file).
void writeStudyComparisonFolder(const std::filesystem::path&, const std::vector<study::KeptStudy>&,
                                const std::vector<study::StudyComparison>&);

}  // namespace vitrine::app
