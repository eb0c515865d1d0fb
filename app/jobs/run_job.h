#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::app {

/// Creates a backend that draws without a window: an OpenGL context and a renderer that uses it. Throws Failure
/// (Blame::openGl).
[[nodiscard]] std::unique_ptr<render::RenderBackend> headlessBackend();

/// Runs a job to its end on this thread and prints what it did, as text or JSON. A stop signal stops it in an orderly
/// way. Returns the exit code. Throws Failure (Blame::usage) for what the plan refuses, else as the run does.
int runJob(const jobs::Job&, jobs::JobOrder, const jobs::JobPlan&, bool asJson);

/// Prints what the job would do.
void printPlan(const jobs::Job&, const jobs::JobPlan&, bool asJson);

}  // namespace vitrine::app
