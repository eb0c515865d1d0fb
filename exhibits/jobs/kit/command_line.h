#pragma once

#include "exhibits/jobs/kit/job.h"

#include <string>
#include <vector>

namespace vitrine::jobs {

/// Returns the command line, without the program's name, that runs the job with these values again. Parameters without
/// effect are left out.
[[nodiscard]] std::vector<std::string> commandOf(const Job&, const JobOrder&);

}  // namespace vitrine::jobs
