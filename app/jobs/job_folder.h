#pragma once

#include "app/queue/parts.h"
#include "exhibits/jobs/kit/job.h"
#include "exhibits/study/study_parts.h"

#include <memory>

namespace vitrine::app {

/// Output of a job that writes a folder.
struct JobFolder {
    /// Throws Failure (ErrorKind::usage) if the folder exists and holds anything else.
    void (*require)(const std::filesystem::path&);
    /// Writes what the finished run made, if its pages and charts are made by the program; null: the job writes it.
    /// Throws Failure (ErrorKind::file).
    void (*write)(const std::filesystem::path&, const jobs::JobRun&);
    /// Prints the result, unless `quietly`, and limits that were not met. Returns the exit code.
    int (*tell)(const std::filesystem::path&, const jobs::JobRun&, bool quietly);
    /// Returns the measures in the parts of the output; null for a job that is not made in parts. `isPart`: this
    /// process makes one part; otherwise it merges.
    std::unique_ptr<study::StudyParts> (*measures)(Parts&, bool isPart);
};

/// Returns null for a job that writes its files itself.
[[nodiscard]] const JobFolder* folderOf(const jobs::Job&);

}  // namespace vitrine::app
