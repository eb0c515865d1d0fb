#pragma once

#include "exhibits/jobs/kit/job.h"

#include <filesystem>

namespace vitrine::app {

/// Throws Failure (ErrorKind::usage) if the folder exists and contains anything but a study.
void requireStudyFolder(const std::filesystem::path&);

/// Writes study.json, study.csv, chart.svg, chart.png, pictures, heat maps and index.html of a finished StudyRun, and
/// preset.json with what it chose. All files are written beside the folder first, which is then replaced, so that it
/// has all of the old study or all of the new. Throws Failure (ErrorKind::file).
void writeStudyFolder(const std::filesystem::path&, const jobs::JobRun&);

/// Prints the settings of a finished StudyRun with their errors and costs, unless `quietly`. Returns the exit code: a
/// failed check if it chose nothing though a limit was set.
int tellStudy(const std::filesystem::path&, const jobs::JobRun&, bool quietly);

}  // namespace vitrine::app
