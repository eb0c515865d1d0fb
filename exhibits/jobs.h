#pragma once

#include "exhibits/jobs/kit/job.h"

#include <memory>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Returns the jobs in the order of the help. jobs.cpp is the only place that names them all.
[[nodiscard]] const std::vector<std::unique_ptr<const Job>>& allJobs();
/// Returns the job of that name; null if there is none.
[[nodiscard]] const Job* findJob(std::string_view name);

}  // namespace vitrine::jobs
