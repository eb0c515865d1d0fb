#include "app/jobs/job_folder.h"

#include "app/queue/study_in_parts.h"
#include "app/study/study_folder.h"

namespace vitrine::app {
namespace {

std::unique_ptr<StudyParts> measuresIn(Parts& parts, bool isPart)
{
    return std::make_unique<StudyInParts>(parts, isPart);
}

}  // namespace

const JobFolder* folderOf(const jobs::Job& job)
{
    static const JobFolder study{requireStudyFolder, writeStudyFolder, tellStudy, measuresIn};
    return job.name() == "study" ? &study : nullptr;
}

}  // namespace vitrine::app
