#pragma once

#include "exhibits/jobs/kit/job.h"

#include <memory>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// The jobs, in the order in which the help names them. jobs.cpp is the only place that names them all.
[[nodiscard]] const std::vector<std::unique_ptr<const Job>>& allJobs();
/// The job of that name; null: there is none.
[[nodiscard]] const Job* findJob(std::string_view name);

}  // namespace vitrine::jobs
