#pragma once

#include "app/queue/shard.h"
#include "exhibits/jobs/kit/job.h"
#include "render/files/strict_json.h"

namespace vitrine::render::gl {
class Renderer;
struct ContextInfo;
}  // namespace vitrine::render::gl

namespace vitrine::app {

/// Creates the backend of a job, which draws with this renderer. It times each pass if the job needs it.
[[nodiscard]] std::unique_ptr<render::RenderBackend> backendOf(const jobs::Job&, std::shared_ptr<render::gl::Renderer>);

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
