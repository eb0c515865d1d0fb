#include "app/jobs/job_folder.h"

#include "app/queue/study_in_parts.h"
#include "app/study/study_folder.h"
#include "exhibits/jobs/comparison/comparison_folder.h"
#include "exhibits/jobs/comparison/comparison_job.h"

#include <cstdio>

namespace vitrine::app {
namespace {

std::unique_ptr<study::StudyParts> measuresIn(Parts& parts, bool isPart)
{
    return std::make_unique<StudyInParts>(parts, isPart);
}

/// Prints the errors and times of a finished ComparisonRun, unless `quietly`. Returns the exit code.
int tellComparison(const std::filesystem::path& folder, const jobs::JobRun& run, bool quietly)
{
    if (quietly) return 0;
    const compare::ComparisonResult& result = static_cast<const jobs::ComparisonRun&>(run).comparison().result();
    for (const auto& [metric, error] : result.errors)
        std::printf("%-8s %.6g\n", std::string(toString(metric)).c_str(), error);
    std::printf("%zu %s; a frame of A takes %.2f ms, one of B %.2f ms.\n", result.rows.size(),
                result.rows.size() == 1 ? "parameter differs" : "parameters differ",
                result.sides[0].report.milliseconds, result.sides[1].report.milliseconds);
    std::printf("The comparison is in %s/index.html\n", folder.c_str());
    return 0;
}

}  // namespace

const JobFolder* folderOf(const jobs::Job& job)
{
    static const JobFolder study{requireStudyFolder, writeStudyFolder, tellStudy, measuresIn};
    static const JobFolder comparison{jobs::requireComparisonFolder, nullptr, tellComparison, nullptr};
    return job.name() == "study" ? &study : job.name() == "comparison" ? &comparison : nullptr;
}

}  // namespace vitrine::app
