#pragma once

#include "app/queue/shard.h"
#include "exhibits/jobs/kit/job.h"
#include "render/files/strict_json.h"

namespace vitrine::render::gl {
class Renderer;
struct ContextInfo;
}  // namespace vitrine::render::gl

namespace vitrine::app {

/// Creates a backend that draws without a window, and stores what draws in `info`. `timesPasses`: it times each pass.
/// Throws Failure (ErrorKind::openGl).
[[nodiscard]] std::unique_ptr<render::RenderBackend> headlessBackend(render::gl::ContextInfo* info = nullptr,
                                                                     bool timesPasses = false);
/// Creates a backend that draws with this renderer.
[[nodiscard]] std::unique_ptr<render::RenderBackend> sharedBackend(std::shared_ptr<render::gl::Renderer>);

/// Form in which the outcome of a job is printed.
enum class Outcome : unsigned char { text, json, nothing };

/// Runs a job, or the part of it that the options name, to its end on this thread. Prints the outcome in that form.
/// A stop signal stops it in an orderly way. Returns the exit code. Throws Failure (ErrorKind::usage) if the plan has a
/// refusal, and the failures of the run.
int runJob(const jobs::Job&, jobs::JobOrder, const jobs::JobPlan&, const PartOptions&, Outcome);

/// Returns the outcome of the job.
[[nodiscard]] render::Json reportJson(const jobs::Job&, const jobs::JobReport&);

/// Returns or prints the plan of the job.
[[nodiscard]] render::Json planJson(const jobs::Job&, const jobs::JobPlan&);
void printPlan(const jobs::Job&, const jobs::JobPlan&, bool asJson);

}  // namespace vitrine::app
