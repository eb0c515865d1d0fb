#pragma once

#include "app/jobs/typed_parameters.h"
#include "app/kit/picture_options.h"
#include "exhibits/jobs/kit/job.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Arguments of a job as they are typed, or given to the service.
struct JobArguments {
    TypedParameters parameters;
    PictureOptions scene;
    std::array<std::string, 2> compared;  ///< Settings A and B, of a job that compares two.
    std::string out, like, report;
    bool dryRun = false;
};

/// Adds an option for each parameter of the job, and those that all jobs have. Both must outlive the command's use.
void addJobArguments(CLI::App&, const jobs::Job&, JobArguments&);

/// Museum of a job, and its state before the arguments are applied.
struct JobStart {
    std::function<const Museum&()> museum;  ///< Called for a job with a scene only.
    const SceneState* state = nullptr;      ///< Null: the museum's initial one.
    /// Camera of an exhibit; nullopt: its best view.
    std::function<std::optional<render::Camera>(const std::string& exhibit)> camera = {};
    bool answers = false;  ///< The job answers what it made, and writes nothing.
};

/// Job that the arguments order, without a backend.
struct OrderedJob {
    jobs::JobOrder order;
    jobs::JobPlan plan;
    std::vector<std::string> notes;  ///< Sentences on corrected values.
};
/// Returns the job. Throws Failure (ErrorKind::usage) naming the option that is wrong, and the failures of reading the
/// job's files.
[[nodiscard]] OrderedJob orderedJob(const CLI::App&, const jobs::Job&, const JobArguments&, const JobStart&);

}  // namespace vitrine::app
