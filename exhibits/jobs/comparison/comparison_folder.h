#pragma once

#include "exhibits/jobs/comparison/comparison_json.h"

#include <filesystem>

namespace vitrine::jobs {

/// Throws Failure (ErrorKind::usage) if the folder exists and contains anything but a comparison.
void requireComparisonFolder(const std::filesystem::path&);

/// Writes index.html, comparison.json and the pictures of a finished comparison: a.png and b.png with their presets
/// inside, and the differences flip-G.png and signed-G.png for each factor G. All files are written beside the folder
/// first, which is then replaced; files of others stay in it. Throws Failure (ErrorKind::file).
void writeComparisonFolder(const std::filesystem::path&, Subjects, const compare::Comparison&, const ComparisonText&);

}  // namespace vitrine::jobs
